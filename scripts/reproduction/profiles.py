# SPDX-License-Identifier: GPL-2.0-or-later
"""Profiles of a simulation over rings, from mikromakro, kept beside its snapshots."""
import csv
import io
import json
import os
import subprocess

import numpy as np

from reproduction.simulations import couette_times

MIKROMAKRO = os.path.join("build", "bin", "mikromakro")
R_I, R_O, HEIGHT, OMEGA, K_N, MU = 0.1032, 0.2524, 0.006, 0.1, 352.1, 0.44
# The mean diameter of the mixture of run B (m), for distances as the paper's Bild 12 gives them.
DIAMETER = 2 * (2545 * 0.00371 + 394 * 0.004495) / (2545 + 394)


def run(*arguments):
    return subprocess.run([MIKROMAKRO, *arguments], check=True, capture_output=True, text=True).stdout


def cached(path, make):
    """The text at `path`, which `make` gives where it is not there yet."""
    if not os.path.exists(path):
        text = make()
        with open(path + ".partial", "w") as file:
            file.write(text)
        os.replace(path + ".partial", path)
    with open(path) as file:
        return file.read()


def table(text):
    """Columns of a CSV of mikromakro by name."""
    rows = list(csv.reader(line for line in io.StringIO(text) if not line.startswith("#")))
    values = np.array(rows[1:], dtype=float)
    return {name: values[:, k] for k, name in enumerate(rows[0])}


def rings_file(simulation, count, weight="sliced", frames=""):
    return os.path.join(simulation.folder, f"rings_{count}_{weight.replace(':', '_')}{frames.replace(':', '_')}.csv")


def rings(simulation, count, weight="sliced", frames=""):
    """All fields over `count` rings between the wheel and the outer ring, with standard errors; `frames`: FIRST:LAST of them only."""
    path = rings_file(simulation, count, weight, frames)
    return table(cached(path, lambda: run("average", simulation.snapshots, "--rings", str(R_I), str(R_O), str(count), "--height",
                                          str(HEIGHT), "--bulk-types", "1", "2", "--kn", str(K_N), "--mu", str(MU), "--fields", "all",
                                          "--weight", weight, *(["--frames", frames] if frames else []), "--quiet")))


def box(simulation):
    """All fields of a sample between four walls, over the whole of it."""
    with open(os.path.join(simulation.folder, "log.liggghts")) as log:
        walls = [line for line in log if line.startswith("walls at 0, ") and "$" not in line][-1].split()
    right, top = walls[3], walls[6]
    right = right.rstrip(",")
    path = os.path.join(simulation.folder, "box.csv")
    return table(cached(path, lambda: run("average", simulation.snapshots, "--box", "0", right, "0", top, "--weight", "centre", "--branch",
                                          "radius", "--fields", "all", "--kn", "1e5", "--histogram", "36", "--quiet")))


# Count of the rings and weight: tables whose fits are choices beside that of 60 rings. The paper's is of 20 rings by centres.
CHOICES = ((20, "sliced"), (30, "sliced"), (20, "centre"))
# A profile that does not decay, as in a frozen packing.
NO_FIT = {name: float("nan") for name in ("v0", "s", "v0_scaled", "v0_scaled_low", "v0_scaled_high")} | {"choices": {}}


def velocity_file(simulation, count, weight="sliced", frames=""):
    """The velocity over rings, in a file with its blocks of frames (`blocks_of`) beside it."""
    path = rings_file(simulation, count, weight, frames).replace("rings_", "velocity_")
    if not os.path.exists(path) or not os.path.exists(blocks_of(path)):
        run("average", simulation.snapshots, "--rings", str(R_I), str(R_O), str(count), "--bulk-types", "1", "2", "--fields", "velocity",
            "--weight", weight, *(["--frames", frames] if frames else []), "--quiet", "--out", path, "--blocks", blocks_of(path))
    return path


def blocks_of(path):
    return path.replace("velocity_", "blocks_")


def fit(simulation, count, omega=OMEGA, **average):
    """The exponential v_0 exp(-(r - R_i)/s) of v_phi (Bild 5): its standard errors and intervals of 95 % from blocks of frames (None where there are too
    few), and its least and greatest values by other choices of range, weights and rings. Of a profile that does not decay, as in a frozen packing, nan."""
    rows = velocity_file(simulation, count, **average)
    path = rows.replace("velocity_", "fit_").replace(".csv", "_choices.json")
    others = [velocity_file(simulation, *choice, frames=average.get("frames", "")) for choice in CHOICES]

    def made():
        try:
            return run("fit", rows, *(one for one in others if one != rows), "--blocks", blocks_of(rows), "--ri", str(R_I), "--omega", str(omega), "--json")
        except subprocess.CalledProcessError as error:
            if "the profile does not decay" not in error.stderr:
                raise
            return json.dumps(NO_FIT)

    return json.loads(cached(path, made))


def wheel(simulation):
    """wheel.txt since the first snapshot: step, torques (N m), pressures (Pa), angle, power, kinetic energy."""
    rows = np.loadtxt(os.path.join(simulation.folder, "wheel.txt"))
    times = couette_times(dict(simulation.variables))
    return rows[rows[:, 0] * simulation.time_step > sum(times.values()) - times["measure_time"]]


def mean_and_error(values, blocks=10):
    """Mean of a correlated series and its standard error from blocks."""
    means = [block.mean() for block in np.array_split(values, blocks)]
    return np.mean(values), np.std(means, ddof=1) / np.sqrt(blocks)


def solid_fractions(simulation):
    """Of the free discs, and with the halves of the wall discs that lie in the annulus, as the script prints them."""
    with open(os.path.join(simulation.folder, "log.liggghts")) as log:
        for line in log:
            if line.startswith("solid fraction at R_o: free discs 0"):
                words = line.replace(",", "").split()
                return float(words[words.index("discs") + 1]), float(words[-1])
    raise ValueError(f"{simulation.folder}: no solid fraction in the log")


def from_wheel(columns):
    """Distance from the circle of the wheel, mm."""
    return 1e3 * (columns["r"] - R_I)


def middles_of_layers(columns, count):
    """Numbers of the rings nearest to the middles of the first layers of small discs at the wheel."""
    return np.interp(np.arange(count) + 0.5, from_wheel(columns) / 7.42, np.arange(len(columns["r"]))).round().astype(int)
