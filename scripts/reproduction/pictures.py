# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of discs and force chains (Bild 2, 3)."""
import h5py
import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection

from appearance import COMPRESSION, TENSION
from reproduction import sheet
from reproduction.figures import figure, run_b
from reproduction.profiles import R_I
from reproduction.study import bidisperse


def frame(simulation, index):
    """Discs (type, x, y, radius; mm) and contacts (x1, y1, x2, y2 in mm; fn in N) of a snapshot."""
    with h5py.File(simulation.snapshots) as file:
        discs = file["particles/discs"]
        position, radius = 1e3 * discs["position/value"][index], 1e3 * discs["radius/value"][index]
        kind = discs["species/value"][index]
        step = discs["position/step"]
        first = file["contacts/offset"][index % len(step)]
        last = file["contacts/offset"][index % len(step) + 1]
        ends = np.column_stack([1e3 * file[f"contacts/{name}"][first:last] for name in ("x1", "y1", "x2", "y2")])
        force, overlap = file["contacts/fn"][first:last], file["contacts/overlap"][first:last]
    return kind, position, radius, ends, force, overlap


def draw_discs(axes, position, radius, **colours):
    return axes.add_collection(EllipseCollection(2 * radius, 2 * radius, 0 * radius, units="xy", offsets=position, offset_transform=axes.transData, **colours))


def draw_chains(axes, ends, force, scale):
    """Lines between the centres, as wide as the force; attraction of the dashpot dotted."""
    for chosen, style, colour in ((force > 0, "solid", COMPRESSION), (force <= 0, "dotted", TENSION)):
        axes.add_collection(LineCollection(ends[chosen].reshape(-1, 2, 2), linewidths=np.clip(np.abs(force[chosen]) / scale, 0.15, 4), colors=colour,
                                           linestyles=style, capstyle="round"))


@figure("bild2", "Bild 2: the shear cell", [run_b()])
def bild2():
    kind, start, radius, _, _, _ = frame(run_b(), 0)
    _, position, _, ends, force, _ = frame(run_b(), -1)
    free = kind < 3
    drawing, (whole, near, chains) = sheet.axes(columns=3, width=4.2, height=4.1)
    sector = np.degrees(np.arctan2(start[free, 1], start[free, 0])) // 10 % 2
    layer = (np.hypot(*start[free].T) - 1e3 * R_I) // 7.42 % 2
    for axes in (whole, near, chains):
        draw_discs(axes, position[~free], radius[~free], facecolors="k", edgecolors="none")
        axes.set(aspect="equal", xlabel="x (mm)")
        axes.grid(False)
    for axes, dark in ((whole, sector), (near, layer)):
        draw_discs(axes, position[free], radius[free], facecolors=np.where(dark == 0, "0.9", "#35435e"), edgecolors="0.4", linewidths=0.2)
    draw_discs(chains, position[free], radius[free], facecolors="0.93", edgecolors="0.75", linewidths=0.3)
    draw_chains(chains, ends, force, 1.5 * np.abs(force).mean())
    whole.set(xlim=(-260, 260), ylim=(-260, 260), ylabel="y (mm)", title="sectors of 10 degrees, 60 s later")
    near.set(xlim=(-50, 50), ylim=(95, 195), title="layers of 7.42 mm, 60 s later")
    chains.set(xlim=(-70, 70), ylim=(100, 240), title="force chains")
    sheet.save_picture(drawing, "bild2")
    sheet.save_numbers("bild2", {"x_mm": position[free][:, 0], "y_mm": position[free][:, 1], "radius_mm": radius[free], "sector": sector, "layer": layer},
                       ["last snapshot of run B, Eq. 1; sector, layer: 0 or 1 by where the disc was in the first one (10 degrees, 7.42 mm)"])
    return ("Run B under Eq. 1, 60 s (6 rad of the wheel) after the first snapshot. Left: discs shaded by the sector of 10 degrees in which they were then. "
            "Middle: by their starting radius, in layers of one small disc; those next to the wheel have mixed. Right: contacts as lines between "
            "centres, as wide as the normal force; dotted where the dashpot pulls.")


@figure("averaging", "Does the average make artefacts?", [run_b()])
def averaging():
    from reproduction import profiles
    from reproduction.profiles import from_wheel

    fields = {"nu": "solid fraction", "v_phi": "$v_\\phi$ (m/s)", "spin": "spin (1/s)", "tr_F": "tr F", "tr_sigma": "tr $\\sigma$ (Pa)",
              "dev_sigma": "dev $\\sigma$ (Pa)", "tr_eps": "tr $\\epsilon$", "omega_excess": "$\\omega^*$ (1/s)"}
    weights = (("sliced", "k", "-"), ("centre", "C1", "-"), ("gauss:0.00371", "C0", "--"), ("lucy:0.0074", "C2", ":"))
    drawing, sheets = sheet.axes(columns=4, rows=2, width=3.5, height=2.9)
    kept = {}
    for axes, name in zip(sheets.flat, fields):
        for weight, colour, line in weights:
            columns = profiles.rings(run_b(), 150, weight)
            axes.plot(from_wheel(columns), columns[name], line, color=colour, lw=0.8, label=weight)
            kept["r_m"] = columns["r"]
            kept[f"{name} {weight}"] = columns[name]
        for count, marker in ((20, "o"), (60, ".")):
            columns = profiles.rings(run_b(), count)
            axes.plot(from_wheel(columns), columns[name], marker, color="k", ms=3, mfc="none", label=f"sliced, {count} rings")
        shown = [c[name][from_wheel(c) < 60] for c in (profiles.rings(run_b(), 150, weight) for weight, _, _ in weights)]
        low, high = np.nanmin(shown), np.nanmax(shown)
        axes.set(title=fields[name], xlabel=FROM_WHEEL_SHORT, xlim=(0, 60), ylim=(low - 0.05 * (high - low), high + 0.05 * (high - low)))
    sheets.flat[0].legend(fontsize=6)
    sheet.save_picture(drawing, "averaging")
    sheet.save_numbers("averaging", kept, ["run B, Eq. 1; 150 rings; SI units"])
    return ("The same snapshots averaged over 150 rings by exact fractions, by centres, and with two kernels, and by exact fractions over 20 and 60 rings "
            "(symbols). The layers are in the packing, not in the average: all weights show them, at the same places; centres exaggerate them where rings "
            "are thinner than a disc, kernels of one radius of a small disc smooth them. Away from the wheel all agree.")


FROM_WHEEL_SHORT = "$r - R_i$ (mm)"


@figure("bild3", "Bild 3: the bidisperse sample", [bidisperse()])
def bild3():
    _, position, radius, ends, force, overlap = frame(bidisperse(), -1)
    energy = 0.5 * force * overlap * 1e6
    drawing, axes = sheet.axes(width=5.6, height=4.8)
    with h5py.File(bidisperse().snapshots) as file:
        touched = {int(i) for name in ("id1", "id2") for i in file[f"contacts/{name}"][:]}
        ids = file["particles/discs/id/value"][-1]
    rattler = np.array([int(i) not in touched for i in ids])
    draw_discs(axes, position[~rattler], radius[~rattler], facecolors="0.93", edgecolors="0.6", linewidths=0.3)
    draw_discs(axes, position[rattler], radius[rattler], facecolors="k", edgecolors="none")
    order = np.argsort(energy)
    lines = LineCollection(ends[order].reshape(-1, 2, 2), linewidths=np.clip(1.5 * np.sqrt(energy[order] / energy.mean()), 0.2, 4), array=energy[order],
                           cmap="viridis_r", capstyle="round")
    axes.add_collection(lines)
    drawing.colorbar(lines, label="elastic energy of the contact ($\\mu$J)")
    axes.set(aspect="equal", xlabel="x (mm)", ylabel="y (mm)", xlim=(0, 54), ylim=(0, 54))
    axes.grid(False)
    sheet.save_picture(drawing, "bild3")
    sheet.save_numbers("bild3", {"x1_mm": ends[:, 0], "y1_mm": ends[:, 1], "x2_mm": ends[:, 2], "y2_mm": ends[:, 3], "energy_uJ": energy}, ["contacts at rest"])
    return ("600 discs, radii 1:3, half of each by number, at rest under a pressure of 200 N/m. Lines: contacts, darker and wider with more elastic energy, "
            "f_n overlap/2; black: discs without contacts, isolated in cavities.")
