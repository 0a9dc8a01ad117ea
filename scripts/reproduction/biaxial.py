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


def turned(steps, spin, time_step):
    """Rotation of each disc (degrees) over all snapshots, by the trapezoidal rule."""
    return np.degrees(np.sum(0.5 * (spin[1:] + spin[:-1]) * np.diff(steps)[:, None] * time_step, axis=0))


def local_shear(before, after, radius, reach=4.0):
    """Deviator of the strain that fits the displacements of the discs around each one best, within `reach` mean radii."""
    shear = np.empty(len(before))
    distance = np.hypot(*(before[:, None] - before[None]).transpose(2, 0, 1))
    for k, near in enumerate(distance < reach * radius.mean()):
        start = before[near] - before[near].mean(axis=0)
        moved = (after - before)[near]
        gradient = np.linalg.lstsq(start, moved - moved.mean(axis=0), rcond=None)[0]
        shear[k] = np.hypot(gradient[0, 0] - gradient[1, 1], gradient[0, 1] + gradient[1, 0])
    return shear


def draw_field(axes, drawing, position, radius, values, colours, limits, name):
    """Discs in the shade of a value, which the bar beside them names."""
    discs = draw_discs(axes, position, radius, array=values, cmap=colours, clim=limits, edgecolors="0.5", linewidths=0.1)
    drawing.colorbar(discs, ax=axes, label=name, shrink=0.9)


def turns_most(rotation):
    return np.abs(rotation) > np.quantile(np.abs(rotation), 0.85)


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
    rotation = turned(steps[first:last + 1], spin[first:last + 1], run.time_step)
    shear = 100 * local_shear(positions[first], positions[last], radius)
    drawing, sheets = sheet.axes(columns=2, rows=2, width=5.0, height=4.3)
    end = positions[last]
    draw_field(sheets[0, 0], drawing, end, radius, rotation, "coolwarm", (-40, 40), "rotation (degrees), counter-clockwise positive")
    draw_paths(sheets[0, 1], positions[first:last + 1], rotation)
    draw_field(sheets[1, 0], drawing, end, radius, shear, "Greys", (0, 30), "local shear strain (%)")
    draw_course(sheets[1, 1], axial, ratio, volumetric)
    for axes, title in zip(sheets.flat, ("(a) rotation of the discs", "(b) paths; dark: the discs that turn most", "(c) where the sample shears")):
        low, high = end.min(axis=0) - 2, end.max(axis=0) + 2
        axes.set(aspect="equal", xlabel="x (mm)", ylabel="y (mm)", title=title, xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        axes.grid(False)
    sheets[1, 1].set_title("(d) stress ratio and dilatancy")
    sheet.save_picture(drawing, "biaxial", dots_per_inch=90, colours=256)
    sheet.save_numbers("biaxial", {"axial_strain": axial, "stress_ratio": ratio, "volumetric_strain": volumetric, "x_mm": end[:, 0], "y_mm": end[:, 1],
                                   "radius_mm": radius, "rotation_degrees": rotation, "local_shear_strain": shear / 100},
                       [f"rows of shear.txt; then the discs at {TO:g} of axial strain, rotation and local shear since {FROM:g}"])
    return caption(rotation, shear, volumetric)


def caption(rotation, shear, volumetric):
    strong = turns_most(rotation)
    return ("1950 discs with radii from 0.5 to 1.5 mm between smooth walls: the top moves down, the right wall yields to 200 N/m. Between the axial strains "
            f"{100 * FROM:g} and {100 * TO:g} % (grey in d): (a) rotation of each disc, the sum of its spin over the snapshots; the darker, the more it has turned. "
            "(b) Paths of the discs, those that turn most, 15 % of all, dark, as in Bild 1 b. (c) Local shear strain, the deviator of the strain that fits the "
            "displacements within 4 mm best: it is localised in bands. (d) Stress ratio and volumetric strain: the sample contracts by "
            f"{-100 * volumetric.min():.2f} % before it dilates, to {100 * volumetric[-1]:+.2f} % at the end. "
            f"Where discs turn, the sample shears: the local shear strain is {shear[strong].mean():.1f} % at those 15 %, {shear[~strong].mean():.1f} % at the others.")
