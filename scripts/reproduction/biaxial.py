# SPDX-License-Identifier: GPL-2.0-or-later
"""The biaxial test: where the sample shears, and where its discs turn (as Bild 1 b of the paper)."""
import os

import h5py
import numpy as np
from matplotlib.collections import LineCollection

from reproduction import sheet
from reproduction.figures import figure
from reproduction.pictures import draw_discs
from reproduction.study import biaxial_test

# Axial strains between which displacements and rotations are taken.
FROM, TO = 0.02, 0.045


def course(run):
    """Axial strain (positive in compression), stress ratio and volumetric strain of each row of shear.txt, with the steps."""
    rows = np.loadtxt(os.path.join(run.folder, "shear.txt"))
    side, axial = rows[:, 4:6].mean(axis=1), rows[:, 6:8].mean(axis=1)
    return rows[:, 0], -rows[:, 1], (axial - side) / (axial + side), rows[:, 3]


def frames(run):
    """Step, positions (mm) and spins (1/s) of every snapshot, and the radii (mm)."""
    with h5py.File(run.snapshots) as file:
        discs = file["particles/discs"]
        return discs["position/step"][:], 1e3 * discs["position/value"][:, :, :2], discs["spin/value"][:], 1e3 * discs["radius/value"][0]


def neighbours(position, radius, reach=4.0):
    """Which discs are near which, within `reach` mean radii: a row for each disc."""
    return np.hypot(*(position[:, None] - position[None]).transpose(2, 0, 1)) < reach * radius.mean()


def local_rotation(steps, spin, time_step, near):
    """Root of the mean square of the rotations (degrees) of the discs around each one. A sum of momentary spins is the rotation and noise, since the
    springs of the contacts swing; the product of two sums, over every other snapshot each, has the mean of the squared rotation."""
    first, second = ((steps[-1] - steps[0]) * time_step * spin[start:-1:2].mean(axis=0) for start in (0, 1))
    product = np.array([np.mean((first * second)[around]) for around in near])
    return np.degrees(np.sqrt(np.clip(product, 0, None)))


def local_shear(before, after, near):
    """Deviator of the strain that fits the displacements of the discs around each one best."""
    shear = np.empty(len(before))
    for k, around in enumerate(near):
        start = before[around] - before[around].mean(axis=0)
        moved = (after - before)[around]
        gradient = np.linalg.lstsq(start, moved - moved.mean(axis=0), rcond=None)[0]
        shear[k] = np.hypot(gradient[0, 0] - gradient[1, 1], gradient[0, 1] + gradient[1, 0])
    return shear


def draw_field(axes, drawing, position, radius, values, name):
    """Discs in the shade of a value, which the bar beside them names."""
    limits = (0, np.quantile(values, 0.98))
    discs = draw_discs(axes, position, radius, array=values, cmap="Greys", clim=limits, edgecolors="0.5", linewidths=0.1)
    drawing.colorbar(discs, ax=axes, label=name, shrink=0.9)


def turns_most(rotation):
    return rotation > np.quantile(rotation, 0.85)


def draw_paths(axes, positions, rotation):
    paths = positions[::5].transpose(1, 0, 2)
    strong = turns_most(rotation)
    for chosen, colour, width in ((~strong, "#9bb7dd", 0.7), (strong, "#b40426", 1.3)):
        axes.add_collection(LineCollection(paths[chosen], colors=colour, linewidths=width))


def draw_course(axes, axial, ratio, volumetric):
    axes.plot(100 * axial, ratio, "k", lw=0.7, label="stress ratio")
    axes.axvspan(100 * FROM, 100 * TO, color="0.9", lw=0)
    axes.set(xlabel="axial strain (%), compression positive", ylabel="$(\\sigma_{yy}-\\sigma_{xx})/(\\sigma_{yy}+\\sigma_{xx})$", ylim=(0, None))
    other = axes.twinx()
    other.plot(100 * axial, 100 * volumetric, "k--", lw=1.2, label="volumetric strain")
    other.set_ylabel("volumetric strain (%), dashed; dilatancy positive")
    other.grid(False)


@figure("biaxial", "The biaxial test: shear bands and rotations", [biaxial_test()])
def biaxial():
    run = biaxial_test()
    step, axial, ratio, volumetric = course(run)
    steps, positions, spin, radius = frames(run)
    first, last = (int(np.argmin(np.abs(np.interp(steps, step, axial) - strain))) for strain in (FROM, TO))
    near = neighbours(positions[first], radius)
    rotation = local_rotation(steps[first:last + 1], spin[first:last + 1], run.time_step, near)
    shear = 100 * local_shear(positions[first], positions[last], near)
    drawing, sheets = sheet.axes(columns=2, rows=2, width=5.0, height=4.3)
    end = positions[last]
    draw_field(sheets[0, 0], drawing, end, radius, rotation, "rotation, rms within 4 mm (degrees)")
    draw_paths(sheets[0, 1], positions[first:last + 1], rotation)
    draw_field(sheets[1, 0], drawing, end, radius, shear, "local shear strain (%)")
    draw_course(sheets[1, 1], axial, ratio, volumetric)
    for axes, title in zip(sheets.flat, ("(a) rotation of the discs", "(b) paths; dark: where discs turn most", "(c) where the sample shears")):
        low, high = end.min(axis=0) - 2, end.max(axis=0) + 2
        axes.set(aspect="equal", xlabel="x (mm)", ylabel="y (mm)", title=title, xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        axes.grid(False)
    sheets[1, 1].set_title("(d) stress ratio and dilatancy")
    sheet.save_picture(drawing, "biaxial", dots_per_inch=90, colours=96)
    sheet.save_numbers("biaxial", {"axial_strain": axial, "stress_ratio": ratio, "volumetric_strain": volumetric, "x_mm": end[:, 0], "y_mm": end[:, 1],
                                   "radius_mm": radius, "local_rotation_degrees": rotation, "local_shear_strain": shear / 100},
                       [f"rows of shear.txt; then the discs at {TO:g} of axial strain, local rotation and local shear since {FROM:g}"])
    return caption(rotation, shear, volumetric)


def caption(rotation, shear, volumetric):
    strong = turns_most(rotation)
    return ("1950 discs with radii from 0.5 to 1.5 mm between smooth walls: the top moves down, the right wall yields to 200 N/m. Between the axial strains "
            f"{100 * FROM:g} and {100 * TO:g} % (grey in d): (a) root mean square of the rotations of the discs within 4 mm; a round spot is one disc without contacts that spins. "
            "(b) Paths of the discs; dark where they turn most, 15 % of all, as in Bild 1 b. (c) Local shear strain, the deviator of the strain that fits the "
            "displacements within 4 mm best: it is localised in bands. (d) Stress ratio and volumetric strain: the sample contracts by "
            f"{-100 * volumetric.min():.2f} % before it dilates, to {100 * volumetric[-1]:+.2f} % at the end. "
            f"Where discs turn, the sample shears: the local shear strain is {shear[strong].mean():.1f} % at those 15 %, {shear[~strong].mean():.1f} % at the others.")
