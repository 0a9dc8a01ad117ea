"""docs/results/README.md: the table of the paper's numbers beside ours, and the figures with their captions."""
import json
import os

import numpy as np

from reproduction import profiles
from reproduction import fabric, pictures, regimes  # noqa: F401, they register their figures
from reproduction.figures import FIGURES, LAW_NAMES, run_b
from reproduction.profiles import HEIGHT, OMEGA, R_I, R_O, from_wheel
from reproduction.sheet import RESULTS
from reproduction.simulations import couette
from reproduction.study import LAWS, RUNS, SEEDS, densities

KEPT = os.path.join(RESULTS, "captions.json")
TABLE = os.path.join(RESULTS, "table.md")


def over_seeds(values):
    """Mean and standard error of independent runs."""
    return np.mean(values), np.std(values, ddof=1) / np.sqrt(len(values))


def runs_b(law):
    """Run B with all its seeds."""
    return [couette(*RUNS["B"], law, seed) for seed in SEEDS]


SIMULATIONS = [run for law in LAWS for run in (*densities(law), *runs_b(law))]


def row(quantity, paper, ours, error, remark, digits=3):
    measured = "-" if ours is None else f"{ours:.{digits}f}" + ("" if error is None else f" ± {error:.{digits}f}")
    off = f"{(ours - paper) / error:+.1f}" if None not in (paper, ours, error) else "-"
    return f"| {quantity} | {'-' if paper is None else paper} | {measured} | {off} | {remark} |"


def constant_part(columns):
    """Rings that are not at the rings of wall discs."""
    distance = from_wheel(columns)
    return (distance > 8) & (distance < 1e3 * (R_O - R_I) - 8)


def scatter(values):
    return np.std(values) / np.abs(np.mean(values))


def profile_rows(law):
    """What the table says about run B under a law, means and errors over its seeds."""
    name = LAW_NAMES[law]
    fits = [profiles.fit(run, 60) for run in runs_b(law)]
    rings = [profiles.rings(run, 60) for run in runs_b(law)]
    inner = constant_part(rings[0])
    yield row(f"v0/(Omega R_i), run B, {name}", 0.645, *over_seeds([one["v0_scaled"] for one in fits]), "exponential on 60 rings")
    yield row(f"s (mm), run B, {name}", 12.7, *over_seeds([1e3 * one["s"] for one in fits]), "the same", 1)
    for rate, sign, paper in (("D", 1, -0.294), ("W", -1, -0.230)):
        # Of v0 exp(-(r - R_i)/s) at R_i: (dv/dr -+ v/r)/2.
        ours = [0.5 * (-one["v0"] / one["s"] - sign * one["v0"] / R_I) for one in fits]
        yield row(f"{rate}_rphi at R_i (1/s), {name}", paper, *over_seeds(ours), "of the fit; the paper's fit gives its value")
    yield row(f"scatter of tr sigma over r, {name}", None, *over_seeds([scatter(c["tr_sigma"][inner]) for c in rings]),
              "rms over mean, 8 mm from the rings on; the paper: nearly constant")
    yield row(f"scatter of r^2 sigma_phir over r, {name}", None,
              *over_seeds([scatter((c["r"] ** 2 * c["sigma_phir"])[inner]) for c in rings]), "0 by balance of the torque")
    slopes = []
    for run in runs_b(law):
        c = profiles.rings(run, 150)
        good = np.isfinite(c["E"]) & (c["tr_F"] > 0.5)
        slopes.append(np.sum(2 * np.pi * c["E"][good] * c["tr_F"][good]) / np.sum(c["tr_F"][good] ** 2))
    yield row(f"slope of 2 pi E h/k_n over tr F, {name}", None, *over_seeds(slopes),
              "150 rings; one line for all densities in the paper; identity: 1 for an isotropic fabric, up to 1.07", 4)
    layers = np.mean([np.interp(np.arange(3.71, 26, 7.42), from_wheel(c), c["omega_excess"]) for c in rings], axis=0)
    yield row(f"signs of omega_excess in the first layers, {name}", None, None, None,
              "alternate in the paper; here " + " ".join("+" if value > 0 else "-" for value in layers))


def torque_rows():
    for law in LAWS:
        ratios = []
        for run in runs_b(law):
            c = profiles.rings(run, 60)
            inner = constant_part(c)
            torque = profiles.wheel(run)[:, 1].mean()
            ratios.append(np.mean((2 * np.pi * c["r"] ** 2 * HEIGHT * c["sigma_phir"])[inner]) / torque)
        yield row(f"2 pi r^2 h sigma_phir over the wheel torque, {LAW_NAMES[law]}", 1, *over_seeds(ratios), "mean over the rings; stress of the snapshots against the torque of all steps")


def table():
    lines = ["| quantity | paper | ours | difference in standard errors | remark |", "| --- | --- | --- | --- | --- |"]
    for law in LAWS:
        lines += profile_rows(law)
    lines += torque_rows()
    return "\n".join(lines) + "\n"


def captions():
    try:
        with open(KEPT) as file:
            return json.load(file)
    except OSError:
        return {}


def place(name):
    """The paper's figures by their numbers, then the others."""
    number = name.removeprefix("bild")
    return (int(number) if number.isdigit() else 100, name)


def keep_caption(name, caption):
    kept = captions() | {name: caption}
    with open(KEPT, "w") as file:
        json.dump({key: kept[key] for key in sorted(kept, key=place)}, file, indent=1, ensure_ascii=False)
        file.write("\n")


def write(with_table):
    """The page, from the table and the captions that are kept beside it."""
    if with_table:
        with open(TABLE, "w") as file:
            file.write(table())
    parts = ["# The paper rebuilt\n", "Made by `scripts/reproduce`; a single figure by `scripts/reproduce NAME`, the table by `scripts/reproduce table`. "
             "Simulations: [in.couette](../../inputs/couette/README.md) with the full protocol (dilute start, compaction, one turn discarded, 60 s "
             "averaged over 121 snapshots); means and standard errors in the table are those of three seeds.\n"]
    if os.path.exists(TABLE):
        with open(TABLE) as file:
            parts.append(file.read())
    for name, caption in captions().items():
        parts.append(f"## {FIGURES[name].title}\n\n![{FIGURES[name].title}]({name}.png)\n\n{caption} Numbers: [{name}.csv]({name}.csv); "
                     f"again: `scripts/reproduce {name}`.\n")
    with open(os.path.join(RESULTS, "README.md"), "w") as file:
        file.write("\n".join(parts))
