# SPDX-License-Identifier: GPL-2.0-or-later
"""Bild 6: contacts and the fabric of samples of many size distributions."""
import dataclasses

import h5py
import numpy as np

from reproduction import profiles, sheet
from reproduction.figures import figure
from reproduction.study import bidisperse, size_distributions


def samples():
    return [one for _, runs in size_distributions() for one in runs]


def size_correction(radius):
    """g_2 of these radii, as mikromakro has it (docs/conventions.md)."""
    horizon = 2 * np.arcsin(radius.mean() / (radius.mean() + radius))
    return np.mean(radius**2 / horizon) / (np.mean(radius**2) * np.mean(1 / horizon))


@dataclasses.dataclass
class Sample:
    """Both sides of Eq. 10, tr F = g_2 nu C, of one sample: of all discs, and of those that carry contacts (their own nu, C, g_2; the same tr F)."""

    fabric: float
    product: float
    g2: float
    product_of_carriers: float
    g2_of_carriers: float
    share_of_carriers: float


def sample(run):
    columns = {name: values[0] for name, values in profiles.box(run).items()}
    with h5py.File(run.snapshots) as file:
        radius, ids = file["particles/discs/radius/value"][-1], file["particles/discs/id/value"][-1]
        first, last = file["contacts/offset"][-2:]
        touching = np.concatenate([file["contacts/id1"][first:last], file["contacts/id2"][first:last]])
    carries = np.isin(ids, touching)
    solid, coordination = columns["nu"], columns["coordination_number_averaged"]
    area = np.sum(radius[carries] ** 2) / np.sum(radius**2)
    return Sample(columns["tr_F"], solid * coordination, columns["g2"], solid * area * coordination / carries.mean(), size_correction(radius[carries]), carries.mean())


def ratio(samples, product, g2):
    """tr F over g_2 nu C: mean over samples and its standard error; 1 where Eq. 10 holds."""
    values = np.array([one.fabric / (getattr(one, g2) * getattr(one, product)) for one in samples])
    return values.mean(), values.std(ddof=1) / np.sqrt(len(values))


@figure("bild6", "Bild 6: trace of the fabric tensor", [*samples(), bidisperse()])
def bild6():
    drawing = sheet.plt.figure(figsize=(15.5, 4.2))
    everyone, carriers, right = drawing.add_subplot(1, 3, 1), drawing.add_subplot(1, 3, 2), drawing.add_subplot(1, 3, 3, projection="polar")
    kept = {name: [] for name in ("half_width_or_ratio", "g2", "ratio", "ratio_err", "g2_of_carriers", "ratio_of_carriers", "ratio_of_carriers_err", "share_of_carriers")}
    for k, (name, runs) in enumerate(size_distributions()):
        made = [sample(run) for run in runs]
        all_discs, carrying = ratio(made, "product", "g2"), ratio(made, "product_of_carriers", "g2_of_carriers")
        for axes, product, g2, (value, error) in ((everyone, "product", "g2", all_discs), (carriers, "product_of_carriers", "g2_of_carriers", carrying)):
            axes.plot([getattr(one, product) for one in made], [one.fabric / getattr(one, g2) for one in made], sheet.MARKERS[k % len(sheet.MARKERS)], ms=4,
                      color=sheet.shades(11)[k], label=f"{name}: {value:.3f} ± {error:.3f}")
        row = (float(name.strip("$\\pm %").removeprefix("1:")), made[0].g2, *all_discs, np.mean([one.g2_of_carriers for one in made]), *carrying,
               np.mean([one.share_of_carriers for one in made]))
        for column, value in zip(kept.values(), row):
            column.append(value)
    for axes, title in ((everyone, "all discs"), (carriers, "discs that carry contacts")):
        axes.plot([0, 5], [0, 5], "k--", lw=0.8)
        axes.set(xlabel="$\\nu C$", ylabel="tr F / $g_2$", xlim=(0.5, 4.5), ylim=(0.5, 4.5), title=title)
        axes.legend(fontsize=7)
    draw_directions(right, profiles.box(bidisperse()))
    sheet.save_picture(drawing, "bild6")
    sheet.save_numbers("bild6", kept, ["ratio: tr F/(g_2 nu C), 1 where Eq. 10 holds, mean and standard deviation over 2 of four samples, which are four conditions (two pressures, with and without friction) and no replicates: their spread is mostly the effect of these (as of replicates, 3.2 of it would be an interval of 95 %); carriers: the "
                                       "same with nu, C, g_2 of the discs that have contacts; rows: half width in % of eight uniform distributions of radii, then the ratio of two sizes"])
    return ("Trace of the fabric tensor over g_2, over the solid fraction times the mean number of contacts (number-averaged), for eleven distributions of radii and "
            "four samples each (two pressures, with and without friction), 600 discs; in the legend tr F/(g_2 nu C), mean of the four and their standard deviation over 2; they are conditions, no replicates. Eq. 10 is the dashed "
            f"line: it takes a disc's contacts to grow with its share of the horizon. Left: all discs; {said(kept, 'ratio')}. Discs without contacts, most of them small, do not "
            f"follow. Middle: discs that carry contacts, with their own solid fraction, number of contacts and g_2; {said(kept, 'ratio_of_carriers')}. Right: directions of the contacts of the bidisperse "
            "sample 1:3, with the isotropic part, the first and the second harmonic.")


def said(kept, name):
    """How far the samples are from Eq. 10."""
    off = 100 * (np.array(kept[name]) - 1)
    error = 100 * np.array(kept[name + "_err"])
    return f"Eq. 10 is missed by {off.min():+.1f} to {off.max():+.1f} %, {np.sum(np.abs(off) > 3.18 * error)} of {len(off)} distributions by more than 3.2 of these"


def draw_directions(axes, columns):
    bins = 36
    counted = np.array([columns[f"contact_angle_bin_{k + 1}"][0] for k in range(bins)])
    # From -180 degrees on.
    middle = (np.arange(bins) + 0.5) * 2 * np.pi / bins - np.pi
    density = counted / counted.sum() * bins
    axes.bar(middle, density, width=2 * np.pi / bins, color="0.85", edgecolor="0.6", lw=0.3)
    angle = np.linspace(0, 2 * np.pi, 361)
    total = np.ones_like(angle)
    axes.plot(angle, total, "k:", lw=1, label="isotropic")
    for order, line, name in ((2, "k--", "and first harmonic"), (4, "k-", "and second harmonic")):
        # As the columns of mikromakro define them: 1 + a2 cos 2(phi - phi2) + a4 cos 4(phi - phi4).
        a, phi = columns[f"contact_angle_h{order}_amplitude"][0], np.radians(columns[f"contact_angle_h{order}_angle"][0])
        total = total + a * np.cos(order * (angle - phi))
        axes.plot(angle, total, line, lw=1, label=name)
    axes.set(title="contacts per direction over the mean, 1:3")
    axes.legend(loc="lower left", bbox_to_anchor=(-0.25, -0.1), fontsize=7)
