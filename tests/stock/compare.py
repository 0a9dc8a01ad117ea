# SPDX-License-Identifier: GPL-2.0-or-later
"""Discs and files of two runs of the same script."""
import glob
import os

# Of the largest number in a column. Two laws that are the same add in another order: 1e-16 in each of 400 steps, which few
# collisions make grow: 1.3e-13 is the largest that was measured. What is wrong by a half-kick is off by 1e-4 and more.
ROUNDING = 1e-11


def table(path):
    """Rows of numbers, by their order; words that are none are kept."""
    rows = []
    with open(path) as file:
        for line in file:
            rows.append([number(word) for word in line.split()])
    return rows


def number(word):
    try:
        return float(word)
    except ValueError:
        return word


def scales(rows):
    """The largest absolute number of each column."""
    largest = {}
    for row in rows:
        for column, value in enumerate(row):
            if isinstance(value, float):
                largest[column] = max(largest.get(column, 0.0), abs(value))
    return largest


def difference(path, other):
    """The largest difference of two files over the largest number of its column; None where their words differ."""
    if not os.path.exists(path) or not os.path.exists(other):
        return None
    rows, others = table(path), table(other)
    if [len(row) for row in rows] != [len(row) for row in others]:
        return None
    scale, largest = scales(rows), 0.0
    for row, its in zip(rows, others):
        for column, (a, b) in enumerate(zip(row, its)):
            if isinstance(a, str) or isinstance(b, str):
                if a != b and "{" not in str(a):
                    return None
            elif a != b and not (a != a and b != b):
                if not abs(a - b) <= float("inf"):
                    return None
                largest = max(largest, abs(a - b) / scale[column])
    return largest


def files(out):
    """Names of the files that count, without their common beginning."""
    names = [name[len(out):] for name in glob.glob(glob.escape(out) + "*")]
    return sorted(name for name in names if name.endswith((".txt", ".dump")))


def largest_difference(out, other, all_files=False):
    """Over the files of the other run, and the file that has it."""
    names = files(other)
    if all_files and names != files(out):
        return None, f"files {files(out)} and {names}"
    worst = 0.0, ""
    for name in names:
        found = difference(out + name, other + name)
        if found is None:
            return None, name
        worst = max(worst, (found, name))
    return worst
