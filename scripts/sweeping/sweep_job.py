# SPDX-License-Identifier: GPL-2.0-or-later
"""The jobs of a sweep: a run of the script for each point of the grid and each seed, and the commands that follow it in its folder."""
import contextlib
import dataclasses
import itertools
import json
import os
import re
import shlex

from sweeping.jobs import Job, call
from sweeping.refused import Refused, guess, refuse
from sweeping.script_text import read_script


@dataclasses.dataclass(frozen=True)
class SweepJob(Job):
    """`point`: values of the grid; `digest` of the script's content."""

    point: tuple = ()
    seed: object = None
    digest: str = ""
    commands: tuple = ()

    def record(self):
        return {**super().record(), "program": os.path.basename(self.program), "content": self.digest}

    def differs(self):
        """In what the run that is kept under this name differs; empty where there is none, or the same."""
        kept, own = self.kept_record(), self.record()
        if kept is None or kept == own:
            return ""
        before, now = kept.get("variables", {}), own["variables"]
        changed = [f"{name} was {before.get(name, 'not given')} and is {now.get(name, 'not given')}"
                   for name in {**before, **now} if before.get(name) != now.get(name)]
        return ", ".join(changed) or ("the script has changed since" if kept.get("script") == own["script"] else f"it was a run of {kept.get('script')}")

    def commands_done(self):
        try:
            with open(os.path.join(self.folder, "commands.json")) as file:
                return json.load(file) == list(self.commands)
        except (OSError, ValueError):
            return False

    def is_done(self):
        return super().is_done() and self.commands_done()

    def run(self, processes):
        if not super().is_done():
            super().run(processes)
        record = os.path.join(self.folder, "commands.json")
        with contextlib.suppress(FileNotFoundError):
            os.remove(record)
        for number, command in enumerate(self.commands, 1):
            call(["bash", "-e", "-o", "pipefail", "-c", command], os.path.join(self.folder, f"command_{number}.txt"), processes, cwd=self.folder, pass_fds=self.held)
        with open(record, "w") as file:
            json.dump(self.commands, file, indent=1)


def folder_name(values):
    """nu0.785_seed1: letters, digits and .+- of names and values."""
    return "_".join(re.sub(r"[^\w.+-]", "-", f"{name}{value}") for name, value in values)


def with_values(command, values):
    """{name} becomes the value of that variable, quoted for the shell; {{name}} becomes {name}."""
    def value(match):
        if match[1]:
            return match[1]
        name = match[2]
        if name not in values:
            refuse(f"commands: {{{name}}}", f"a variable of [variables] or [grid], or seed ({{{{{name}}}}} is {{{name}}} for the command)", guess(name, values))
        return shlex.quote(str(values[name]))
    return re.sub(r"\{(\{[A-Za-z_]\w*\})\}|(?<!\$)\{([A-Za-z_]\w*)\}", value, command)


def script_of(plan, values):
    """Its text; refuses variables that it does not use."""
    try:
        text = read_script(plan.script, {name: str(value) for name, value in values.items()})
    except OSError as error:
        refuse(f"script {plan.script}", "an input script", error.strerror)
    if text.unread:
        refuse(f"{plan.script} includes {text.unread[0]}", "a file (names of variables in it have to be given or to have a default)", "none")
    for name in (*values, "out"):
        if name not in text.variables:
            refuse(f"{plan.script} uses no variable {guess(name, text.variables)}",
                   "a variable out, the folder of all files" if name == "out" else "the name of one that it uses", "none")
    return text


def jobs_of(plan, program):
    """All jobs, the seeds of a point one after the other."""
    jobs = []
    for point in itertools.product(*plan.grid.values()):
        for seed in plan.seeds or (None,):
            own = tuple(zip(plan.grid, point)) + ((("seed", seed),) if plan.seeds else ())
            values = {**plan.variables, **dict(own)}
            jobs.append(SweepJob(folder_name(own), plan.script, tuple(values.items()), plan.out, program, plan.ranks, point=point, seed=seed,
                                 digest=script_of(plan, values).digest, commands=tuple(with_values(one, values) for one in plan.commands)))
    names = [one.name for one in jobs]
    for name in names:
        if names.count(name) > 1:
            raise Refused(f"values that are spelled alike: two jobs would get the folder {name}; expected values that differ in letters, digits and .+-")
    return jobs
