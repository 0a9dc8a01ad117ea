"""Bild 6: contacts and the fabric of samples of many size distributions."""
import numpy as np

from reproduction import profiles, sheet
from reproduction.figures import figure
from reproduction.study import bidisperse, size_distributions


def samples():
    return [one for _, runs in size_distributions() for one in runs]


def slope_of(runs):
    """tr F over nu C through the origin, its standard error, and g2 of the radii (Eq. 10)."""
    columns = [profiles.box(run) for run in runs]
    product = np.array([c["nu"][0] * c["coordination_number_averaged"][0] for c in columns])
    fabric = np.array([c["tr_F"][0] for c in columns])
    slope = np.sum(product * fabric) / np.sum(product**2)
    error = np.sqrt(np.sum((fabric - slope * product) ** 2) / (len(runs) - 1) / np.sum(product**2))
    return product, fabric, slope, error, columns[0]["g2"][0]


@figure("bild6", "Bild 6: trace of the fabric tensor", [*samples(), bidisperse()])
def bild6():
    drawing = sheet.plt.figure(figsize=(10.8, 4.2))
    left, right = drawing.add_subplot(1, 2, 1), drawing.add_subplot(1, 2, 2, projection="polar")
    kept = {"half_width_or_ratio": [], "g2_of_the_radii": [], "slope": [], "slope_err": []}
    for k, (name, runs) in enumerate(size_distributions()):
        product, fabric, slope, error, g2 = slope_of(runs)
        left.plot(product, fabric / g2, sheet.MARKERS[k % len(sheet.MARKERS)], ms=4, color=sheet.shades(11)[k], label=f"{name}: $g_2$ = {g2:.3f}, slope {slope:.3f}")
        for column, value in zip(kept.values(), (float(name.strip("$\\pm %").removeprefix("1:")), g2, slope, error)):
            column.append(value)
    left.plot([0, 4], [0, 4], "k--", lw=0.8)
    left.set(xlabel="$\\nu C$", ylabel="tr F / $g_2$", xlim=(0.5, 4), ylim=(0.5, 4))
    left.legend(fontsize=7)
    draw_directions(right, profiles.box(bidisperse()))
    sheet.save_picture(drawing, "bild6")
    sheet.save_numbers("bild6", kept, ["slope: tr F over nu C (number-averaged) of four samples of each distribution, through the origin; rows: half width in % of "
                                       "eight uniform distributions of radii, then the ratio of two sizes"])
    return ("Left: trace of the fabric tensor over g_2 of the radii (Eq. 10), over the solid fraction times the mean number of contacts (number-averaged), for "
            "eleven distributions of radii and four states each (two pressures, with and without friction), 600 discs. Eq. 10 is the dashed line: it takes a "
            "disc's contacts to grow with its share of the horizon, which discs without contacts, most of them small, do not. Right: directions of the "
            "contacts of the bidisperse sample 1:3, with the isotropic part, the first and the second harmonic.")


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
