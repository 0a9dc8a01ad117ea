"""The two densities of section 2.4: below one the wheel has lost its contacts, above the other the sample freezes."""
import numpy as np

from reproduction import profiles, sheet
from reproduction.figures import figure
from reproduction.profiles import OMEGA
from reproduction.regimes import DENSITY, PRESSURE
from reproduction.study import CASES, ladder

# Stress-free: in more than half of the rows of wheel.txt, of 10 ms each, nothing has touched the wheel. Frozen: the second layer of discs moves
# at less than 0.15 of the wheel's angular velocity, half of what it does in run B under Eq. 1; the first layer, which rolls between the
# wheel's discs, moves at any density.
UNLOADED, FROZEN = 0.5, 0.15


def simulations():
    return [run for case in CASES for run in ladder(case)]


def states(case):
    """By density: solid fraction with half wall discs, pressure on the wheel (Pa), its error, share of time without contact, motion of the second layer."""
    states = []
    for run in ladder(case):
        pressures = profiles.wheel(run)[:, 3]
        layers = profiles.rings(run, 20)  # each as wide as a small disc
        second = layers["v_phi"][1] / (OMEGA * layers["r"][1])
        states.append((profiles.solid_fractions(run)[1], *profiles.mean_and_error(pressures), np.mean(pressures == 0), second))
    return np.array(states).T


def from_here_on(nu, holds):
    """The density above which something holds: the middle of the last at which it does not and the next, and half their distance."""
    k = np.flatnonzero(~holds)
    if len(k) == 0:
        return f"below {nu[0]:.4f}"
    return f"above {nu[-1]:.4f}" if k[-1] == len(nu) - 1 else f"{0.5 * (nu[k[-1]] + nu[k[-1] + 1]):.4f} ± {0.5 * (nu[k[-1] + 1] - nu[k[-1]]):.4f}"


def thresholds(case):
    nu, _, _, free, second = states(case)
    return [from_here_on(nu, free < UNLOADED), from_here_on(nu, second < FROZEN)]


def rows():
    """For the table: both thresholds of every case."""
    remarks = ("below: nothing touches the wheel for more than half of the time", "above: the second layer moves at less than 0.15 of the wheel")
    found = {case: thresholds(case) for case in CASES}
    return [[f"{name} density, {case}", "-", found[case][k], remarks[k]] for k, name in enumerate(("stress-free", "frozen")) for case in CASES]


@figure("thresholds", "The thresholds of section 2.4", simulations())
def draw_thresholds():
    drawing, (left, right) = sheet.axes(columns=2, sharex=True)
    kept = {}
    for k, (case, colour) in enumerate(zip(CASES, sheet.shades(len(CASES)))):
        nu, pressure, error, free, second = states(case)
        style = {"marker": sheet.MARKERS[k], "color": colour, "ms": 5, "lw": 0.8, "label": case}
        left.errorbar(nu, pressure, error, **style)
        # Of a wheel without contacts the discs may have any velocity.
        right.plot(nu[free < UNLOADED], second[free < UNLOADED], **style)
        kept |= {f"nu, {case}": nu, f"wheel_pressure_Pa, {case}": pressure, f"wheel_pressure_Pa_err, {case}": error, f"time_without_contact, {case}": free,
                 f"second_layer, {case}": second}
    left.set(xlabel=DENSITY, ylabel=PRESSURE, yscale="log")
    right.axhline(FROZEN, color="k", ls=":", lw=0.8)
    right.set(xlabel=DENSITY, ylabel="$v_\\phi/(\\Omega r)$ of the second layer", ylim=(0, None))
    left.legend()
    sheet.save_picture(drawing, "thresholds")
    sheet.save_numbers("thresholds", kept, ["means over a third of a turn, of run B over 60 s; errors of ten blocks"])
    return ("Pressure on the wheel (left), and the angular velocity of the second layer of discs over that of the wheel (right), over the density of the cell: "
            + "; ".join(f"{case}: {low} and {high}" for case, (low, high) in ((case, thresholds(case)) for case in CASES))
            + " (the density up to which it is stress-free and that from which on it is frozen: the middle between two densities of one packing each, and half of their "
            "distance; packings differ by more under the springs, where the pressure jumps with the first density that carries a load, and the second layer slows down little by little). Stress-free: nothing touches the wheel in more than half of all intervals of "
            "10 ms; these points are left out on the right. Frozen: the second layer moves at less than 0.15 of the wheel (dotted), half of its rate in run B. "
            "One packing for each density; but for run B a third of a turn is discarded and a third averaged.")
