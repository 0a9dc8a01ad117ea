# SPDX-License-Identifier: GPL-2.0-or-later
"""The paper's numbers beside ours: quantities of the runs A, B, C over their seeds, and single ones."""
import dataclasses
import functools

import numpy as np

from reproduction import fabric, packings, profiles, thresholds
from reproduction.figures import LAW_NAMES, run_b
from reproduction.profiles import HEIGHT, K_N, OMEGA, R_I, R_O, from_wheel
from reproduction.simulations import isotropic
from reproduction.study import LADDERS, LAWS, PITCHES, RUNS, SAMPLE_SEEDS, ladder, pitches, seeds, slow_run


@dataclasses.dataclass
class Quantity:
    """A number of one run of the shear cell, and what the paper has for it (None: no number)."""

    name: str
    paper: float
    value: object  # run -> number
    remark: str
    digits: int = 3
    choices: object = None  # run -> the same by each choice of the fit


@dataclasses.dataclass
class Group:
    """Part of a table that is made by its name."""

    title: str
    simulations: list
    make: object


def over_seeds(values):
    """Mean and standard error of independent runs."""
    return np.mean(values), np.std(values, ddof=1) / np.sqrt(len(values))


def away(mean, error, paper):
    """How far the paper's value is, in the errors of the packings."""
    return f"{(mean - paper) / error:+.1f} statistical"


def cell(mean, error, paper, digits):
    """Ours with its error, and its distance from the paper's value in such errors; with more digits where the error would be rounded to 0."""
    while error > 0 and round(error, digits) == 0:
        digits += 1
    return f"{mean:.{digits}f} ± {error:.{digits}f}" + ("" if paper is None else f" ({away(mean, error, paper)})")


def cell_of_choices(mean, error, paper, digits, low, high):
    """The same of a quantity that depends on choices, beside whose range the error alone says little."""
    outside = max(low - paper, paper - high)
    beside = "within the choices" if outside <= 0 else f"{outside:.{digits}f} outside of the choices"
    return f"{mean:.{digits}f} ± {error:.{digits}f}, by choices {low:.{digits}f} to {high:.{digits}f} ({away(mean, error, paper)}; the paper's is {beside})"


def rings(run):
    return profiles.rings(run, 60)


def zone(columns, first, last):
    """Rings from `first` to `last` mm from the wheel."""
    return (from_wheel(columns) > first) & (from_wheel(columns) < last)


def constant_part(columns):
    """Rings that are not at the rings of wall discs."""
    return zone(columns, 8, 1e3 * (R_O - R_I) - 8)


def gradient_of_fit(v0, s, sign):
    """Of v0 exp(-(r - R_i)/s) at R_i: (dv/dr -+ v/r)/2."""
    return -0.5 * (v0 / s + sign * v0 / R_I)


def of_fit(name, paper, value, remark, digits=3):
    """A quantity of the fit's v_0 and s."""
    def made(run):
        fit = profiles.fit(run, 60)
        return value(fit["v0"], fit["s"])

    def by_choices(run):
        return [value(one["v0"], one["s"]) for one in profiles.fit(run, 60)["choices"].values() if one["v0"] is not None]

    return Quantity(name, paper, made, remark, digits, by_choices)


def scatter(values):
    return np.std(values) / np.abs(np.mean(values))


def pressure_scatter(run):
    return scatter(rings(run)["tr_sigma"][constant_part(rings(run))])


def torque_of_stress(run):
    columns = rings(run)
    return (2 * np.pi * columns["r"] ** 2 * HEIGHT * columns["sigma_phir"])[constant_part(columns)]


def stiffness_slope(run):
    columns = profiles.rings(run, 150)
    good = np.isfinite(columns["E"]) & (columns["tr_F"] > 0.5)
    fabric = columns["tr_F"][good]
    return np.sum(2 * np.pi * columns["E"][good] * fabric) / np.sum(fabric**2)


QUANTITIES = (
    of_fit("v0/(Omega R_i)", 0.645, lambda v0, s: v0 / (OMEGA * R_I),
           "exponential on 60 rings, least squares of v; choices of range, of v or log v, weights, 20 to 60 rings, centres or slices"),
    of_fit("s (mm)", 12.7, lambda v0, s: 1e3 * s, "the same", 1),
    of_fit("D_rphi at R_i (1/s)", -0.294, lambda v0, s: gradient_of_fit(v0, s, 1), "of the fit; the paper's is that of its fit"),
    of_fit("W_rphi at R_i (1/s)", -0.230, lambda v0, s: gradient_of_fit(v0, s, -1), "the same"),
    Quantity("scatter of tr sigma over r", None, pressure_scatter, "rms over mean, 8 mm from the rings on; the paper: nearly constant"),
    Quantity("scatter of r^2 sigma_phir over r", None, lambda run: scatter(torque_of_stress(run)), "the same; 0 by balance of the torque"),
    Quantity("torque on the outer ring over that on the wheel", -1, lambda run: profiles.wheel(run)[:, 2].mean() / profiles.wheel(run)[:, 1].mean(),
             "means over all steps; -1 by balance, but for the angular momentum of the discs", 4),
    Quantity("2 pi r^2 h sigma_phir over the wheel torque", 1, lambda run: torque_of_stress(run).mean() / profiles.wheel(run)[:, 1].mean(),
             "mean of the rings; stress of the snapshots against the torque of all steps; 1 by balance"),
    Quantity("slope of 2 pi E h/k_n over tr F", None, stiffness_slope,
             "150 rings; the paper: one line for all densities; identity: 1 for an isotropic fabric, up to 1.07", 4),
)


def cells(run, law):
    """By quantity, of one of the runs A, B, C; choices are means over the seeds of the least and the greatest."""
    made = {}
    for one in QUANTITIES:
        ours = over_seeds([one.value(seed) for seed in seeds(run, law)])
        if one.choices is None:
            made[one.name] = cell(*ours, one.paper, one.digits)
        else:
            choices = [one.choices(seed) for seed in seeds(run, law)]
            made[one.name] = cell_of_choices(*ours, one.paper, one.digits, np.mean([min(values) for values in choices]),
                                             np.mean([max(values) for values in choices]))
    return made


def column(run, law):
    return f"{run}_{law}"


GROUPS = {column(run, law): Group(f"the table's run {run} under {LAW_NAMES[law]}", seeds(run, law), functools.partial(cells, run, law))
          for law in LAWS for run in RUNS}

SAMPLES = [isotropic("bidisperse", 0.0005, 0.0015, seed=seed) for seed in SAMPLE_SEEDS]


def fabric_factor():
    made = [fabric.sample(run) for run in SAMPLES]
    remark = f"{len(made)} samples of 600 discs at rest under 200 N/m"
    carriers = over_seeds([one.g2_of_carriers for one in made])
    # g_2 of these discs varies from sample to sample with tr F/(nu C).
    apart = over_seeds([one.fabric / one.product_of_carriers - one.g2_of_carriers for one in made])
    return [["g_2 of the radii, 1:3", "1.223", f"{made[0].g2:.4f}", "Eq. 10, half of the discs of either radius"],
            ["tr F/(nu C), radii 1:3, all discs", "1.223", cell(*over_seeds([one.fabric / one.product for one in made]), 1.223, 3), remark],
            ["g_2 of the discs that carry contacts, 1:3", "-", cell(*carriers, None, 3), f"{100 * np.mean([one.share_of_carriers for one in made]):.0f} % of the discs"],
            ["tr F/(nu C), radii 1:3, discs that carry contacts", f"{carriers[0]:.3f} (its g_2)",
             cell(*over_seeds([one.fabric / one.product_of_carriers for one in made]), None, 3),
             f"the same samples; nu and C of these discs alone; {apart[0]:+.3f} ± {apart[1]:.3f} from the g_2 of the same samples (paired)"]]


def angle(run, tensor):
    """Mean direction (degrees) of the major axes from 8 to 40 mm from the wheel."""
    columns = rings(run)
    doubled = np.radians(2 * columns[f"angle_{tensor}"][zone(columns, 8, 40)])
    return np.degrees(np.angle(np.mean(np.exp(1j * doubled)))) / 2


def ordered_angles(run):
    angles = sorted((angle(run, tensor), name) for name, tensor in (("sigma", "sigma"), ("epsilon", "eps"), ("F", "F")))
    return " < ".join(f"{name} {value:.1f}" for value, name in angles) + " degrees"


def layer_spins(run):
    """omega_excess in the middle of the first four layers."""
    columns = rings(run)
    layers = profiles.middles_of_layers(columns, 4)
    values, errors = columns["omega_excess"][layers], columns["omega_excess_err"][layers]
    if np.isnan(errors).any():
        return ", ".join(f"{value:+.3f}" for value in values) + " (too few effective frames for errors)"
    return ", ".join(f"{value:+.3f} ± {error:.3f}" for value, error in zip(values, errors))


def rotational_stiffness(run, first, last):
    """mu_c h/k_n, the median of rings: a quotient whose divisor comes near 0."""
    columns = rings(run)
    return np.nanmedian(columns["mu_c"][zone(columns, first, last)]) * HEIGHT / K_N


def trends():
    """What the paper says without a number, each of one run."""
    found = [[f"{name}, run B, {LAW_NAMES[law]}", paper, value(run_b(law)), remark] for name, paper, value, remark in (
        ("omega_excess in the first four layers (1/s)", "sign alternates", layer_spins, "rings nearest to the middles of layers of 7.42 mm; errors of blocks of frames"),
        ("major axes from e_r", "not co-linear", ordered_angles, "means from 8 to 40 mm from the wheel")) for law in LAWS]
    for case in LAW_NAMES.values():
        for name, first, last in (("within 15 mm of the wheel", 0, 15), ("45 to 120 mm from it", 45, 120)):
            values = [f"{rotational_stiffness(run, first, last):.3f} at {profiles.solid_fractions(run)[1]:.4f}" for run in ladder(case)]
            found.append([f"mu_c h/k_n {name}, {case}", "lower in the shear zone, rises with density", ", ".join(values),
                          "medians of rings, by density; runs of the thresholds"])
    return found



def changes_of_run_b():
    """What is changed in run B under Eq. 1, one thing at a time: name, run, how its profile is fitted."""
    as_it_is = run_b()
    yield "as it is", as_it_is, {}
    for distance, run in zip(PITCHES, pitches()):
        if run != as_it_is:
            yield f"wall discs {1e3 * distance:g} mm apart", run, {}
    yield "wheel at a fifth of its rate", slow_run(), {"omega": 0.02}
    yield "law with spring", run_b("cundall_strack"), {}
    yield "bottom friction 2e-5, a third of a turn", ladder("Eq. 1, bottom friction")[LADDERS["viscous"].index(RUNS["B"])], {}
    for name in ("A", "C"):
        yield f"density of run {name}", seeds(name, "viscous")[0], {}
    yield "another packing (seed 2)", seeds("B", "viscous")[1], {}
    yield "20 rings, not 60", as_it_is, {"count": 20}
    yield "centres, not exact fractions", as_it_is, {"weight": "centre"}
    yield "second half of the snapshots only", as_it_is, {"frames": "60:"}


def with_errors(fit, key, scale, digits):
    """A value of a fit with its standard error, and its range by choices."""
    value, error, low, high = (None if one is None else scale * one for one in (fit[key + end] for end in ("", "_err", "_least", "_greatest")))
    return f"{value:.{digits}f}" + ("" if error is None else f" ± {error:.{digits}f}") + f" ({low:.{digits}f} to {high:.{digits}f})"


def causes():
    """v_0 and s of each, with the standard errors of this one run and the ranges by choices."""
    rows = []
    for name, run, how in changes_of_run_b():
        fit = profiles.fit(run, **{"count": 60, **how})
        rows.append([f"v0/(Omega R_i); s (mm), run B, Eq. 1: {name}", "0.645; 12.7", f"{with_errors(fit, 'v0_scaled', 1, 3)}; {with_errors(fit, 's', 1e3, 1)}",
                     "seed 1; standard error from blocks of frames of this run, in brackets the range by choices of the fit" if name == "as it is" else "the same"])
    return [*rows, between_packings()]


def chi_square(fits, key):
    """Per degree of freedom, of the values of packings about their mean, in the errors of each run: 1 where packings do not differ. Of those that have errors."""
    values, errors = (np.array([fit[key + end] for fit in fits], dtype=float) for end in ("", "_err"))
    known = np.isfinite(errors)
    values, errors = values[known], errors[known]
    mean = np.average(values, weights=errors**-2)
    return np.sum(((values - mean) / errors) ** 2) / (len(values) - 1)


def between_packings():
    fits = [profiles.fit(run, 60) for run in packings.packings()]
    known = sum(fit["v0_err"] is not None for fit in fits)
    return ["chi^2 per degree of freedom of v0; s of the packings, run B, Eq. 1", "-", "; ".join(f"{chi_square(fits, key):.1f}" for key in ("v0", "s")),
            f"{known} of {len(fits)} seeds whose fits have errors, all 121 snapshots, about their weighted mean, in the standard errors of one run each (the figure of the packings has 100 snapshots, and each less the mean of the others, per value); above 1: packings differ by more than one run can know"]


GROUPS["trends"] = Group("the table's trends", [run for law in LAWS for run in (run_b(law), *ladder(LAW_NAMES[law]))], trends)
GROUPS["causes"] = Group("the table's causes: what v_0 and s depend on", [*(run for _, run, _ in changes_of_run_b()), *packings.packings()], causes)
GROUPS["g2"] = Group("the table's g_2", SAMPLES, fabric_factor)
GROUPS["critical_densities"] = Group("the table's thresholds", thresholds.simulations(), thresholds.rows)
