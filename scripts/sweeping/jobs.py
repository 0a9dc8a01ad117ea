# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs of input scripts, several at a time: each is run once and kept in a folder of its own."""
import concurrent.futures
import dataclasses
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import threading
import time

# With more than one rank: ranks of several runs are not bound to the same cores.
MPIRUN = ("mpirun", "--bind-to", "none", "--map-by", ":OVERSUBSCRIBE", "-n")


@dataclasses.dataclass(frozen=True)
class Job:
    """A run of an input script with some of its variables set, kept in the folder `name` of `kept`; `work` is its length beside that of others; `held` are
    open files that it inherits."""

    name: str
    script: str
    variables: tuple
    kept: str
    program: str = os.path.join("build", "bin", "liggghts-disc")
    ranks: int = 1
    work: float = 1.0
    held: tuple = ()

    @property
    def folder(self):
        return os.path.join(self.kept, self.name)

    @property
    def partial(self):
        return self.folder + ".partial"

    def command(self, folder):
        words = [*(MPIRUN + (str(self.ranks),) if self.ranks > 1 else ()), self.program, "-in", self.script, "-log", "none"]
        for name, value in (*self.variables, ("out", folder)):
            words += ["-var", name, str(value)]
        return words

    def record(self):
        """What the run is recognised by."""
        return {"script": self.script, "variables": {name: str(value) for name, value in self.variables}}

    def kept_record(self):
        """That of the run in the folder; None where there is no finished one."""
        try:
            with open(os.path.join(self.folder, "done.json")) as file:
                return json.load(file)
        except (OSError, ValueError):
            return None

    def is_done(self):
        return self.kept_record() == self.record()

    def run(self, processes):
        """Runs it in a folder of its own, which takes its final name when all is there. A run that was killed begins anew."""
        shutil.rmtree(self.partial, ignore_errors=True)
        os.makedirs(self.partial)
        call(self.command(self.partial), os.path.join(self.partial, "screen.txt"), processes, pass_fds=self.held)
        self.complete(self.partial)
        with open(os.path.join(self.partial, "done.json"), "w") as file:
            json.dump(self.record(), file, indent=1)
        shutil.rmtree(self.folder, ignore_errors=True)
        os.rename(self.partial, self.folder)

    def complete(self, folder):
        """What is done in the folder of a run that has ended."""

    def share_done(self):
        """Of a run under way."""
        return 0.0


class Failed(Exception):
    """A run that ended with an error."""


class Processes:
    """Commands under way. After stop() none begins, and none counts as done: engines end in good order when they are asked to."""

    def __init__(self):
        self.running, self.stopped = [], False

    def stop(self):
        self.stopped = True
        for process, way in self.running:
            process.send_signal(way)


def call(command, screen, processes, **options):
    """Runs a command with its output in the file `screen`. It is killed with this process, and does not begin where that is dead already; mpirun is asked to
    end, for it has to end its ranks."""
    way = signal.SIGTERM if command[0] == "mpirun" else signal.SIGKILL
    tied = ["setpriv", "--pdeathsig", way.name[3:], "--", "sh", "-c", '[ "$PPID" = "$0" ] || exit 1; exec "$@"', str(os.getpid())]
    with open(screen, "w") as file:
        process = subprocess.Popen([*tied, *command], stdout=file, stderr=file, stdin=subprocess.DEVNULL, **options)
        processes.running.append((process, way))
        if processes.stopped:
            process.send_signal(way)
        if process.wait() != 0 or processes.stopped:
            raise Failed(f"{' '.join(command)} failed: {last_words(screen)}; all it said is in {screen}")


def last_words(path):
    """The first line with an error, or the last one."""
    with open(path, errors="replace") as file:
        lines = [line.strip() for line in file if line.strip()] or ["it said nothing"]
    return next((line for line in lines if "ERROR" in line or line.startswith("mikromakro: ")), lines[-1])


class Progress:
    """A bar with the remaining time on a terminal, one line for each run elsewhere."""

    def __init__(self, jobs):
        self.waiting = list(jobs)
        self.work = sum(one.work for one in jobs)
        self.running, self.done, self.began = [], 0.0, time.monotonic()
        self.lock = threading.Lock()

    def start(self, one):
        with self.lock:
            self.running.append(one)

    def end(self, one, how):
        with self.lock:
            self.running.remove(one)
            self.waiting.remove(one)
            self.done += one.work
            left = len(self.waiting)
        print(f"\r{one.name}: {how}, {left} to go{self.remaining()}", file=sys.stderr, flush=True)

    def remaining(self):
        with self.lock:
            share = (self.done + sum(one.share_done() * one.work for one in self.running)) / self.work
        passed = time.monotonic() - self.began
        return f", about {math.ceil(passed * (1 / share - 1) / 60)} min" if 0.01 < share < 1 else ""

    def show(self):
        names = ", ".join(f"{one.name} {one.share_done():.0%}" for one in self.running)
        print(f"\r{names}{self.remaining()}\033[K", end="", file=sys.stderr)


def make_sure(jobs, at_a_time):
    """Runs those that are not there yet; the errors of those that failed. The others go on."""
    missing = [one for one in dict.fromkeys(jobs) if not one.is_done()]
    if not missing:
        return []
    progress = Progress(missing)
    processes = Processes()

    def run(one):
        progress.start(one)
        try:
            one.run(processes)
        except BaseException:
            progress.end(one, "failed")
            raise
        progress.end(one, "done")

    with concurrent.futures.ThreadPoolExecutor(at_a_time) as pool:
        futures = [pool.submit(run, one) for one in missing]
        try:
            while not all(future.done() for future in futures):
                time.sleep(0.2)
                if sys.stderr.isatty():
                    progress.show()
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            processes.stop()
            raise
    return [future.exception() for future in futures if future.exception()]
