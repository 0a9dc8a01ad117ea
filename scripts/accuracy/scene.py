# SPDX-License-Identifier: GPL-2.0-or-later
"""The cell: positions from one saved state, and the macroscopic answer, against the time step."""
import dataclasses
import glob
import json
import os

import numpy as np

from accuracy import runs
from reproduction import profiles, sheet

TITLE = "The cell"
T_C = 2.1766e-3  # s, two small discs
COUETTE, CONTINUE = os.path.join("inputs", "couette", "in.couette"), os.path.join("scripts", "accuracy", "continue.in")
NAMES = {"v0": "$v_0/(\\Omega R_i)$", "s": "s (mm)", "pressure": "-tr $\\sigma$ (Pa)", "coordination": "coordination", "torque": "wheel torque (mN m)"}
PLAIN = {"v0": "v0/(Omega R_i)", "s": "s (mm)", "pressure": "-tr sigma (Pa)", "coordination": "coordination", "torque": "wheel torque (mN m)"}


@dataclasses.dataclass(frozen=True)
class Cell:
    """What is sheared, and for how long; times in s."""

    run: str
    outer: float
    rings: int
    discard_time: float
    measure_time: float
    seeds: tuple


SMALL = Cell("small", 0.1782, 20, 8, 30, tuple(range(1, 13)))
FULL = Cell("B", 0.2524, 60, 62.83, 60, (1, 2, 3, 4, 5))
cell = SMALL


def sheared(name, seed, **variables):
    """A run of the cell, and its averages, after which its snapshots are removed."""
    chosen = {"run": cell.run, "discard_time": cell.discard_time, "measure_time": cell.measure_time, "snap_time": 0.1, "snapshot": "on", "seed": seed, **variables}
    folder = runs.engine(f"{cell.run}_{name}_{seed}", COUETTE, **chosen)
    snapshots, rings = (os.path.join(folder, file) for file in ("run.h5", "rings.csv"))
    if not os.path.exists(rings):
        runs.mikromakro("average", snapshots, "--rings", str(profiles.R_I), str(cell.outer), str(cell.rings), "--height", str(profiles.HEIGHT),
                        "--bulk-types", "1", "2", "--quiet", "--out", rings)
        os.remove(snapshots)
    return folder


def answer(folder):
    """The macroscopic quantities of one run."""
    rings = os.path.join(folder, "rings.csv")
    fit = json.loads(runs.mikromakro("fit", rings, "--ri", str(profiles.R_I), "--omega", str(profiles.OMEGA), "--json"))
    with open(rings) as file:
        columns = profiles.table(file.read())
    inner = (columns["r"] > profiles.R_I + 0.008) & (columns["r"] < cell.outer - 0.008)
    wheel = np.loadtxt(os.path.join(folder, "wheel.txt"))
    late = wheel[:, 0] > wheel[-1, 0] * cell.discard_time / (cell.discard_time + cell.measure_time)
    pressure = -(columns["sigma_rr"] + columns["sigma_phiphi"])[inner]
    return {"v0": fit["v0_scaled"], "s": 1e3 * fit["s"], "pressure": pressure.mean(), "coordination": columns["coordination"][inner].mean(),
            "torque": -1e3 * wheel[late, 1].mean()}


def over_seeds(folders):
    """Mean and standard error of each quantity."""
    answers = [answer(folder) for folder in folders]
    return {key: (np.mean([one[key] for one in answers]), np.std([one[key] for one in answers], ddof=1) / np.sqrt(len(answers))) for key in NAMES}


def cost(folder):
    """Processor time of the run per simulated second."""
    return runs.seconds(folder) / (2.5 + cell.discard_time + cell.measure_time)


def packing(repetition=1):
    """A run of the small cell from the dilute start to rest, 2.5 s."""
    return runs.engine(f"packing_{repetition}", COUETTE, run="small", law="cundall_strack", discard_time=0, measure_time=0)


def add_cost(axes):
    """On top of an axis of t_c/dt: processor time per simulated second, from the median of five runs."""
    per_step = np.median([runs.seconds(packing(k)) for k in range(1, 6)]) / (2.5 / 4e-5)
    top = axes.secondary_xaxis("top", functions=(lambda steps: steps * per_step / T_C, lambda seconds: seconds * T_C / per_step))
    top.set_xlabel("processor s per simulated s, small cell", fontsize=8)


def positions(velocity, steps_per_contact):
    """Of all discs, frame after frame."""
    at_rest = os.path.join(packing(), "packing.restart")
    # The wheel's start is a jump of its own.
    turning = os.path.join(runs.engine("turning", CONTINUE, packing=at_rest, steps=250, frames=100, velocity="predicted"), "end.restart")
    steps = round(0.01 / T_C * steps_per_contact)
    folder = runs.engine(f"positions_{velocity}_{steps_per_contact}", CONTINUE, packing=turning, steps=steps, velocity=velocity)
    frames = sorted(glob.glob(os.path.join(folder, "positions_*.txt")), key=lambda path: int(path.split("_")[-1][:-4]))
    return np.array([np.loadtxt(frame, skiprows=9)[:, 1:] for frame in frames])


def draw_positions():
    steps = (10, 14, 20, 28, 40, 56, 80, 113, 160, 226, 320, 400)
    exact = positions("predicted", 800)
    drawing, (left, right) = sheet.axes(columns=2)
    kept, rms = {"steps_per_contact": np.array(steps)}, {}
    for velocity, marker, colour, name in (("half_step", "^", "k", "half-step velocities (stock)"), ("predicted", "o", "0.5", "ours")):
        errors = np.array([np.sqrt(np.mean(np.sum((positions(velocity, n) - exact) ** 2, axis=2), axis=1)) for n in steps])
        rms[velocity] = errors
        left.loglog(steps, errors[:, 5], marker + "-", color=colour, ms=4, label=f"{name}, 0.05 s")
        left.loglog(steps, errors[:, 20], marker + ":", color=colour, ms=4, mfc="w", label=f"{name}, 0.2 s")
        for k in (2, 5, 9):
            right.semilogy(0.01 * np.arange(1, 21), errors[k, 1:], marker + "-", color=sheet.shades(12)[k], ms=3, label=f"{name}, $t_c$/{steps[k]}")
        kept |= {f"{velocity}_0.05s_m": errors[:, 5], f"{velocity}_0.2s_m": errors[:, 20]}
    moved = np.sqrt(np.mean(np.sum((exact - exact[0]) ** 2, axis=2), axis=1))
    right.semilogy(0.01 * np.arange(1, 21), moved[1:], "k--", lw=0.8, label="way of the discs")
    left.set(xlabel="$t_c/\\Delta t$", ylabel="rms error of positions (m)")
    add_cost(left)
    right.set(xlabel="time since then (s)", ylabel="rms error of positions (m)")
    for one in (left, right):
        one.legend(fontsize=6)
    sheet.save_picture(drawing, "accuracy_positions")
    sheet.save_numbers("accuracy_positions", kept, ["rms over the free discs of the small cell, law with spring, against t_c/800"])
    return np.array(steps), rms, moved


STEPS = (8, 10, 15, 20, 30, 54)


def frame(mean, error):
    """Limits of a diagram that shows all but the coarsest step, which may be far off."""
    low, high = np.min((mean - error)[1:]), np.max((mean + error)[1:])
    return low - 0.1 * (high - low), high + 0.1 * (high - low)


def draw_answers():
    drawing, sheets = sheet.axes(columns=3, rows=2, width=3.6, height=3)
    folders = {n: [] for n in STEPS}
    for seed in cell.seeds:
        for n in STEPS:
            folders[n].append(sheared(f"dt{n}", seed, dt=f"{T_C / n:.6g}"))
    found = {n: over_seeds(folders[n]) for n in STEPS}
    costs = {n: np.array([cost(folder) for folder in folders[n]]) for n in STEPS}
    kept = {"steps_per_contact": np.array(STEPS), "processor_s_per_s": np.array([np.median(costs[n]) for n in STEPS])}
    for one, (key, name) in zip(sheets.flat, NAMES.items()):
        mean, error = np.array([found[n][key] for n in STEPS]).T
        one.errorbar(STEPS, mean, error, fmt="o", color="k", ms=4, lw=0.8)
        one.axhspan(0.99 * mean[-1], 1.01 * mean[-1], color="0.85")
        one.set(xlabel="$t_c/\\Delta t$", ylabel=name, xscale="log", ylim=frame(mean, error))
        if not one.get_ylim()[0] < mean[0] < one.get_ylim()[1]:
            one.set_title(f"beyond the frame: {mean[0]:.3g} at $t_c$/{STEPS[0]}", fontsize=8)
        kept |= {key: mean, key + "_err": error}
    sheets.flat[5].loglog(STEPS, [np.median(costs[n]) for n in STEPS], "ko-", ms=4)
    sheets.flat[5].set(xlabel="$t_c/\\Delta t$", ylabel="processor s per simulated s")
    for one in sheets.flat:
        one.set_xticks(STEPS, [str(n) for n in STEPS])
        one.minorticks_off()
    sheets.flat[5].set_yticks(ticks := (0.2, 0.3, 0.4, 0.5, 0.6, 0.7), [str(tick) for tick in ticks])
    sheet.save_picture(drawing, "accuracy_answers", 90)
    sheet.save_numbers("accuracy_answers", kept, [f"{cell.run}, Eq. 1, seeds {cell.seeds}: means and standard errors; {cell.measure_time} s after "
                                                  f"{cell.discard_time} s of shear"])
    return found, costs


def changes(found):
    """Of the coarsest steps on: the differences from the finest in units of their error, and in per cent."""
    finest = found[STEPS[-1]]
    yield "| t_c/dt | " + " | ".join(PLAIN.values()) + " |"
    yield "| --- " * (len(PLAIN) + 1) + "|"
    for n in STEPS:
        cells = []
        for key in PLAIN:
            (mean, error), (fine, fine_error) = found[n][key], finest[key]
            change = f" ({100 * (mean / fine - 1):+.1f} %, {abs(mean - fine) / np.hypot(error, fine_error):.1f} errors)" if n != STEPS[-1] else ""
            cells.append(f"{mean:.4g} ± {error:.2g}{change}")
        yield f"| {n} | " + " | ".join(cells) + " |"


def of_seeds(count):
    """What a number of standard errors of a difference means: Student's t with 2 (n - 1) degrees of freedom, 95 %."""
    student = {8: 2.31, 14: 2.14, 22: 2.07}
    return f"{student[2 * (count - 1)]:.1f} of them give a 95 % interval, Student's t for two means of {count} seeds"


def verdicts(found):
    """Of each quantity: at which steps it differs from the finest by more than two standard errors, and what the others leave open."""
    for key, name in PLAIN.items():
        fine, fine_error = found[STEPS[-1]][key]
        change = {n: (100 * (found[n][key][0] / fine - 1), 100 * np.hypot(found[n][key][1], fine_error) / abs(fine)) for n in STEPS[:-1]}
        differs = [f"t_c/{n}" for n, (by, error) in change.items() if abs(by) > 2 * error]
        others = [f"t_c/{n} {by:+.1f} ± {error:.1f} %" for n, (by, error) in change.items() if abs(by) <= 2 * error]
        yield f"- {name}: differs by more than two standard errors at {', '.join(differs) or 'none of these'}; at {', '.join(others) or 'no other'}."


def section():
    steps, rms, moved = draw_positions()
    yield "![error of positions](accuracy_positions.png)"
    yield ""
    at = int(np.flatnonzero(steps == 56)[0])
    yield (f"The small cell (1131 discs, law with spring) from one saved state, after 1 s of shear, compared with the same run at t_c/800 "
           f"(`scripts/accuracy/continue.in`, "
           f"[accuracy_positions.csv](accuracy_positions.csv)). After 0.05 s, in which the discs have moved by {moved[5]:.1e} m (rms), positions are "
           f"off by {rms['predicted'][at][5]:.1e} m at t_c/56, "
           f"and by {rms['half_step'][at][5]:.1e} m with half-step velocities. Both are of order 1, since contacts open and close all the time. In an "
           f"engine whose dashpots were weighted by the fraction of the step in contact, the error was of order 2 here too: 5.1e-08 m at t_c/56, 9.8e-10 m at t_c/400. "
           f"Trajectories diverge soon after.")
    found, costs = draw_answers()
    yield ""
    yield "![macroscopic answer](accuracy_answers.png)"
    yield ""
    yield (f"Once trajectories have lost their memory, only means are meaningful. Cell `{cell.run}`, Eq. 1, {cell.measure_time} s of shear after {cell.discard_time} "
           f"s; means and standard errors of {len(cell.seeds)} seeds, "
           f"in brackets the difference from t_c/{STEPS[-1]}, in per cent and in units of its standard error ({of_seeds(len(cell.seeds))}; "
           f"of {(len(STEPS) - 1) * len(PLAIN)} comparisons {'one lies' if round(0.05 * (len(STEPS) - 1) * len(PLAIN)) == 1 else 'some lie'} outside by chance). Grey: 1 % about t_c/{STEPS[-1]}. "
           f"Numbers: [accuracy_answers.csv](accuracy_answers.csv).")
    yield ""
    yield from changes(found)
    yield ""
    yield from verdicts(found)
    yield ""
    yield ("At t_c/8 the packing does not come to rest: explicitly integrated dashpots of discs with many contacts heat it.")
    yield ""
    yield "Processor time per simulated second: " + ", ".join(
        f"{np.median(costs[n]):.2f} s ({costs[n].min():.2f} to {costs[n].max():.2f}) at t_c/{n}" for n in STEPS) + "; medians over the seeds, which were run in alternation."
