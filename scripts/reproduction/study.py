# SPDX-License-Identifier: GPL-2.0-or-later
"""Which simulations the figures need."""
from reproduction.simulations import biaxial, couette, isotropic

LAWS = ("viscous", "cundall_strack")
# Small and large discs: from below the density at which the wheel loses its contacts to above that at which the cell freezes, under either law.
DENSITIES = ((2391, 400), (2431, 400), (2471, 400), (2491, 400), (2511, 400), (2530, 397), (2545, 394), (2550, 397), (2555, 399), (2575, 400),
             (2600, 400), (2640, 400))
RUNS = {"A": (2511, 400), "B": (2545, 394), "C": (2555, 399)}
SEEDS = (1, 2, 3)
SAMPLE_SEEDS = tuple(range(1, 9))


def seeds(run, law):
    """One of the runs A, B, C with all its seeds."""
    return [couette(*RUNS[run], law, seed) for seed in SEEDS]


def densities(law):
    return [couette(*numbers, law) for numbers in DENSITIES]


# Distances of the wall discs (m): touching; the default; and what other readings of the paper's densities give.
PITCHES = (0.0025, 0.004, 0.0053, 0.0071)


def pitches():
    return [couette(*RUNS["B"], "viscous", **({} if pitch == 0.0053 else {"pitch": pitch})) for pitch in PITCHES]


def slow_run():
    """Run B at a fifth of the rate, over the same angles."""
    return couette(*RUNS["B"], "viscous", omega=0.02, discard_time=314.16, measure_time=300, snap_time=2.5)


# Section 2.4: densities (small and large discs) around both thresholds, and what is changed. But for run B as it is these runs are shorter: a
# third of a turn is discarded, a third averaged. Of the springs, k_t = 0.8 k_n is the default.
SHORTER = {"discard_time": 20.94, "measure_time": 20.94}
LADDERS = {
    "viscous": ((2431, 400), (2451, 400), (2471, 400), RUNS["B"], (2575, 400), (2600, 400), (2640, 400)),
    "cundall_strack": ((2391, 400), (2431, 400), (2451, 400), (2471, 400), (2511, 400), (2530, 397), RUNS["B"], (2575, 400), (2600, 400), (2640, 400)),
}
CASES = {
    "Eq. 1": ("viscous", {}),
    "Eq. 1, bottom friction": ("viscous", {"mu_b": 2e-5}),
    "spring": ("cundall_strack", {}),
    "spring, bottom friction": ("cundall_strack", {"mu_b": 2e-5}),
    "spring, k_t = 0.2 k_n": ("cundall_strack", {"kt_over_kn": 0.2}),
    "spring, k_t = 3.2 k_n": ("cundall_strack", {"kt_over_kn": 3.2}),
}


# Packings differ little under Eq. 1, and below the first density at which springs carry a load, and much above it.
SPRINGS_CARRY_FROM = (2511, 400)


def packings(case):
    """The runs of a case for each density, from loose to dense: one packing, or three where they differ."""
    law, changed = CASES[case]
    numbers = LADDERS[law]
    several = numbers.index(SPRINGS_CARRY_FROM) if law == "cundall_strack" else len(numbers)
    return [[couette(*one, law, seed, **changed, **({} if one == RUNS["B"] and not changed else SHORTER)) for seed in (SEEDS if k >= several else SEEDS[:1])]
            for k, one in enumerate(numbers)]


def ladder(case):
    """The first packing of each density."""
    return [runs[0] for runs in packings(case)]


# Bild 6: eight uniform distributions of radii (mm), half the width over the mean, and three of two sizes.
WIDTHS = (0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5)
RATIOS = (1.5, 2, 3)


def size_distributions():
    """Name and samples of each distribution, from loose to dense: friction and pressure change the number of contacts."""
    states = ((0.5, 20), (0.5, 1000), (0.0, 20), (0.0, 1000))
    for width in WIDTHS:
        small, large = round(1e-3 * (1 - width), 7), round(1e-3 * (1 + width), 7)
        yield f"$\\pm${100 * width:g} %", [isotropic("uniform", small, large, p, mu) for mu, p in states]
    for ratio in RATIOS:
        yield f"1:{ratio:g}", [isotropic("bidisperse", 0.0005, round(0.0005 * ratio, 7), p, mu) for mu, p in states]


def bidisperse():
    return isotropic("bidisperse", 0.0005, 0.0015)


def biaxial_test():
    """To 9 % of strain, at the default rate, with many frames: rotations are sums over them. The wall is that of the run in docs/results."""
    return biaxial(strain=0.09, shear_time=0.3, frames=180, wall_mass=2e-4)


def biaxial_tests():
    """The same with snapshots in one file, of eight packings."""
    return [biaxial(seed, strain=0.09, shear_time=0.3, frames=300, wall_mass=2e-4, snapshot="on") for seed in SAMPLE_SEEDS]


def starts_of_shear():
    """Run B from the moment at which the wheel begins to turn, over one turn."""
    return [couette(*RUNS["B"], "viscous", seed, discard_time=0, measure_time=62.83, snap_time=0.1, snapshot="on") for seed in SEEDS]
