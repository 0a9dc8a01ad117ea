# SPDX-License-Identifier: GPL-2.0-or-later
"""The regimes of section 2.4, the wall that the paper does not print, and how quasi-static the shear is."""
import numpy as np

from reproduction import profiles, sheet
from reproduction.figures import FROM_WHEEL, LAW_NAMES, figure, run_b
from reproduction.profiles import OMEGA, from_wheel
from reproduction.study import LAWS, PITCHES, densities, pitches, slow_run

DENSITY, PRESSURE = "$\\bar\\nu$ with half of the wall discs", "pressure on the wheel (Pa)"


@figure("regimes", "The regimes of section 2.4", [run for law in LAWS for run in densities(law)])
def regimes():
    drawing, (left, right) = sheet.axes(columns=2)
    kept, balances, free = {}, [], []
    for law, marker, face in zip(LAWS, "os", ("k", "w")):
        pressures = [profiles.wheel(run)[:, 3] for run in densities(law)]
        pressure, error = np.array([profiles.mean_and_error(one) for one in pressures]).T
        nu = np.array([profiles.solid_fractions(run)[1] for run in densities(law)])
        torques = np.array([profiles.wheel(run)[:, 1:3].mean(axis=0) for run in densities(law)])
        balance = np.abs(torques.sum(axis=1) / torques[:, 0])
        balances.extend(100 * balance)
        free.extend(np.mean(one == 0) for one in pressures)
        v0 = np.array([profiles.fit(run, 60)["v0_scaled"] for run in densities(law)])
        left.errorbar(nu, pressure, error, fmt=marker + "-", color="k", mfc=face, ms=5, lw=0.8, label=LAW_NAMES[law])
        right.plot(nu, v0, marker + "-", color="k", mfc=face, ms=5, lw=0.8, label=LAW_NAMES[law])
        kept |= {f"nu_{law}": nu, f"wheel_pressure_Pa_{law}": pressure, f"wheel_pressure_Pa_{law}_err": error, f"v0_scaled_{law}": v0,
                 f"torque_wheel_N_m_{law}": torques[:, 0], f"torque_ring_N_m_{law}": torques[:, 1]}
    left.set(xlabel=DENSITY, ylabel=PRESSURE, yscale="log")
    right.set(xlabel=DENSITY, ylabel="$v_0/(\\Omega R_i)$ of the exponential", ylim=(-0.05, None))
    left.legend()
    sheet.save_picture(drawing, "regimes")
    sheet.save_numbers("regimes", kept, ["means over 60 s; errors of blocks of 6 s"])
    carries = np.array(free) < 0.5
    balances = np.array(balances)
    return ("Pressure on the wheel and v_0 over the density of the cell, for both laws. The densities below which the wheel loses its contacts and above which "
            f"the sample freezes are in the figure of the thresholds. The torques on wheel and ring, means over 60 s, balance within "
            f"{balances[carries].max():.1f} % where something touches the wheel for more than half of the time, and within {balances[~carries].max():.1f} % where the cell is "
            "stress-free.")


@figure("pitch", "Which wall?", pitches())
def pitch():
    drawing, (left, right) = sheet.axes(columns=2)
    kept, found, v0, alternating = {}, [], {}, []
    for k, (distance, run) in enumerate(zip(PITCHES, pitches())):
        columns, fit = profiles.rings(run, 60), profiles.fit(run, 60)
        style = {"color": sheet.shades(4)[k], "marker": sheet.MARKERS[k], "ms": 3, "lw": 0.8, "label": f"{1e3 * distance:g} mm"}
        left.semilogy(from_wheel(columns), columns["v_phi"] / (OMEGA * columns["r"]), **style)
        right.plot(from_wheel(columns), columns["omega_excess"], **style)
        kept |= {"r_m": columns["r"], f"v_phi_{1e3 * distance:g}mm": columns["v_phi"], f"omega_excess_{1e3 * distance:g}mm": columns["omega_excess"]}
        layers = columns["omega_excess"][profiles.middles_of_layers(columns, 2)]
        v0[1e3 * distance] = fit["v0_scaled"]
        alternating += [f"{1e3 * distance:g}"] if layers[0] * layers[1] < 0 else []
        found.append(f"{1e3 * distance:g} mm: {fit['v0_scaled']:.3f}, {1e3 * fit['s']:.1f} mm, {layers[0]:+.3f}, {layers[1]:+.3f} 1/s")
    left.set(xlabel=FROM_WHEEL, ylabel="$v_\\phi/(\\Omega r)$", ylim=(1e-4, 2))
    right.set(xlabel=FROM_WHEEL, ylabel="$\\omega^*$ (1/s)", xlim=(0, 50))
    left.legend(title="distance of wall discs")
    sheet.save_picture(drawing, "pitch")
    sheet.save_numbers("pitch", kept, ["run B, Eq. 1, 60 rings; SI units"])
    return ("Run B under Eq. 1 with wall discs at four distances. v_0/(Omega R_i) and s of the exponential, omega^* in the middles of the first two layers: " + "; ".join(found)
            + f". The paper has 0.645 and 12.7 mm, and a spin whose sign alternates. Nearest to its v_0: {min(v0, key=lambda one: abs(v0[one] - 0.645)):g} mm; "
            f"the sign alternates at {', '.join(alternating) or 'none of these'} mm.")


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
