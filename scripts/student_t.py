# SPDX-License-Identifier: GPL-2.0-or-later
"""Student's t distribution, for means over a few runs."""
import math

import numpy as np


def beyond(limit, freedom):
    """Share of Student's t of `freedom` degrees beyond +-limit: 1 - 2 integral of its density from 0, by Simpson's rule; to 1e-9 up to a limit of 30."""
    x = np.linspace(0, limit, 20001)
    log_factor = math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2) - math.log(freedom * math.pi) / 2
    density = np.exp(log_factor) * (1 + x**2 / freedom) ** (-(freedom + 1) / 2)
    weights = np.ones_like(x)
    weights[1:-1:2], weights[2:-1:2] = 4, 2
    return 1 - 2 * (x[1] / 3) * (weights @ density)


def quantile(confidence, freedom):
    """The t with a share `confidence` of the distribution within +-t, by bisection; 4.303 for 0.95 and two degrees."""
    low, high = 0.0, 1000.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if beyond(middle, freedom) > 1 - confidence else (low, middle)
    return (low + high) / 2


ONE_SIGMA = math.erf(math.sqrt(0.5))  # 0.683


def mean_error(values, confidence=ONE_SIGMA):
    """Mean of independent values and half the width of its interval, t s/sqrt(n): at the default confidence a standard error that is widened for
    n - 1 degrees of freedom (1.32 for three values). nan of a single value."""
    values = np.asarray(values, dtype=float)
    if len(values) < 2:
        return values.mean(), math.nan
    return values.mean(), quantile(confidence, len(values) - 1) * values.std(ddof=1) / math.sqrt(len(values))
