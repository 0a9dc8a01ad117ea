# SPDX-License-Identifier: GPL-2.0-or-later
"""The TOML file of a sweep, checked: what is in it is used or refused."""
import dataclasses
import decimal
import json
import math
import os
import re
import tomllib

from sweeping.formula import check_formula
from sweeping.refused import guess, refuse

TOP = {"script": str, "program": str, "ranks": int, "out": str, "seeds": list, "variables": dict, "grid": dict, "commands": list, "results": dict,
       "figure": dict}
RESULT = {"file": str, "key": str, "column": str, "where": str, "take": str, "unit": str}
FIGURE = {"x": str, "results": list, "log": list}
TAKE = ("mean", "first", "last", "min", "max", "median", "std", "sum")
WORDS = {str: "a text in quotes", int: "a whole number", list: "a list in brackets", dict: "a table"}
VALUES = "a number or a text in quotes"
ERRORS = ("_err", "_95")


@dataclasses.dataclass(frozen=True)
class Result:
    """A number of each job: the value at `key` of a JSON file, or of a table `column` (a formula of columns) of the rows `where` something holds, of which
    `take` is the mean or the like."""

    name: str
    file: str
    key: str = ""
    column: str = ""
    where: str = ""
    take: str = "mean"
    unit: str = ""

    def text(self):
        if self.key:
            return f"{self.key} of {self.file}"
        return f"{self.take} of {self.column} of {self.file}" + (f" where {self.where}" if self.where else "")


@dataclasses.dataclass(frozen=True)
class Plan:
    """`grid` and `variables`: values by names; `x`, `shown`, `log`: abscissa of the figure, its results, and those of them on a logarithmic scale."""

    file: str
    script: str
    program: str
    ranks: int
    out: str
    seeds: tuple
    variables: dict
    grid: dict
    commands: tuple
    results: tuple
    x: str
    shown: tuple
    log: tuple


def check_line(where, value):
    """A text stands in one line of comments of a table."""
    if isinstance(value, str) and not value.isprintable():
        refuse(where, "one line of text", repr(value))


def check(table, where, kinds):
    """Refuses keys that are not among `kinds`, and values of another kind."""
    for key, value in table.items():
        if key not in kinds:
            refuse(f"{where}unknown key", " ".join(kinds), guess(key, kinds))
        if not isinstance(value, kinds[key]) or isinstance(value, bool):
            refuse(f"{where}{key}", WORDS[kinds[key]], repr(value))
        check_line(f"{where}{key}", value)


def check_value(where, value):
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        refuse(where, VALUES + (", or the list in [grid]" if isinstance(value, list) else ""), repr(value))
    if value == "":
        refuse(where, VALUES, "an empty text")
    if isinstance(value, float) and not math.isfinite(value):
        refuse(where, "a finite number", value)
    check_line(where, value)


def number(value):
    """The same for all spellings of a number; a text that is none as it is."""
    try:
        return str((decimal.Decimal(str(value)) + 0).normalize())
    except ArithmeticError:
        return value


def check_different(where, values):
    seen = {}
    for value in values:
        if number(value) in seen:
            refuse(where, "different values", f"{json.dumps(seen[number(value)])} and {json.dumps(value)}")
        seen[number(value)] = value


def check_alike(where, values):
    for value in values:
        if isinstance(value, str) != isinstance(values[0], str):
            refuse(where, "numbers only or texts only", f"{json.dumps(values[0])} and {json.dumps(value)}")


def check_list(where, values, texts_of=None):
    """A list without repetitions, of values, or of texts out of `texts_of`."""
    if not values:
        refuse(where, "one value at least", "none")
    for value in values:
        if texts_of is None:
            check_value(where, value)
        elif value not in texts_of:
            refuse(where, " ".join(texts_of), guess(value, texts_of))
    check_different(where, values)
    check_alike(where, values)


def one_result(name, table):
    where = f"[results] {name}: "
    if not re.fullmatch(r"[A-Za-z_]\w*", name):
        refuse(f"[results] {name}", "a name of letters, digits and _", f"'{name}'")
    if not isinstance(table, dict):
        refuse(f"[results] {name}", '{ file = "...", ... }', repr(table))
    check(table, where, RESULT)
    for key in ("file", "key", "column", "where"):
        if table.get(key) == "":
            refuse(f"{where}{key}", "a text", "an empty one")
    if "file" not in table:
        refuse(f"{where}no file", 'file = "...", in the folder of a job', "none")
    if os.path.isabs(table["file"]):
        refuse(f"{where}file", "a path in the folder of a job", f"'{table['file']}'")
    if ("key" in table) == ("column" in table):
        refuse(f"{where}one number of {table['file']}", "either key (of JSON) or column (of a table)", "both" if "key" in table else "none")
    if "key" in table and ("where" in table or "take" in table):
        refuse(f"{where}{'where' if 'where' in table else 'take'}", "column, of a table, with it", "key, of JSON")
    if table.get("take", "mean") not in TAKE:
        refuse(f"{where}take", " ".join(TAKE), guess(table["take"], TAKE))
    for key in ("column", "where"):
        if key in table:
            check_formula(f"{where}{key}", table[key])
    return Result(name, **table)


def check_variables(top):
    variables, grid = top["variables"], top["grid"]
    for name, value in variables.items():
        check_value(f"[variables] {name}", value)
    for name, values in grid.items():
        if not isinstance(values, list):
            refuse(f"[grid] {name}", "a list in brackets (a single value stands in [variables])", repr(values))
        check_list(f"[grid] {name}", values)
    for name in grid:
        if name in variables:
            refuse(f"variable {name}", "it in one of [variables] and [grid]", "it in both")
    if not grid:
        refuse("no [grid]", "a list of values of one variable at least", "none")
    for name in {**variables, **grid}:
        if name == "out":
            refuse("variable out", "it not to be set: each job gets a folder of its own", "it")
        if name == "seed" and top["seeds"]:
            refuse("variable seed", "it once, seeds = [...] or a variable", "both")
    if top["seeds"]:
        check_list("seeds", top["seeds"])


def check_names(grid, results):
    """No two columns of a table have one name."""
    if "seeds" in grid:
        refuse("[grid] seeds", "another name than that of the column seeds", "it")
    errors = {one.name + ending: one.name for one in results for ending in ERRORS}
    for where, names in (("[grid]", grid), ("[results]", [one.name for one in results])):
        for name in names:
            if name in errors:
                refuse(f"{where} {name}", f"another name than {name}, the error of {errors[name]}", "it")
    for one in results:
        if one.name in (*grid, "seed", "seeds"):
            refuse(f"[results] {one.name}", "another name than that of a variable of the grid, seed or seeds", "it")


def check_figure(figure, grid, results):
    check(figure, "[figure] ", FIGURE)
    if figure.get("x", next(iter(grid))) not in grid:
        refuse("[figure] x", " ".join(grid), guess(figure["x"], grid))
    names = [one.name for one in results]
    if "results" in figure:
        check_list("[figure] results", figure["results"], names)
    if figure.get("log"):
        check_list("[figure] log", figure["log"], figure.get("results", names))


def folder_of(out, path):
    """Scripts write ${out} without quotes: only characters that no engine and no shell reads as anything else."""
    folder = out or os.path.join("out", os.path.splitext(os.path.basename(path))[0])
    if not re.fullmatch(r"[\w./+][\w./+-]*", folder):
        refuse("out" if out else "out, which is named after the file", "letters, digits and ./_+-", f"'{folder}'")
    return folder


def read_plan(path):
    """Refused where something is wrong with the file."""
    try:
        with open(path, "rb") as file:
            given = tomllib.load(file)
    except OSError as error:
        refuse("cannot be read", "a TOML file", error.strerror)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        refuse("no TOML", "its rules (toml.io)", str(error))
    check(given, "", TOP)
    top = {key: given.get(key, kind()) for key, kind in TOP.items()}
    if not top["script"]:
        refuse("no script", 'script = "...", an input script', "none")
    if given.get("ranks", 1) < 1:
        refuse("ranks", "1 or more", top["ranks"])
    check_variables(top)
    for command in top["commands"]:
        if not isinstance(command, str):
            refuse("commands", "texts in quotes", repr(command))
    results = tuple(one_result(name, table) for name, table in top["results"].items())
    if not results:
        refuse("no [results]", "one number of each job at least", "none")
    check_names(top["grid"], results)
    check_figure(top["figure"], top["grid"], results)
    return Plan(path, top["script"], top["program"] or "liggghts-disc", given.get("ranks", 1), folder_of(top["out"], path), tuple(top["seeds"]),
                top["variables"], top["grid"], tuple(top["commands"]), results, top["figure"].get("x", next(iter(top["grid"]))),
                tuple(top["figure"].get("results", [one.name for one in results])), tuple(top["figure"].get("log", [])))
