"""The regimes of section 2.4, the wall that the paper does not print, and how quasi-static the shear is."""
import numpy as np

from reproduction import profiles, sheet
from reproduction.figures import FROM_WHEEL, figure, run_b
from reproduction.profiles import OMEGA, from_wheel
from reproduction.study import CASES, PITCHES, ladder, pitches, slow_run

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


def between(nu, holds):
    """The density at which something begins to hold: the middle of the two between which it does, and half their distance."""
    k = np.flatnonzero(holds[1:] != holds[:-1])
    return None if len(k) == 0 else (0.5 * (nu[k[0]] + nu[k[0] + 1]), 0.5 * (nu[k[0] + 1] - nu[k[0]]))


def thresholds(case):
    nu, _, _, free, second = states(case)
    for found in (between(nu, free < UNLOADED), between(nu, (free < UNLOADED) & (second < FROZEN))):
        yield f"{found[0]:.4f} ± {found[1]:.4f}" if found else f"outside of {nu[0]:.4f} to {nu[-1]:.4f}"


def rows():
    """For the table: both thresholds of every case."""
    remarks = ("below: nothing touches the wheel for more than half of the time", "above: the second layer moves at less than 0.15 of the wheel")
    found = {case: list(thresholds(case)) for case in CASES}
    return [[f"{name} density, {case}", "-", found[case][k], remarks[k]] for k, name in enumerate(("stress-free", "frozen")) for case in CASES]


@figure("regimes", "The regimes of section 2.4", simulations())
def regimes():
    drawing, (left, right) = sheet.axes(columns=2)
    kept = {}
    for k, (case, colour) in enumerate(zip(CASES, sheet.shades(len(CASES)))):
        nu, pressure, error, free, second = states(case)
        style = {"marker": sheet.MARKERS[k], "color": colour, "ms": 5, "lw": 0.8, "label": case}
        left.errorbar(nu, pressure, error, **style)
        # Of a wheel without contacts the discs may have any velocity.
        right.plot(nu[free < UNLOADED], second[free < UNLOADED], **style)
        kept |= {f"nu, {case}": nu, f"wheel_pressure_Pa, {case}": pressure, f"wheel_pressure_Pa_err, {case}": error, f"time_without_contact, {case}": free,
                 f"second_layer, {case}": second}
    left.set(xlabel="$\\bar\\nu$ with half of the wall discs", ylabel="pressure on the wheel (Pa)", yscale="log")
    right.axhline(FROZEN, color="k", ls=":", lw=0.8)
    right.set(xlabel="$\\bar\\nu$ with half of the wall discs", ylabel="$v_\\phi/(\\Omega r)$ of the second layer", ylim=(0, None))
    left.legend()
    sheet.save_picture(drawing, "regimes")
    sheet.save_numbers("regimes", kept, ["means over the second 20.94 s (a third of a turn) of shear; errors of blocks of 2 s"])
    return ("Pressure on the wheel (left), and the angular velocity of the second layer of discs over that of the wheel (right), over the density of the cell, for "
            "both laws, with and without friction on the bottom, and for three stiffnesses of the spring (0.8 where none is given). Below the stress-free density "
            "nothing touches the wheel for more than half of the time (in rows of 10 ms; these points are left out on the right); above the frozen one (dotted) the "
            "second layer hardly moves: the wheel slips. The thresholds are in the table.")


@figure("pitch", "Which wall?", pitches())
def pitch():
    drawing, (left, right) = sheet.axes(columns=2)
    kept, found = {}, []
    for k, (distance, run) in enumerate(zip(PITCHES, pitches())):
        columns, fit = profiles.rings(run, 60), profiles.fit(run, 60)
        style = {"color": sheet.shades(4)[k], "marker": sheet.MARKERS[k], "ms": 3, "lw": 0.8, "label": f"{1e3 * distance:g} mm"}
        left.semilogy(from_wheel(columns), columns["v_phi"] / (OMEGA * columns["r"]), **style)
        right.plot(from_wheel(columns), columns["omega_excess"], **style)
        kept |= {"r_m": columns["r"], f"v_phi_{1e3 * distance:g}mm": columns["v_phi"], f"omega_excess_{1e3 * distance:g}mm": columns["omega_excess"]}
        found.append(f"{1e3 * distance:g} mm: {fit['v0_scaled']:.3f}, {1e3 * fit['s']:.1f} mm")
    left.set(xlabel=FROM_WHEEL, ylabel="$v_\\phi/(\\Omega r)$", ylim=(1e-4, 2))
    right.set(xlabel=FROM_WHEEL, ylabel="$\\omega^*$ (1/s)", xlim=(0, 50))
    left.legend(title="distance of wall discs")
    sheet.save_picture(drawing, "pitch")
    sheet.save_numbers("pitch", kept, ["run B, Eq. 1, 60 rings; SI units"])
    return ("Run B under Eq. 1 with wall discs at four distances. v_0/(Omega R_i) and s of the exponential: " + "; ".join(found) + ". The paper has 0.645 and 12.7 mm.")


@figure("slow", "How quasi-static is it?", [run_b(), slow_run()])
def slow():
    drawing, (left, right) = sheet.axes(columns=2)
    kept, found = {}, []
    for run, omega, marker, face in ((run_b(), OMEGA, "o", "k"), (slow_run(), 0.02, "s", "w")):
        columns, fit = profiles.rings(run, 60), profiles.fit(run, 60, omega)
        name = f"{omega:g} 1/s"
        left.semilogy(from_wheel(columns), columns["v_phi"] / (omega * columns["r"]), marker, color="k", mfc=face, ms=4, label=name)
        right.errorbar(from_wheel(columns), -columns["tr_sigma"], columns["tr_sigma_err"], fmt=marker, color="k", mfc=face, ms=4, lw=0.6, label=name)
        kept |= {"r_m": columns["r"], f"v_scaled_{omega:g}": columns["v_phi"] / (omega * columns["r"]), f"tr_sigma_{omega:g}": columns["tr_sigma"]}
        found.append(f"{name}: {fit['v0_scaled']:.3f}, {1e3 * fit['s']:.1f} mm")
    left.set(xlabel=FROM_WHEEL, ylabel="$v_\\phi/(\\Omega r)$", ylim=(1e-4, 2))
    right.set(xlabel=FROM_WHEEL, ylabel="-tr $\\sigma$ (Pa)", yscale="log")
    left.legend(title="rate of the wheel")
    sheet.save_picture(drawing, "slow")
    sheet.save_numbers("slow", kept, ["run B, Eq. 1, 60 rings; SI units"])
    return "Run B under Eq. 1 at the paper's rate and at a fifth of it, over the same angles. v_0/(Omega R_i) and s: " + "; ".join(found) + "."
