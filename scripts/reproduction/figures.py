# SPDX-License-Identifier: GPL-2.0-or-later
"""The figures of the paper, one function each: what it needs, what it draws, what it says."""
import dataclasses

import numpy as np

from reproduction import profiles, sheet
from reproduction.profiles import DIAMETER, HEIGHT, K_N, OMEGA, R_I, R_O, from_wheel
from reproduction.simulations import couette
from reproduction.study import LAWS, RUNS, densities

LAW_NAMES = {"viscous": "Eq. 1", "cundall_strack": "spring"}
DENSITY = "$\\bar\\nu$ with half\nwall discs"
FROM_WHEEL = "distance from the wheel $r - R_i$ (mm)"


@dataclasses.dataclass
class Figure:
    title: str
    simulations: list
    draw: object  # () -> caption


FIGURES = {}


def figure(name, title, simulations):
    """Registers a function that draws the figure of this name and gives the sentences below it."""

    def register(draw):
        FIGURES[name] = Figure(title, simulations, draw)
        return draw

    return register


def label(simulation):
    return f"{profiles.solid_fractions(simulation)[1]:.4f}"


def run_b(law="viscous"):
    return couette(*RUNS["B"], law)


def legend_beside(one):
    one.legend(title=DENSITY, loc="upper left", bbox_to_anchor=(1.01, 1))


def over_densities(name, law, draw_one, panels, numbers):
    """A row of panels with a line for each density of a law; `draw_one` draws it, `numbers` name the columns that are kept."""
    drawing, sheets = sheet.axes(columns=panels)
    kept = {}
    runs = densities(law)
    for k, (run, colour) in enumerate(zip(runs, sheet.shades(len(runs)))):
        columns = profiles.rings(run, 60)
        style = {"color": colour, "marker": sheet.MARKERS[k % len(sheet.MARKERS)], "ms": 3, "lw": 0.8, "label": label(run)}
        draw_one(np.atleast_1d(sheets), columns, style)
        kept.setdefault("r_m", columns["r"])
        for column in numbers:
            kept[f"{column}_nu{label(run)}"] = columns[column]
            kept[f"{column}_nu{label(run)}_err"] = columns[f"{column}_err"]
    for one in np.atleast_1d(sheets):
        one.set_xlabel(one.get_xlabel() or FROM_WHEEL)
    legend_beside(np.atleast_1d(sheets)[-1])
    sheet.save_picture(drawing, name)
    sheet.save_numbers(name, kept, [f"law {LAW_NAMES[law]}, 60 rings; SI units; standard errors from blocks of frames"])


@figure("bild4", "Bild 4: density of discs with m or more contacts", [run_b()])
def bild4():
    drawing, one = sheet.axes()
    coarse, fine = profiles.rings(run_b(), 20), profiles.rings(run_b(), 150)
    kept = {}
    for m, colour in enumerate(sheet.shades(4)):
        name = "nu" if m == 0 else f"nu_{m}"
        one.plot(from_wheel(fine), fine[name], color=colour, lw=0.9)
        one.plot(from_wheel(coarse), coarse[name], sheet.MARKERS[m], color=colour, ms=4, label=f"$\\nu_{m}$")
        kept |= {f"{name}_150_rings": fine[name], f"{name}_20_rings": coarse[name]}
    one.set(xlabel=FROM_WHEEL, ylabel="solid fraction", ylim=(0, 1))
    one.legend(ncols=4, loc="lower center")
    sheet.save_picture(drawing, "bild4")
    sheet.save_numbers("bild4", {"r_m_150_rings": fine["r"], "r_m_20_rings": coarse["r"], **kept}, ["run B, law Eq. 1"])
    return ("Solid fraction of the discs with m or more contacts, run B under Eq. 1, over the distance from the wheel. Symbols: 20 rings; lines: "
            "150 rings. The oscillations at high resolution are layers of discs at the two rings; the shear zone is dilated, and most of its "
            "discs have no contact at a given moment.")


@figure("bild5", "Bild 5: velocity", [run for law in LAWS for run in densities(law)])
def bild5():
    drawing, (left, right) = sheet.axes(columns=2)
    run = run_b()
    for count, marker, face in ((20, "o", "k"), (60, "s", "none")):
        columns = profiles.rings(run, count)
        left.semilogy(from_wheel(columns), columns["v_phi"] / (OMEGA * columns["r"]), marker, mfc=face, mec="k", ms=4, label=f"{count} rings")
    r = np.linspace(R_I, R_O, 200)
    ours = profiles.fit(run, 60)
    for v0, s, line, name in ((ours["v0_scaled"], ours["s"], "k-", "fit to 60 rings"), (0.645, 0.0127, "k--", "fit of the paper")):
        left.semilogy(1e3 * (r - R_I), v0 * R_I * np.exp(-(r - R_I) / s) / r, line, label=f"{name}: {v0:.3f}, {1e3 * s:.1f} mm")
    left.set(xlabel=FROM_WHEEL, ylabel="$v_\\phi/(\\Omega r)$", ylim=(1e-4, 2), title="run B, Eq. 1: $v_0/(\\Omega R_i)$, $s$")
    left.legend()
    kept = {}
    for law, marker, face in (("viscous", "o", "k"), ("cundall_strack", "s", "w")):
        fits = [profiles.fit(one, 60) for one in densities(law)]
        nu = np.array([profiles.solid_fractions(one)[1] for one in densities(law)])
        middle = np.array([one["v0_scaled"] for one in fits])
        # Without an interval: None, which becomes nan.
        interval = np.abs(np.array([[one["v0_scaled_low"], one["v0_scaled_high"]] for one in fits], dtype=float) - middle[:, None]).T
        right.errorbar(nu, middle, interval, fmt=marker, mfc=face, mec="k", ecolor="k", ms=5, label=f"$v_0/(\\Omega R_i)$, {LAW_NAMES[law]}")
        s = np.array([one["s"] for one in fits])
        right.plot(nu, 20 * s, "v" if face == "k" else "^", color="0.5", mfc=face if face == "w" else "0.5", ms=5, label=f"$s$ / 50 mm, {LAW_NAMES[law]}")
        kept |= {f"nu_{law}": nu, f"v0_scaled_{law}": middle, f"s_m_{law}": s}
    right.axhline(0.645, color="k", ls="--", lw=0.8)
    right.axhline(20 * 0.0127, color="0.5", ls="--", lw=0.8)
    right.set(xlabel="$\\bar\\nu$ with half of the wall discs", ylabel="$v_0/(\\Omega R_i)$, $s$/(50 mm)", title="all densities; dashed: paper", ylim=(-0.05, 1.5))
    right.legend()
    sheet.save_picture(drawing, "bild5")
    sheet.save_numbers("bild5", kept, ["exponential fits of v_phi on 60 rings"])
    return ("Left: mean velocity over that of the rigid rotation, run B under Eq. 1, with 20 and 60 rings, and the exponential fitted to it beside the "
            "paper's. Right: both constants of the fit for all densities and both laws; bars are intervals of 95 % from the blocks of frames of a run; "
            "packings and choices of the fit differ by more. Where the wheel has lost its contacts, or only slips on a frozen packing, an exponential has no meaning.")


def stress_like(name, tensor, unit, sign):
    def draw_one(sheets, columns, style):
        trace = columns[f"{tensor}_rr"] + columns[f"{tensor}_phiphi"]
        sheets[0].semilogy(from_wheel(columns), sign * trace, **style)
        sheets[1].semilogy(from_wheel(columns), columns[f"dev_{tensor}"], **style)
        sheets[0].set_ylabel(f"{'-' if sign < 0 else ''}tr ${unit[0]}${unit[1]}")
        sheets[1].set_ylabel(f"dev ${unit[0]}${unit[1]}")

    over_densities(name, "viscous", draw_one, 2, [f"{tensor}_rr", f"{tensor}_phiphi", f"dev_{tensor}"])


@figure("bild7", "Bild 7: isotropic and deviatoric stress", densities("viscous"))
def bild7():
    stress_like("bild7", "sigma", ("\\sigma", " (Pa)"), -1)
    return "Trace (left) and deviator (right) of the stress over 60 rings under Eq. 1, a line for each density; compression positive here."


@figure("bild8", "Bild 8: isotropic and deviatoric elastic strain", densities("viscous"))
def bild8():
    stress_like("bild8", "eps", ("\\epsilon", ""), -1)
    return "Trace (left) and deviator (right) of the best-fit elastic displacement gradient (Eq. 20) over 60 rings under Eq. 1; compression positive here."


def over_fabric(name, column, ylabel, scale, limit):
    drawing, sheets = sheet.axes(columns=2, sharey=True)
    kept = {}
    for law, one in zip(LAWS, sheets):
        runs = densities(law)
        for k, (run, colour) in enumerate(zip(runs, sheet.shades(len(runs)))):
            columns = profiles.rings(run, 150)
            fabric = columns["F_rr"] + columns["F_phiphi"]
            scaled = scale * columns[column]
            one.plot(fabric, scaled, sheet.MARKERS[k % len(sheet.MARKERS)], color=colour, ms=3, label=label(run))
            kept |= {f"trF_{law}_nu{label(run)}": fabric, f"{column}_{law}_nu{label(run)}": scaled}
        one.plot([0, 4.5], [0, 4.5], "k--", lw=0.8, label="slope 1")
        one.set(xlabel="tr F", ylabel=ylabel, title=LAW_NAMES[law], ylim=(0, limit), xlim=(0, 4.2))
    legend_beside(sheets[1])
    sheet.save_picture(drawing, name)
    sheet.save_numbers(name, kept, [f"{ylabel}; 150 rings"])


@figure("bild9", "Bild 9: stiffness", [run for law in LAWS for run in densities(law)])
def bild9():
    # E is in units of k_n/h already.
    over_fabric("bild9", "E", "$2\\pi E h/k_n$", 2 * np.pi, 5)
    return ("Stiffness tr sigma/tr eps over the trace of the fabric tensor, one symbol for each of 150 rings of each density: the points fall on one line. "
            "The identity of docs/conventions.md makes its slope 1 for an isotropic fabric.")


@figure("bild10", "Bild 10: shear modulus", [run for law in LAWS for run in densities(law)])
def bild10():
    over_fabric("bild10", "G", "$\\pi G h/k_n$", np.pi, 8)
    return "Shear modulus dev sigma/dev eps over the trace of the fabric tensor, 150 rings of each density; where the sample is too dense to be sheared, G diverges."


@figure("bild11", "Bild 11: spin density and excess rotation", densities("viscous"))
def bild11():
    def draw_one(sheets, columns, style):
        sheets[0].plot(from_wheel(columns), columns["nu"] * columns["spin"], **style)
        sheets[1].plot(from_wheel(columns), columns["omega_excess"], **style)
        sheets[0].set(ylabel="spin density $\\nu\\omega$ (1/s)", xlim=(0, 60))
        sheets[1].set(ylabel="$\\omega^* = \\omega - W_{r\\phi}$ (1/s)", xlim=(0, 60))

    over_densities("bild11", "viscous", draw_one, 2, ["spin", "omega_excess"])
    return "Spin density (left) and excess rotation (right) near the wheel, 60 rings, Eq. 1: the sign alternates between the first two layers; farther out the excess is not told from 0."


@figure("bild12", "Bild 12: rotational stiffness", densities("cundall_strack"))
def bild12():
    def draw_one(sheets, columns, style):
        sheets[0].semilogy((columns["r"] - R_I) / DIAMETER, columns["mu_c"] * HEIGHT / K_N, **style)
        sheets[0].set(ylabel="$\\mu_c h/k_n$", xlabel="$(r - R_i)/d$, $d$ = 7.63 mm")

    over_densities("bild12", "cundall_strack", draw_one, 1, ["mu_c"])
    return ("Rotational stiffness over the distance from the wheel for each density, law with a spring, in units of k_n/h.")


@figure("angles", "Directions of stress, strain and fabric", [run_b(law) for law in LAWS])
def angles():
    drawing, sheets = sheet.axes(columns=2, sharey=True)
    kept = {}
    for law, one in zip(LAWS, sheets):
        columns = profiles.rings(run_b(law), 60)
        kept["r_m"] = columns["r"]
        for name, tensor, marker, colour in (("$\\sigma$", "sigma", "o", "k"), ("$\\epsilon$", "eps", "s", "0.45"), ("F", "F", "^", "0.7")):
            one.errorbar(from_wheel(columns), columns[f"angle_{tensor}"], columns[f"angle_{tensor}_err"], fmt=marker, color=colour, ms=3, lw=0.6, label=name)
            kept |= {f"angle_{tensor}_{law}": columns[f"angle_{tensor}"], f"angle_{tensor}_{law}_err": columns[f"angle_{tensor}_err"]}
        one.set(xlabel=FROM_WHEEL, ylabel="major axis from $e_r$ (degrees)", title=f"run B, {LAW_NAMES[law]}", ylim=(0, 95))
    sheets[0].legend()
    sheet.save_picture(drawing, "angles")
    sheet.save_numbers("angles", kept, ["degrees, counter-clockwise from e_r; 60 rings"])
    return "Direction of the major axes of stress, elastic strain and fabric over the distance from the wheel: the three tensors are not co-linear."


@figure("gradients", "Velocity gradient", [run_b()])
def gradients():
    drawing, one = sheet.axes()
    columns = profiles.rings(run_b(), 60)
    for name, marker, colour in (("D_rphi", "o", "k"), ("W_rphi", "s", "0.55")):
        one.plot(from_wheel(columns), columns[name], marker, color=colour, ms=3, label=f"${name[0]}_{{r\\phi}}$, differences")
        one.plot(from_wheel(columns), columns[f"{name}_fit"], color=colour, label=f"${name[0]}_{{r\\phi}}$, fit")
    one.set(xlabel=FROM_WHEEL, ylabel="rate (1/s)", xlim=(0, 80))
    one.legend()
    sheet.save_picture(drawing, "gradients")
    names = ("D_rphi", "W_rphi", "D_rphi_fit", "W_rphi_fit")
    sheet.save_numbers("gradients", {"r_m": columns["r"], **{name: columns[name] for name in names}}, ["1/s; run B, Eq. 1, 60 rings"])
    return "Rate of deformation and of rotation, run B under Eq. 1: from differences of the mean velocity on 60 rings, and from the exponential fitted to it."
