# SPDX-License-Identifier: GPL-2.0-or-later
"""Averages as functions of time: stress and dilatancy against the strain of biaxial tests, the shear zone from the start of shear."""
import os

import numpy as np

from reproduction import profiles, sheet
from reproduction.figures import figure
from reproduction.profiles import OMEGA, R_I, cached, run, table
from reproduction.study import biaxial_tests, starts_of_shear
from student_t import mean_error

WINDOW = 10  # frames of a biaxial test
# Frames of the cell: 2 s, of which a rim turns by 0.2.
WINDOW_OF_THE_CELL = 20


def windows(simulation, name, frames, *arguments):
    """What `mikromakro average --every` says of the snapshots of a run."""
    return cached(os.path.join(simulation.folder, name),
                  lambda: run("average", os.path.join(simulation.folder, "run.h5"), *arguments, "--every", str(frames), "--quiet"))


def stress_against_strain(simulation):
    """In the middle of the sample, and at its walls."""
    return table(windows(simulation, "middle.csv", WINDOW, "--box", "0.015", "0.075", "0.015", "0.075", "--fields", "solid_fraction,stress"))


def shear_zone(simulation):
    """A row for each window; 20 rings, as the paper has them."""
    windows(simulation, "velocity.csv", WINDOW_OF_THE_CELL, "--rings", str(R_I), "0.1782", "20", "--bulk-types", "1,2", "--fields", "velocity")
    return table(cached(os.path.join(simulation.folder, "zone.csv"),
                        lambda: run("fit", os.path.join(simulation.folder, "velocity.csv"), "--ri", str(R_I), "--omega", str(OMEGA))))


def of_runs(values):
    """Means over runs and their errors, widened for their number (Student's t), for each window."""
    return np.array([mean_error(one) for one in np.transpose(values)]).T


def band(axes, x, values, colour, line="-", name=None):
    mean, error = of_runs(values)
    axes.fill_between(x, mean - error, mean + error, color=colour, alpha=0.25, lw=0)
    axes.plot(x, mean, line, color=colour, label=name)
    return {"": mean, "_err": error}


def keep(kept, name, made):
    for end, values in made.items():
        kept[name + end] = values


def stress_ratios(tests, x, y):
    return [(one[y] - one[x]) / (one[y] + one[x]) for one in tests]


@figure("dilatancy", "Stress and dilatancy against strain", biaxial_tests())
def dilatancy():
    tests = [stress_against_strain(one) for one in biaxial_tests()]
    axial = -np.mean([one["walls_strain_y"] for one in tests], axis=0)
    drawing, (left, right) = sheet.axes(columns=2)
    kept = {"axial_strain": axial}
    keep(kept, "stress_ratio_inside", band(left, 100 * axial, stress_ratios(tests, "sigma_xx", "sigma_yy"), "k", name="averaged inside"))
    keep(kept, "stress_ratio_at_walls", band(left, 100 * axial, stress_ratios(tests, "walls_pressure_right", "walls_pressure_top"), "0.5", "--", "of the walls' forces"))
    left.set(ylabel="$(\\sigma_{yy}-\\sigma_{xx})/(\\sigma_{yy}+\\sigma_{xx})$")
    left.legend()
    keep(kept, "volumetric_strain", band(right, 100 * axial, [100 * one["walls_strain_area"] for one in tests], "k", name="of the box (%)"))
    keep(kept, "solid_fraction_change", band(right, 100 * axial, [100 * (1 - one["nu"] / one["nu"][0]) for one in tests], "0.5", "--", "$1-\\nu/\\nu_0$ inside (%)"))
    right.set(ylabel="volumetric strain (%), dilatancy positive")
    right.legend()
    for axes in (left, right):
        axes.set_xlabel("axial strain (%), compression positive")
    sheet.save_picture(drawing, "dilatancy")
    sheet.save_numbers("dilatancy", kept, [f"means of {len(tests)} packings, errors of these (68 % of Student's t); volumetric strains in %"])
    return (f"{len(tests)} biaxial tests ([in.biaxial](../../inputs/biaxial/README.md) with `-var snapshot on`, other seeds): mean and standard error of the packings (68 % of Student's t) of "
            f"windows of {WINDOW} frames, each by one command, `mikromakro average run.h5 --box 0.015 0.075 0.015 0.075 --fields solid_fraction,stress --every {WINDOW}`, whose table has the "
            "walls' strains and pressures beside the stress inside. Left: stress ratio. Right: volumetric strain of the box and of the discs inside. A single run gives no errors to "
            "windows of so few frames.")


@figure("start_of_shear", "The shear zone from the start of shear", starts_of_shear())
def start_of_shear():
    zones = [shear_zone(one) for one in starts_of_shear()]
    begin = zones[0]["step_first"][0] * starts_of_shear()[0].time_step
    time = zones[0]["time"] - begin
    drawing, (left, right) = sheet.axes(columns=2)
    kept = {"time_since_start_s": time}
    for axes, column, scale, label in ((left, "v0", 1 / (OMEGA * R_I), "$v_0/(\\Omega R_i)$"), (right, "s", 1e3, "$s$ (mm)")):
        keep(kept, column, band(axes, time, [scale * one[column] for one in zones], "k", name="least squares of $v$"))
        low, high = (np.mean([scale * one[f"{column}_{end}"] for one in zones], axis=0) for end in ("least", "greatest"))
        axes.fill_between(time, low, high, color="0.9", lw=0, zorder=0, label="range of the choices")
        kept |= {f"{column}_least": low, f"{column}_greatest": high}
        axes.set(xlabel="time since the wheel began to turn (s)", ylabel=label)
    right.legend()
    sheet.save_picture(drawing, "start_of_shear")
    sheet.save_numbers("start_of_shear", kept, [f"means of {len(zones)} packings, errors of these (68 % of Student's t); v0 over Omega R_i, s in mm; least and greatest by the choices of the fit"])
    return (f"Run B under Eq. 1 from the start of shear, one turn of the wheel, {len(zones)} packings: v_0 and s of windows of {WINDOW_OF_THE_CELL} frames (2 s), with the standard error of the packings (dark band, "
            f"68 % of Student's t) and the mean range of the choices of the fit (light). `mikromakro average run.h5 --rings 0.1032 0.1782 20 --bulk-types 1,2 --fields velocity --every {WINDOW_OF_THE_CELL} --out velocity.csv && "
            "mikromakro fit velocity.csv --ri 0.1032 --omega 0.1`. " + settled(time, kept))


def settled(time, kept):
    """When s first comes to where it stays, within two errors of the packings."""
    final = mean_error(kept["s"][time > 0.5 * time[-1]])[0]
    first = np.flatnonzero(np.abs(kept["s"] - final) <= 2 * kept["s_err"])[0]
    return (f"From {kept['s'][0]:.1f} ± {kept['s_err'][0]:.1f} mm in the first window s falls to {kept['s'][first]:.1f} ± {kept['s_err'][first]:.1f} mm at {time[first]:.0f} s, within two "
            f"errors of its mean over the second half of the turn, {final:.1f} mm.")
