# SPDX-License-Identifier: GPL-2.0-or-later
"""The simulations behind the figures: each is run once and kept in out/reproduce/<name>/."""
import dataclasses
import glob
import os
import subprocess

from sweeping.jobs import Job

KEPT = os.path.join("out", "reproduce")


@dataclasses.dataclass(frozen=True)
class Simulation(Job):
    """A run that ends with snapshots in one HDF5 file; `time_step` in s."""

    time_step: float = 0.0

    @property
    def snapshots(self):
        return os.path.join(self.folder, "snapshots.h5")

    def complete(self, folder):
        """Text dumps into one HDF5 file."""
        dumps = {kind: os.path.join(folder, f"{kind}_*.txt") for kind in ("particles", "contacts")}
        if not glob.glob(dumps["particles"]):
            return
        subprocess.run([os.path.join("build", "bin", "mikromakro"), "convert", "--particles", dumps["particles"], "--contacts",
                        dumps["contacts"], "--timestep", str(self.time_step), "--quiet", "--out", os.path.join(folder, "snapshots.h5")],
                       check=True)
        for pattern in dumps.values():
            for file in glob.glob(pattern):
                os.remove(file)

    def share_done(self):
        """By the last step in wheel.txt; 0 where there is none."""
        try:
            with open(os.path.join(self.partial, "wheel.txt"), "rb") as file:
                file.seek(-min(1000, os.fstat(file.fileno()).st_size), os.SEEK_END)
                return float(file.read().split(b"\n")[-2].split()[0]) / self.work
        except (OSError, IndexError, ValueError):
            return 0.0


def simulation(name, script, variables, time_step, work):
    return Simulation(name, os.path.join("inputs", *script), tuple(variables.items()), KEPT, work=work, time_step=time_step)


def couette(small, large, law, seed=1, **others):
    """A run of the full protocol: dilute start, compaction, one turn discarded, 60 s with snapshots."""
    variables = {"run": "A", "n_small": small, "n_large": large, "law": law, "seed": seed, **others}
    more = "".join(f"_{name}{value}" for name, value in others.items())
    time_step = 4.0e-5
    return simulation(f"couette_{small}+{large}_{law}_seed{seed}{more}", ("couette", "in.couette"), variables, time_step,
                      sum(couette_times(variables).values()) / time_step)


def couette_times(variables):
    """How long the parts of a run of the shear cell last (s), in their order."""
    defaults = {"compact_time": 2.0, "relax_time": 0.5, "discard_time": 62.83, "measure_time": 60.0}
    return {name: float(variables.get(name, default)) for name, default in defaults.items()}


def isotropic(sizes, a_small, a_large, pressure=200, mu=0.5, discs=600, seed=1):
    """Discs of two radii or of all between them (m), compressed by a pressure (N/m) until they rest."""
    variables = {"n": discs, "sizes": sizes, "a_small": a_small, "a_large": a_large, "p": pressure, "mu": mu, "seed": seed}
    name = f"isotropic_{sizes}_{1e3 * a_small:g}_{1e3 * a_large:g}_p{pressure}_mu{mu}_n{discs}_seed{seed}"
    # A step of 600 discs costs a sixth of one of the shear cell.
    return simulation(name, ("biaxial", "in.bidisperse"), variables, 1.7e-7, 0.4 / 1.7e-7 / 6)


def biaxial(seed=1, **others):
    """The biaxial test: isotropic compression, then shear between four walls."""
    variables = {"seed": seed, **others}
    more = "".join(f"_{name}{value}" for name, value in others.items())
    seconds = 0.12 + float(others.get("shear_time", 0.5))
    # A step of 1950 discs costs as much as one of the shear cell.
    return simulation(f"biaxial_seed{seed}{more}", ("biaxial", "in.biaxial"), variables, 1.7e-7, seconds / 1.7e-7)
