# SPDX-License-Identifier: GPL-2.0-or-later
"""Do the standard errors of one run cover what other packings give? Run B under Eq. 1 in eight seeds of 100 frames each."""
import warnings

import numpy as np

from reproduction import profiles, sheet
from reproduction.figures import figure
from reproduction.profiles import HEIGHT, K_N, R_I, R_O, from_wheel
from reproduction.simulations import couette
from reproduction.study import RUNS

FRAMES = "0:99"
RINGS = 20
SEEDS = range(1, 9)


def packings():
    return [couette(*RUNS["B"], "viscous", seed) for seed in SEEDS]


def averages(run):
    """The default columns, with their errors."""
    path = f"{run.folder}/default_{RINGS}.csv"
    return profiles.table(profiles.cached(path, lambda: profiles.run(
        "average", run.snapshots, "--frames", FRAMES, "--rings", str(R_I), str(R_O), str(RINGS), "--height", str(HEIGHT), "--bulk-types", "1", "2", "--kn",
        str(K_N), "--quiet")))


def difference(name, a, b):
    """Axes that differ by 180 degrees are the same."""
    return (a - b + 90) % 180 - 90 if name.startswith("angle_") else a - b


def deviations(name, tables):
    """Each run's values less the mean of the others, in its own error and that of the mean of the others (the mean square of those that are
    known, over their number); runs x rings, nan where the run has no error."""
    values, errors = (np.array([table[name + end] for table in tables]) for end in ("", "_err"))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # rings without any error
        typical = np.nanmean(errors**2, axis=0)
    found = []
    for k in range(len(tables)):
        others = np.delete(np.arange(len(tables)), k)
        # About the own value, so that means of axes are means of neighbours.
        away = np.mean(difference(name, values[others], values[k]), axis=0)
        error = np.sqrt(errors[k] ** 2 + typical / len(others))
        found.append(-away / error)
    return np.array(found)


def of_fit(key):
    fits = [profiles.fit(run, 60, frames=FRAMES) for run in packings()]
    values, errors = (np.array([fit[key + end] for fit in fits], dtype=float) for end in ("", "_err"))
    return deviations("", [{"": v, "_err": e} for v, e in zip(values[:, None], errors[:, None])])


def zones(columns):
    """Rings of the shear zone, and the others that do not touch a ring of wall discs."""
    distance = from_wheel(columns)
    return {"shear zone": (distance > 8) & (distance < 60), "beyond": (distance > 60) & (distance < 1e3 * (R_O - R_I) - 8)}


def share(z, most):
    return 100 * np.mean(np.abs(z) < most)


@figure("packings", "What one run knows of another packing", packings())
def draw():
    tables = [averages(run) for run in packings()]
    names = [name for name in tables[0] if name + "_err" in tables[0]]
    kept = {key: [] for key in ("column", "zone", "values", "chi2_per_value", "within_1_error_percent", "within_1.96_errors_percent")}
    points = {zone: [] for zone in zones(tables[0])}

    def keep(name, zone, z):
        z = z[np.isfinite(z)]
        if len(z) == 0:
            return
        for column, value in zip(kept.values(), (name, zone, float(len(z)), float(np.mean(z**2)), share(z, 1), share(z, 1.96))):
            column.append(value)
        if zone in points:
            points[zone].append((name, np.mean(z**2)))

    for name in names:
        z = deviations(name, tables)
        for zone, chosen in zones(tables[0]).items():
            keep(name, zone, z[:, chosen])
    for key, name in (("v0", "v0 of the fit"), ("s", "s of the fit")):
        keep(name, "whole profile", of_fit(key))
    drawing, axes = sheet.axes(width=7.5)
    order = [name for name in names if any(name == one for values in points.values() for one, _ in values)]
    for (zone, values), marker in zip(points.items(), "os"):
        axes.plot([order.index(name) for name, _ in values], [value for _, value in values], marker, ms=4, mfc="k" if marker == "o" else "w", color="k", label=zone)
    axes.axhline(1, color="k", lw=0.8, ls="--")
    axes.set(ylabel="$\\chi^2$ per value", yscale="log")
    axes.set_xticks(range(len(order)), order, rotation=90, fontsize=6)
    axes.legend()
    sheet.save_picture(drawing, "packings")
    sheet.save_numbers("packings", kept, [f"run B under Eq. 1, seeds 1 to 8, frames {FRAMES}, {RINGS} rings: each seed's value less the mean of the other seven, in the "
                                          "standard errors of both; chi2: mean of the squares, 1 where errors are right and packings do not differ"])
    medians = {zone: np.median([value for _, value in values]) for zone, values in points.items()}
    lost = [name for name in names if name not in order]
    fits = {name: k for k, name in enumerate(kept["column"]) if name.endswith("of the fit")}
    of_fits = ", ".join(f"{name} {kept['chi2_per_value'][k]:.1f}" for name, k in fits.items())
    return (f"Run B under Eq. 1 in eight seeds, 100 frames each, {RINGS} rings: how far each seed's value is from the mean of the other seven, in the standard errors of "
            f"one run (of both sides), squared and averaged over seeds and rings, for each default column that has errors"
            f"{' (none has ' + ', '.join(lost) + ')' if lost else ''}. 1: the error of one run covers the scatter "
            f"between packings as well. Medians over the columns: {', '.join(f'{zone} {value:.2f}' for zone, value in medians.items())}; {of_fits}. Above 1 a packing "
            "keeps for 50 s what no number of its frames shows: errors of several packings have to come from several packings.")
