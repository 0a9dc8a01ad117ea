# SPDX-License-Identifier: GPL-2.0-or-later
"""What all figures share: letters, grid, colours. The same thing has the same colour in `mikromakro draw`."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

# Contacts that push and that pull, and what is wall (postproc/drawing/picture.cpp; tests/house/check_colours).
COMPRESSION, TENSION, WALL = "#0d0d0d", "#d61a1c", "#9e9e9e"
MARKERS = "osD^v<>pXP*h"
plt.rcParams.update({"font.size": 10, "axes.grid": True, "grid.alpha": 0.3, "figure.constrained_layout.use": True, "legend.fontsize": 8})


def shades(count):
    """Colours from dark to light, in this order also in grey."""
    return plt.cm.viridis(np.linspace(0, 0.88, count))


def band(axes, x, y, error, colour):
    """One standard error on either side of a line, where there is one."""
    known = np.isfinite(error)
    if known.any():
        axes.fill_between(x, np.where(known, y - error, np.nan), np.where(known, y + error, np.nan), color=colour, alpha=0.25, lw=0)
