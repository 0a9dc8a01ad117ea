# SPDX-License-Identifier: GPL-2.0-or-later
"""Numbers of a job from its files: a value of a JSON file, or a mean of a column of a table."""
import json
import math
import os
import re

import pandas

from sweeping.formula import columns_of
from sweeping.refused import NoResult, guess


def missing(path, what, known):
    raise NoResult(f"{path}: no {what}; expected {' '.join(map(str, known)) or 'something'}")


def of_json(path, key):
    """The number at a.b.c; nan for null."""
    with open(path) as file:
        value = json.load(file)
    for part in key.split("."):
        if not isinstance(value, dict) or part not in value:
            missing(path, f"key {guess(part, value if isinstance(value, dict) else [])}", value if isinstance(value, dict) else ["a table of JSON"])
        value = value[part]
    if value is None:
        return math.nan
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise NoResult(f"{path}: {key}: expected a number, got {value!r}")
    return float(value)


def begins_with_number(line):
    try:
        float(re.split(r"[\s,]", line.strip(), maxsplit=1)[0])
        return True
    except ValueError:
        return False


def header(path):
    """Lines before the first number: comments, and the names of a CSV."""
    lines = []
    with open(path) as file:
        for line in file:
            if begins_with_number(line):
                break
            if line.strip():
                lines.append(line.strip())
    return lines


def of_floats(table):
    """Powers of whole numbers would overflow."""
    return table.astype({name: float for name in table.select_dtypes("integer")})


def read_table(path):
    """A CSV of mikromakro, or a table of an engine, the last comment of which names the columns as name/unit; with the units by columns."""
    lines = header(path)
    if lines and not lines[-1].startswith("#"):
        units = {match[1]: match[2] for line in lines if (match := re.match(r"# column (\S+) \[(.*?)\]", line))}
        return of_floats(pandas.read_csv(path, comment="#", skip_blank_lines=True)), {name: unit for name, unit in units.items() if unit not in ("1", "-")}
    words = lines[-1].lstrip("# ").split() if lines else []
    names = [word.split("/")[0] for word in words]
    table = pandas.read_csv(path, comment="#", sep=r"\s+", header=None)
    if len(names) != table.shape[1]:
        raise NoResult(f"{path}: expected the names of its {table.shape[1]} columns in the last line of comments, got {len(names)}")
    table.columns = names
    return of_floats(table), {name: word.split("/", 1)[1].strip("()").replace("_", " ") for name, word in zip(names, words) if "/" in word}


def evaluated(path, table, formula):
    """A column or a formula of columns."""
    for name in columns_of(formula):
        if name not in table:
            missing(path, f"column {guess(name, table.columns)}", table.columns)
    try:
        return table.eval(formula.strip(), engine="python")
    except (SyntaxError, TypeError, ValueError, LookupError, AttributeError, ArithmeticError, NotImplementedError) as error:
        raise NoResult(f"{path}: '{formula}': expected a formula of columns, got {str(error).splitlines()[0]}") from error


def taken(values, take):
    """The mean or the like of a series: nan where one of them is nan."""
    if take in ("first", "last"):
        return float(values.iloc[0 if take == "first" else -1])
    return float(getattr(values, take)(skipna=False))


def of_table(path, result):
    table, _ = read_table(path)
    values = evaluated(path, table, result.column)
    if result.where:
        chosen = evaluated(path, table, result.where)
        if getattr(chosen, "dtype", None) != bool:
            raise NoResult(f"{path}: where '{result.where}': expected a condition, got numbers")
        values = values[chosen]
    if len(values) == 0:
        raise NoResult(f"{path}: expected rows where {result.where or 'there are any'}, got none of {len(table)}")
    try:
        return taken(values.astype(float), result.take)
    except (TypeError, ValueError) as error:
        raise NoResult(f"{path}: {result.name}: expected numbers, got texts") from error


def value_of(result, folder):
    path = os.path.join(folder, result.file)
    try:
        return of_json(path, result.key) if result.key else of_table(path, result)
    except (OSError, ValueError) as error:
        raise NoResult(f"{path}: expected what {result.name} is taken from, got {getattr(error, 'strerror', None) or str(error).splitlines()[0]}") from error


def unit_of(result, folder):
    """As given, or that of the column; empty where there is none, None where there is no table."""
    if result.unit or result.key:
        return result.unit
    try:
        return read_table(os.path.join(folder, result.file))[1].get(result.column.strip(), "")
    except (OSError, ValueError, NoResult):
        return None
