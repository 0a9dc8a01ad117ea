# SPDX-License-Identifier: GPL-2.0-or-later
"""The figure of a sweep: a panel for each result, against one variable of the grid; the others are lines of their own."""
import itertools

from appearance import MARKERS, plt, shades


def others(plan):
    """Name and values of each line: all combinations of the variables that are not on the abscissa."""
    names = [name for name in plan.grid if name != plan.x]
    return [dict(zip(names, values)) for values in itertools.product(*(plan.grid[name] for name in names))]


def rows_of(table, values):
    for name, value in values.items():
        table = table[table[name] == value]
    return table


def draw(plan, jobs, points, unit, path):
    """Means with their standard errors; crosses are the single seeds."""
    lines = others(plan)
    figure, sheet = plt.subplots(1, len(plan.shown), figsize=(4.2 * len(plan.shown), 3.6), squeeze=False)
    for axes, name in zip(sheet[0], plan.shown):
        sign = -1 if name in plan.log and (points[name] < 0).all() else 1
        for values, marker, colour in zip(lines, itertools.cycle(MARKERS), shades(len(lines))):
            own, single = rows_of(points, values), rows_of(jobs, values)
            error = own[f"{name}_err"]
            axes.errorbar(own[plan.x], sign * own[name], error if error.notna().any() else None, fmt=marker + "-", color=colour, ms=5, lw=0.9,
                          capsize=3, label=", ".join(f"{key} = {value}" for key, value in values.items()))
            axes.plot(single[plan.x], sign * single[name], "x", color=colour, ms=4, alpha=0.6)
        axes.set(xlabel=plan.x, ylabel=("-" if sign < 0 else "") + name + (f" ({unit[name]})" if unit[name] else ""))
        if name in plan.log:
            axes.set_yscale("log")
        if len(lines) > 1:
            axes.legend()
    figure.savefig(path, dpi=110)
    plt.close(figure)
