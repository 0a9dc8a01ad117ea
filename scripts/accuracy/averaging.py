# SPDX-License-Identifier: GPL-2.0-or-later
"""Averages by several weights, rings and numbers of frames, against the best one; 32 bits against 64."""
import os
import shutil

import h5py
import numpy as np

from accuracy import runs, scene
from reproduction import profiles, sheet

TITLE = "Averages"
WEIGHTS = ("sliced", "centre", "gauss:0.002", "gauss:0.004", "lucy:0.008")
# Numbers of frames divide 1000, so that all of them span the same time.
RINGS, FRAMES, REPETITIONS = (10, 20, 60, 150), (1, 4, 10, 40, 100, 250, 500), 5
COLUMNS = {"nu": "nu", "v_phi": "v_phi", "pressure": "-tr sigma"}


def snapshots():
    """1000 snapshots of the small cell within 30 s, law with spring."""
    folder = runs.engine("snapshots", scene.COUETTE, run="small", law="cundall_strack", discard_time=8, measure_time=30, snap_time=0.03, snapshot="on")
    return os.path.join(folder, "run.h5")


def average(file, weight, rings, frames):
    """Columns of an average over so many frames, evenly spread, and the processor time that it took (s)."""
    out = os.path.join(runs.KEPT, "average.csv")
    step = (total_frames(file) - 1) // frames
    command = [runs.MIKROMAKRO, "average", file, "--rings", str(profiles.R_I), "0.1782", str(rings), "--height", str(profiles.HEIGHT),
               "--bulk-types", "1", "2", "--weight", weight, "--frames", f"1:{step * frames}:{step}", "--fields",
               "solid_fraction,velocity,stress", "--error-blocks", "0", "--threads", "1", "--quiet", "--out", out]
    seconds = runs.timed(command, os.path.join(runs.KEPT, "average.txt"))
    with open(out) as text:
        columns = profiles.table(text.read())
    columns["pressure"] = -(columns["sigma_rr"] + columns["sigma_phiphi"])
    return columns, seconds


def total_frames(file):
    with h5py.File(file, "r") as opened:
        return len(opened["particles/discs/position/step"])


def rounded(file):
    """The same snapshots, every number rounded to 32 bits."""
    copy = os.path.join(runs.KEPT, "rounded.h5")
    shutil.copy(file, copy)

    def cut(_, node):
        if isinstance(node, h5py.Dataset) and node.dtype == np.float64 and node.size > 1:
            node[...] = node[...].astype(np.float32).astype(np.float64)

    with h5py.File(copy, "r+") as opened:
        opened["particles"].visititems(cut)
        opened["contacts"].visititems(cut)
    return copy


def off(columns, best, name):
    """Rms over the rings, over the rms of the best."""
    both = np.isfinite(columns[name]) & np.isfinite(best[name])
    return np.sqrt(np.mean((columns[name][both] - best[name][both]) ** 2) / np.mean(best[name][both] ** 2))


def over_frames(file, best):
    """Error of a column over the number of frames, and time per frame of each weight on 60 rings, in turn."""
    errors = {name: [off(average(file, "sliced", 60, count)[0], best[60], name) for count in FRAMES] for name in COLUMNS}
    times = {(weight, rings): [] for weight in WEIGHTS for rings in RINGS}
    for _ in range(REPETITIONS):
        for weight, rings in times:
            times[weight, rings].append(1e3 * average(file, weight, rings, 50)[1] / 50)
    return errors, times


def draw(errors, by_weight, times):
    drawing, (left, right) = sheet.axes(columns=2)
    for (name, label), marker, colour in zip(COLUMNS.items(), "osD", sheet.shades(3)):
        left.loglog(FRAMES, errors[name], marker + "-", color=colour, ms=4, label=label)
    left.loglog([1, 500], [0.3, 0.3 / 500**0.5], "k--", lw=0.8, label="1/$\\sqrt{frames}$")
    left.set(xlabel="frames", ylabel="rms difference from all frames", title="60 rings, sliced")
    left.legend()
    for weight, marker, colour in zip(WEIGHTS, sheet.MARKERS, sheet.shades(len(WEIGHTS))):
        for rings, size in zip(RINGS, (3, 5, 7, 9)):
            label = weight if rings == 60 else None
            # Sliced differs from itself by nothing, which a logarithm does not show.
            right.loglog(np.median(times[weight, rings]), max(by_weight[weight, rings]["v_phi"], 1e-4), marker, color=colour, ms=size, label=label)
    right.set(xlabel="processor ms per frame", ylabel="rms difference of $v_\\phi$ from sliced", title="10, 20, 60, 150 rings: larger symbols")
    right.legend(fontsize=7)
    sheet.save_picture(drawing, "accuracy_averaging")


def section():
    file = snapshots()
    frames = total_frames(file) - 1
    best = {rings: average(file, "sliced", rings, frames)[0] for rings in RINGS}
    by_weight = {}
    for weight in WEIGHTS:
        for rings in RINGS:
            columns = average(file, weight, rings, frames)[0]
            by_weight[weight, rings] = {name: off(columns, best[rings], name) for name in COLUMNS}
    errors, times = over_frames(file, best)
    copy = rounded(file)
    single = {name: off(average(copy, "sliced", 150, frames)[0], best[150], name) for name in COLUMNS}
    os.remove(copy)
    draw(errors, by_weight, times)
    kept = {"weight": [weight for weight, _ in times], "rings": [rings for _, rings in times],
            **{f"off_{name}": [by_weight[key][name] for key in times] for name in COLUMNS},
            "ms_per_frame": [np.median(times[key]) for key in times], "ms_least": [min(times[key]) for key in times],
            "ms_most": [max(times[key]) for key in times]}
    sheet.save_numbers("accuracy_averaging", kept, [
        f"rms difference from sliced of the same rings and frames ({frames}), over its rms; processor time of 50 frames, {REPETITIONS} repetitions in turn"])
    yield "![averages](accuracy_averaging.png)"
    yield ""
    yield (f"{frames} snapshots of the small cell within 30 s, law with spring; rms difference over the rings from the sliced average of all frames "
           f"on the same rings, divided by its rms. Times: reading and averaging of solid fraction, velocity "
           f"and stress, one thread, median of {REPETITIONS} alternating repetitions. Numbers: [accuracy_averaging.csv](accuracy_averaging.csv).")
    yield ""
    yield "| weight | ms per frame, 60 rings (least to most) | " + " | ".join(f"{label}, {rings} rings" for rings in (20, 150) for label in COLUMNS.values()) + " |"
    yield "| --- " * (2 + 2 * len(COLUMNS)) + "|"
    for weight in WEIGHTS:
        took = times[weight, 60]
        yield (f"| {weight} | {np.median(took):.2f} ({min(took):.2f} to {max(took):.2f}) | " +
               " | ".join(f"{by_weight[weight, rings][name]:.1e}" for rings in (20, 150) for name in COLUMNS) + " |")
    yield ""
    fewer = [f"{count} frames: " + ", ".join(f"{label} {errors[name][k]:.1e}" for name, label in COLUMNS.items()) for k, count in enumerate(FRAMES)]
    yield "Sliced averages of fewer frames, evenly spread, 60 rings: " + "; ".join(fewer) + "."
    yield ""
    yield "Snapshots rounded to 32 bits, 150 rings, all frames: " + ", ".join(f"{label} {single[name]:.0e}" for name, label in COLUMNS.items()) + "."
