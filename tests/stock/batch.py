# SPDX-License-Identifier: GPL-2.0-or-later
"""Many scripts in few processes of an engine, each after a `clear`; what one of them dies of is its own outcome."""
import os
import re
import subprocess

MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_btl": "self,vader",
       "OMPI_MCA_odls_base_sigkill_timeout": "0", "OMPI_MCA_mpi_yield_when_idle": "1"}
MARK = "@@ script"


class Engine:
    """A program and its number of ranks; `folder` takes the files of its runs."""

    def __init__(self, name, program, ranks, folder, mpiexec="mpirun"):
        self.name, self.ranks, self.folder = name, ranks, folder
        self.command = ([mpiexec, "--bind-to", "none", "--map-by", ":OVERSUBSCRIBE", "-n", str(ranks)] if ranks > 1 else []) + [os.path.abspath(program)]

    def start(self, script, seconds):
        """Exit code and all that was said."""
        path = os.path.join(self.folder, "in.script")
        with open(path, "w") as file:
            file.write("\n".join(script) + "\n")
        try:
            done = subprocess.run([*self.command, "-in", path, "-log", "none"], cwd=self.folder, timeout=seconds,
                                  env={**os.environ, **MPI}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
        except subprocess.TimeoutExpired as late:
            return "hangs", (late.stdout or b"").decode(errors="replace")
        return done.returncode, done.stdout


class Outcome:
    def __init__(self, code, said):
        self.code, self.said = code, said

    def fault(self):
        """Empty where the script ran to its end."""
        if self.code == 0:
            return ""
        errors = [line for line in self.said.splitlines() if "ERROR" in line]
        return errors[0] if errors else f"no error line, exit code {self.code}"

    def warnings(self):
        return [line for line in self.said.splitlines() if "WARNING" in line]


def run(engine, scripts, seconds=600):
    """Outcomes by the names of the scripts, which are pairs of name and lines."""
    outcomes, waiting = {}, list(scripts)
    while waiting:
        lines = []
        for number, (_, script) in enumerate(waiting):
            lines += ["clear", f'print "{MARK} {number}"', *script]
        code, said = engine.start([*lines, f'print "{MARK} end"'], seconds)
        parts = re.split(rf"^{MARK} (\d+|end)$", said, flags=re.MULTILINE)
        begun = dict(zip(parts[1::2], parts[2::2]))
        count = len(begun) - ("end" in begun)
        if count == 0:
            raise RuntimeError(f"{engine.command}: no script began:\n{said}")
        for number in range(count):
            is_last = number == count - 1 and "end" not in begun
            outcomes[waiting[number][0]] = Outcome(code or "unknown" if is_last else 0, begun[str(number)])
        waiting = waiting[count:]
    return outcomes
