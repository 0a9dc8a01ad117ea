# SPDX-License-Identifier: GPL-2.0-or-later
"""The simulations behind the figures: each is run once and kept in out/reproduce/<name>/."""
import concurrent.futures
import dataclasses
import glob
import json
import os
import shutil
import subprocess
import sys
import threading
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
KEPT = os.path.join("out", "reproduce")


@dataclasses.dataclass(frozen=True)
class Simulation:
    """A run of an input script with some of its variables set; `time_step` in s, `work` its length beside that of others."""

    name: str
    script: str
    variables: tuple
    time_step: float
    work: float

    @property
    def folder(self):
        return os.path.join(KEPT, self.name)

    @property
    def snapshots(self):
        return os.path.join(self.folder, "snapshots.h5")

    def command(self, folder):
        words = [os.path.join("build", "bin", "liggghts-disc"), "-in", self.script, "-log", "none", "-screen", "none"]
        for name, value in (*self.variables, ("out", folder)):
            words += ["-var", name, str(value)]
        return words

    def is_done(self):
        try:
            with open(os.path.join(self.folder, "done.json")) as file:
                return json.load(file) == self.record()
        except (OSError, ValueError):
            return False

    def record(self):
        return {"script": self.script, "variables": {name: str(value) for name, value in self.variables}}

    def run(self, started):
        """Runs it in a folder of its own, which takes its final name when all is there. A run that was killed begins anew."""
        partial = self.folder + ".partial"
        shutil.rmtree(partial, ignore_errors=True)
        os.makedirs(partial)
        with open(os.path.join(partial, "screen.txt"), "w") as screen:
            engine = subprocess.Popen(self.command(partial), stdout=screen, stderr=screen, stdin=subprocess.DEVNULL)
            started(engine)
            if engine.wait() != 0:
                sys.exit(f"reproduce: {' '.join(self.command(partial))} failed, see {partial}/screen.txt")
        if glob.glob(os.path.join(partial, "particles_*.txt")):
            self.pack(partial)
        with open(os.path.join(partial, "done.json"), "w") as file:
            json.dump(self.record(), file, indent=1)
        shutil.rmtree(self.folder, ignore_errors=True)
        os.rename(partial, self.folder)

    def pack(self, folder):
        """Text dumps into one HDF5 file."""
        dumps = {kind: os.path.join(folder, f"{kind}_*.txt") for kind in ("particles", "contacts")}
        subprocess.run([os.path.join("build", "bin", "mikromakro"), "convert", "--particles", dumps["particles"], "--contacts",
                        dumps["contacts"], "--timestep", str(self.time_step), "--quiet", "--out", os.path.join(folder, "snapshots.h5")],
                       check=True)
        for pattern in dumps.values():
            for file in glob.glob(pattern):
                os.remove(file)

    def share_done(self):
        """Of a run under way, by the last step in wheel.txt; 0 where there is none."""
        try:
            with open(os.path.join(self.folder + ".partial", "wheel.txt"), "rb") as file:
                file.seek(-min(1000, os.fstat(file.fileno()).st_size), os.SEEK_END)
                return float(file.read().split(b"\n")[-2].split()[0]) / self.work
        except (OSError, IndexError, ValueError):
            return 0.0


class Progress:
    """A bar with the remaining time on a terminal, one line for each simulation elsewhere."""

    def __init__(self, simulations):
        self.waiting = list(simulations)
        self.work = sum(one.work for one in simulations)
        self.running, self.done, self.began = [], 0.0, time.monotonic()
        self.lock = threading.Lock()

    def start(self, one):
        with self.lock:
            self.running.append(one)

    def end(self, one):
        with self.lock:
            self.running.remove(one)
            self.waiting.remove(one)
            self.done += one.work
        print(f"\r{one.name}: done, {len(self.waiting)} to go{self.remaining()}", file=sys.stderr)

    def remaining(self):
        with self.lock:
            share = (self.done + sum(one.share_done() * one.work for one in self.running)) / self.work
        passed = time.monotonic() - self.began
        return f", about {passed * (1 / share - 1) / 60:.0f} min" if share > 0.01 else ""

    def show(self):
        names = ", ".join(f"{one.name} {one.share_done():.0%}" for one in self.running)
        print(f"\r{names}{self.remaining()}\033[K", end="", file=sys.stderr)


def make_sure(simulations, jobs):
    """Runs those that are not there yet, `jobs` at a time."""
    missing = [one for one in dict.fromkeys(simulations) if not one.is_done()]
    if not missing:
        return
    progress = Progress(missing)
    engines = []

    def run(one):
        progress.start(one)
        one.run(engines.append)
        progress.end(one)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        futures = [pool.submit(run, one) for one in missing]
        try:
            while not all(future.done() for future in futures):
                time.sleep(1)
                if sys.stderr.isatty():
                    progress.show()
            for future in futures:
                future.result()
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            for engine in engines:
                engine.terminate()
            raise


def couette(small, large, law, seed=1, **others):
    """A run of the full protocol: dilute start, compaction, one turn discarded, 60 s with snapshots."""
    variables = {"run": "A", "n_small": small, "n_large": large, "law": law, "seed": seed, **others}
    more = "".join(f"_{name}{value}" for name, value in others.items())
    time_step = 4.0e-5
    return Simulation(f"couette_{small}+{large}_{law}_seed{seed}{more}", os.path.join("inputs", "couette", "in.couette"),
                      tuple(variables.items()), time_step, sum(couette_times(variables).values()) / time_step)


def couette_times(variables):
    """How long the parts of a run of the shear cell last (s), in their order."""
    defaults = {"compact_time": 2.0, "relax_time": 0.5, "discard_time": 62.83, "measure_time": 60.0}
    return {name: float(variables.get(name, default)) for name, default in defaults.items()}


def isotropic(sizes, a_small, a_large, pressure=200, mu=0.5, discs=600, seed=1):
    """Discs of two radii or of all between them (m), compressed by a pressure (N/m) until they rest."""
    variables = {"n": discs, "sizes": sizes, "a_small": a_small, "a_large": a_large, "p": pressure, "mu": mu, "seed": seed}
    name = f"isotropic_{sizes}_{1e3 * a_small:g}_{1e3 * a_large:g}_p{pressure}_mu{mu}_n{discs}_seed{seed}"
    # A step of 600 discs costs a sixth of one of the shear cell.
    return Simulation(name, os.path.join("inputs", "biaxial", "in.bidisperse"), tuple(variables.items()), 1.7e-7, 0.4 / 1.7e-7 / 6)


def biaxial(seed=1, **others):
    """The biaxial test: isotropic compression, then shear between four walls."""
    variables = {"seed": seed, **others}
    more = "".join(f"_{name}{value}" for name, value in others.items())
    seconds = 0.12 + float(others.get("shear_time", 0.5))
    # A step of 1950 discs costs as much as one of the shear cell.
    return Simulation(f"biaxial_seed{seed}{more}", os.path.join("inputs", "biaxial", "in.biaxial"), tuple(variables.items()), 1.7e-7, seconds / 1.7e-7)
