"""Which simulations the figures need."""
from reproduction.simulations import couette

LAWS = ("viscous", "cundall_strack")
# Small and large discs: from below the density at which the wheel loses its contacts to above that at which the cell freezes.
DENSITIES = ((2431, 400), (2471, 400), (2491, 400), (2511, 400), (2530, 397), (2545, 394), (2550, 397), (2555, 399), (2575, 400),
             (2600, 400))
RUNS = {"A": (2511, 400), "B": (2545, 394), "C": (2555, 399)}
SEEDS = (1, 2, 3)


def named_runs(law):
    """A, B and C with all their seeds."""
    return [couette(*numbers, law, seed) for seed in SEEDS for numbers in RUNS.values()]


def densities(law):
    return [couette(*numbers, law) for numbers in DENSITIES]
