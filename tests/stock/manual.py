# SPDX-License-Identifier: GPL-2.0-or-later
"""The table of stock fixes and commands for the manual, from the rows alone: stock_table shows that they are right."""
import rows

HEAD = """# Stock fixes and commands under the disc law

Made by `tests/stock/stock_table --manual`, from the rows of `tests/stock/rows.txt`, and tested by `ctest -R stock` in both engines, on
one rank and on two. Each row runs as a script of some hundred steps in which 20 discs collide.

- **works**: without dashpot and friction, the discs move as under the stock law of the engine (`hooke/stiffness`, `gran/hooke`) and its own
  `nve/sphere` with the same lines, and what the lines write into files is the same, to rounding (1e-11). With spring, friction and dashpots, the
  motion is the same to the last bit whether or not the discs are read in every step.
- **refused**: the script ends with the quoted error.
- **told**: the script continues, and the quoted warning says what differs from what one would expect.
- -: the engine has no such style or command, or not in two dimensions.

{count} rows. Styles and commands outside of the table are untested; in steps in which they may act, discs are in the engine's arrays as under any other
law. LIGGGHTS itself refuses discs in two dimensions, or crashes, in `fix insert/*`, `fix particletemplate/*`, `fix spring/rg` and walls of meshes.

| lines | LIGGGHTS | LAMMPS | |
| --- | --- | --- | --- |
"""


def outcome(row):
    if row is None:
        return "-"
    quoted = row.refused or row.told
    return row.outcome() + (f": `{quoted}`" if quoted else "")


def example(row):
    """The first line that names what the row is about."""
    first = row.name.split()[0].rstrip(",")
    word = row.name.split()[1].rstrip(",") if first in ("fix", "compute") and len(row.name.split()) > 1 else first
    lines = [line for line in row.lines if word in line.split()]
    return f"`{lines[0]}`".replace("{out}", "").replace("{folder}/", "") if lines else ""


def table():
    of_engine = {engine: {row.name: row for row in rows.read(engine)} for engine in rows.ENGINES}
    names = list(dict.fromkeys(name for name in rows.names()))
    lines = []
    for name in names:
        its = [of_engine[engine].get(name) for engine in rows.ENGINES]
        row = next(row for row in its if row)
        about = "; ".join(text for text in (row.about, example(row)) if text)
        lines.append(f"| {name} | {' | '.join(map(outcome, its))} | {about} |\n")
    return HEAD.replace("{count}", str(len(lines))) + "".join(lines)


def check(path, write):
    """0 where the file holds the table, which it does after it was written."""
    text = table()
    if write:
        with open(path, "w") as file:
            file.write(text)
    with open(path) as file:
        same = file.read() == text
    if not same:
        print(f"{path}: expected the table of tests/stock/rows.txt, got another; 'stock_table --manual {path} --write' makes it")
    return 0 if same else 1
