# SPDX-License-Identifier: GPL-2.0-or-later
"""What is wrong, in one line: what, what was expected, what was got."""
import difflib


class Refused(Exception):
    """What is wrong with the file, in one line."""


class NoResult(Exception):
    """What is missing in a file of a job, in one line."""


def guess(name, known):
    near = difflib.get_close_matches(str(name), known, 1, 0.6)
    return f"'{name}'" + (f" (did you mean '{near[0]}'?)" if near else "")


def refuse(what, expected, got):
    raise Refused(f"{what}; expected {expected}, got {got}")
