# SPDX-License-Identifier: GPL-2.0-or-later
"""Each effect off and on: what it changes in the macroscopic answer, and what it costs."""
import dataclasses

import numpy as np

from accuracy import runs, scene

TITLE = "Effects"
BASE = {"law": "cundall_strack"}
# Name, what it says, variables of inputs/couette/in.couette in which it differs from the base.
EFFECTS = (("spring", "base: dashpot, Cundall-Strack spring", {}),
           ("eq1", "Eq. 1 instead of the spring", {"law": "viscous"}),
           ("frictionless", "no friction (mu = 0)", {"mu": 0}),
           ("tangential_dashpot", "additional tangential dashpot", {"law": "cundall_strack tangential_damping on"}),
           ("no_attraction", "no attraction (limitForce)", {"law": "cundall_strack limitForce on"}),
           ("no_dashpot", "no dashpot", {"law": "cundall_strack damping off"}),
           ("bottom", "bottom friction, mu_b = 2e-5", {"mu_b": 2e-5}),
           ("smooth", "smooth rings", {"rings": "smooth"}))
DT = 4e-5


def section():
    # Most effects are larger than what short runs scatter.
    if scene.cell is scene.SMALL:
        scene.cell = dataclasses.replace(scene.SMALL, discard_time=4, measure_time=10, seeds=(1, 2, 3, 4, 5))
    folders = {name: [] for name, _, _ in EFFECTS}
    for seed in scene.cell.seeds:
        for name, _, variables in EFFECTS:
            folders[name].append(scene.sheared(name, seed, **{**BASE, **variables}))
    steps = (2.5 + scene.cell.discard_time + scene.cell.measure_time) / DT
    cost = {name: 1e6 * np.array([runs.seconds(folder) for folder in folders[name]]) / steps for name in folders}
    base, base_cost = scene.over_seeds(folders["spring"]), np.median(cost["spring"])
    yield (f"Cell `{scene.cell.run}`, t_c/54, {scene.cell.measure_time} s of shear after {scene.cell.discard_time} s, means and standard errors of "
           f"{len(scene.cell.seeds)} seeds; in brackets the difference from the base in per cent and in units "
           f"of its standard error ({scene.of_seeds(len(scene.cell.seeds))}; of {(len(EFFECTS) - 1) * len(scene.PLAIN)} comparisons "
           f"{0.05 * (len(EFFECTS) - 1) * len(scene.PLAIN):.0f} lie outside by chance). Processor time of the whole run per step, output included: median (least to most) over the seeds, which were run in alternation. "
           "What each effect costs in the pair loop: "
           "[performance](../performance.md), `build/bin/effects_bench`.")
    yield ""
    yield "| effect | " + " | ".join(scene.PLAIN.values()) + " | us per step | relative to the base |"
    yield "| --- " * (len(scene.PLAIN) + 3) + "|"
    for name, says, _ in EFFECTS:
        found, cells = scene.over_seeds(folders[name]), []
        for key in scene.PLAIN:
            (mean, error), (at_base, base_error) = found[key], base[key]
            change = f" ({100 * (mean / at_base - 1):+.0f} %, {abs(mean - at_base) / np.hypot(error, base_error):.1f})" if name != "spring" else ""
            cells.append(f"{mean:.4g} ± {error:.2g}{change}")
        middle = np.median(cost[name])
        yield f"| {says} | {' | '.join(cells)} | {middle:.1f} ({cost[name].min():.1f} to {cost[name].max():.1f}) | {middle / base_cost:.2f} |"
