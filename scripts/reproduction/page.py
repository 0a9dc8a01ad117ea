# SPDX-License-Identifier: GPL-2.0-or-later
"""docs/results/README.md: the table of the paper's numbers beside ours, and the figures with their captions."""
import json
import os

from reproduction import biaxial, fabric, in_time, packings, pictures, regimes, thresholds  # noqa: F401, they register their figures
from reproduction.figures import FIGURES, LAW_NAMES
from reproduction.sheet import RESULTS
from reproduction.study import LAWS, RUNS
from reproduction.table import GROUPS, QUANTITIES, column

CAPTIONS = os.path.join(RESULTS, "captions.json")
ROWS = os.path.join(RESULTS, "rows.json")


def kept(path):
    try:
        with open(path) as file:
            return json.load(file)
    except OSError:
        return {}


def keep(path, name, made, place):
    """What was made of this name, beside what other calls have made."""
    everything = kept(path) | {name: made}
    with open(path, "w") as file:
        json.dump({key: everything[key] for key in sorted(everything, key=place)}, file, indent=1, ensure_ascii=False)
        file.write("\n")


def place(name):
    """The paper's figures by their numbers, then the others."""
    number = name.removeprefix("bild")
    return (int(number) if number.isdigit() else 100, name)


def keep_caption(name, caption):
    keep(CAPTIONS, name, caption, place)


def keep_rows(name):
    keep(ROWS, name, GROUPS[name].make(), list(GROUPS).index)


def table(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def tables():
    """Of the rows that are kept: a table for each law, with a column for each run, and one of the single quantities."""
    made = kept(ROWS)
    for law in LAWS:
        columns = [column(run, law) for run in RUNS if column(run, law) in made]
        if not columns:
            continue
        header = ["quantity", "paper", *(f"run {name[0]}" for name in columns), "remark"]
        rows = [[one.name, "-" if one.paper is None else str(one.paper), *(made[name][one.name] for name in columns), one.remark] for one in QUANTITIES]
        yield f"Law: {LAW_NAMES[law]}. A column again: {', '.join(f'`scripts/reproduce {name}`' for name in columns)}.\n"
        yield table(header, rows)
    singles = [[*row, f"`scripts/reproduce {name}`"] for name, rows in made.items() if isinstance(rows, list) for row in rows]
    if singles:
        yield table(["quantity", "paper", "ours", "remark", "again"], singles)


def write():
    """The page, from the rows and the captions that are kept beside it."""
    parts = ["# The paper rebuilt\n",
             "Made by `scripts/reproduce`; a single figure, or a part of the tables, by the command beside it. Simulations: "
             "[in.couette](../../inputs/couette/README.md) with the full protocol (dilute start, compaction, one turn discarded, 60 s averaged over 121 "
             "snapshots) where nothing else is said. Runs A, B, C: mean ± standard error of three seeds, that is of three packings. In brackets: ours less "
             "the paper's, in our standard errors (statistical) alone, since the paper gives none of its own; of n packings the ± is s/sqrt(n), not widened for its "
             "n - 1 degrees of freedom as the errors of `average` are: an interval of 95 % are 4.3 of them for three, 2.4 for eight; where 68 % of Student's t is said, it is widened. What depends on choices of the fit has their range beside it: where the paper's value lies within, no difference is shown by any number of "
             "statistical errors ([errors](../manual/errors.md)).\n",
             *tables()]
    for name, caption in kept(CAPTIONS).items():
        parts.append(f"## {FIGURES[name].title}\n\n![{FIGURES[name].title}]({name}.png)\n\n{caption} Numbers: [{name}.csv]({name}.csv); "
                     f"again: `scripts/reproduce {name}`.\n")
    with open(os.path.join(RESULTS, "README.md"), "w") as file:
        file.write("\n".join(parts))
