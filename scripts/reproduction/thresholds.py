# SPDX-License-Identifier: GPL-2.0-or-later
"""The two densities of section 2.4: below one the wheel has lost its contacts, above the other the sample freezes."""
import numpy as np

from reproduction import profiles, sheet
from reproduction.figures import figure
from reproduction.profiles import OMEGA
from reproduction.regimes import DENSITY, PRESSURE
from reproduction.study import CASES, packings

# Stress-free: in more than half of the rows of wheel.txt, of 10 ms each, nothing has touched the wheel. Frozen: the second layer of discs moves
# at less than 0.15 of the wheel's angular velocity, half of what it does in run B under Eq. 1; the first layer, which rolls between the
# wheel's discs, moves at any density.
UNLOADED, FROZEN = 0.5, 0.15


def simulations():
    return [run for case in CASES for runs in packings(case) for run in runs]


def of_packings(values):
    """Mean and standard error, which is nan of a single packing."""
    return np.mean(values), np.std(values, ddof=1) / np.sqrt(len(values)) if len(values) > 1 else np.nan


def second_layer(run):
    """Its angular velocity over that of the wheel."""
    layers = profiles.rings(run, 20)  # each as wide as a small disc
    return layers["v_phi"][1] / (OMEGA * layers["r"][1])


def states(case):
    """By density: solid fraction with half wall discs, pressure on the wheel (Pa), its error, share of time without contact, motion of the second layer,
    its error."""
    states = []
    for runs in packings(case):
        pressures = [profiles.wheel(run)[:, 3] for run in runs]
        pressure = of_packings([one.mean() for one in pressures]) if len(runs) > 1 else profiles.mean_and_error(pressures[0])
        states.append((profiles.solid_fractions(runs[0])[1], *pressure, np.mean([np.mean(one == 0) for one in pressures]),
                       *of_packings([second_layer(run) for run in runs])))
    return np.array(states).T


def from_here_on(nu, holds):
    """The density above which something holds: the middle of the last at which it does not and the next, and half their distance."""
    k = np.flatnonzero(~holds)
    if len(k) == 0:
        return f"below {nu[0]:.4f}"
    return f"above {nu[-1]:.4f}" if k[-1] == len(nu) - 1 else f"{0.5 * (nu[k[-1]] + nu[k[-1] + 1]):.4f} ± {0.5 * (nu[k[-1] + 1] - nu[k[-1]]):.4f}"


def thresholds(case):
    nu, _, _, free, second, _ = states(case)
    return [from_here_on(nu, free < UNLOADED), from_here_on(nu, second < FROZEN)]


def rows():
    """For the table: both thresholds of every case."""
    remarks = ("below: nothing touches the wheel for more than half of the time; ± half the distance of the two densities between which it lies, no standard error", "above: the second layer moves at less than 0.15 of the wheel; ± half the distance of the two densities between which it lies, no standard error")
    found = {case: thresholds(case) for case in CASES}
    return [[f"{name} density, {case}", "-", found[case][k], remarks[k]] for k, name in enumerate(("stress-free", "frozen")) for case in CASES]


@figure("thresholds", "The thresholds of section 2.4", simulations())
def draw_thresholds():
    drawing, (left, right) = sheet.axes(columns=2, sharex=True)
    kept = {}
    for k, (case, colour) in enumerate(zip(CASES, sheet.shades(len(CASES)))):
        nu, pressure, error, free, second, second_error = states(case)
        style = {"marker": sheet.MARKERS[k], "color": colour, "ms": 5, "lw": 0.8, "label": case}
        left.errorbar(nu, pressure, error, **style)
        # Of a wheel without contacts the discs may have any velocity.
        loaded = free < UNLOADED
        right.errorbar(nu[loaded], second[loaded], np.nan_to_num(second_error[loaded]), **style)
        kept |= {f"nu, {case}": nu, f"wheel_pressure_Pa, {case}": pressure, f"wheel_pressure_Pa_err, {case}": error, f"time_without_contact, {case}": free,
                 f"second_layer, {case}": second, f"second_layer_err, {case}": second_error}
    left.set(xlabel=DENSITY, ylabel=PRESSURE, yscale="log")
    right.axhline(FROZEN, color="k", ls=":", lw=0.8)
    right.set(xlabel=DENSITY, ylabel="$v_\\phi/(\\Omega r)$ of the second layer", ylim=(0, None))
    left.legend()
    sheet.save_picture(drawing, "thresholds")
    sheet.save_numbers("thresholds", kept, ["means over a third of a turn, of run B over 60 s; errors of three packings, of the pressures of a single one those of ten blocks"])
    return ("Pressure on the wheel (left), and the angular velocity of the second layer of discs over that of the wheel (right), over the density of the cell: "
            + "; ".join(f"{case}: {low} and {high}" for case, (low, high) in ((case, thresholds(case)) for case in CASES))
            + " (the density up to which it is stress-free and that from which on it is frozen: the middle between two densities ± half of their "
            "distance, which is no standard error). Stress-free: nothing touches the wheel in more than half of all intervals of "
            "10 ms; these points are left out on the right. Frozen: the second layer moves at less than 0.15 of the wheel (dotted), half of its rate in run B. "
            "Under the springs the pressure jumps with the first density that carries a load, and from there on packings differ: means and standard errors of three there, one "
            "elsewhere. But for run B a third of a turn is discarded and a third averaged.")
