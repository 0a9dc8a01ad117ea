# SPDX-License-Identifier: GPL-2.0-or-later
"""The table of stock fixes and commands, read from rows.txt.

A row begins with '== NAME'. Its lines are those of a script; '{out}' in them is the beginning of names of files, whose
'.txt' ones are compared as well; other words in braces stand for lines of scripts.py. A line that begins
with 'liggghts:' or 'lammps:' is meant for one engine, one with 'disc:' or 'stock:' for fix nve/disc or the stock
integrator. Lines that begin with '@' are about the row:

    @about TEXT          for the manual
    @engines NAME        the other engine has no such style
    @kind fix            the lines stand before two runs (so is a row without this line)
    @kind between        ... between two runs
    @kind script         ... after the set-up, with their own runs
    @refused TEXT        the disc styles end the script with a line that contains TEXT
    @told TEXT           they go on, and say TEXT; the motion need not be the stock one
    @passive             the motion of the discs does not show whether the lines act
    @observes            nor can they change it: the last bit is that of the discs without these lines
    @tolerance X         in place of that of compare.py
    @integrate GROUP     in place of all
    @boundary X Y Z, @half_width X, @atom_style WORDS, @box WORDS (of create_box), @before_box LINE: of the set-up
    @discs none          the row makes its own
    @one_rank            left out on more: the stock law itself is wrong there
    @alone               not for random scripts
"""
import os

ENGINES = ("liggghts", "lammps")
ROWS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "rows.txt")
DEFAULTS = {"about": "", "engines": " ".join(ENGINES), "kind": "fix", "refused": "", "told": "",
            "passive": False, "observes": False, "tolerance": "", "integrate": "all", "boundary": "p f p", "half_width": "0.0262", "atom_style": "", "box": "",
            "before_box": [], "discs": "all", "one_rank": False, "alone": False}


class Row:
    def __init__(self, name, engine):
        self.name, self.engine, self.lines = name, engine, []
        self.__dict__.update({key: list(value) if isinstance(value, list) else value for key, value in DEFAULTS.items()})

    def note(self, key, value):
        if key not in DEFAULTS:
            raise ValueError(f"row {self.name}: no such word: @{key}")
        if isinstance(DEFAULTS[key], bool):
            self.__dict__[key] = True
        elif isinstance(DEFAULTS[key], list):
            self.__dict__[key].append(value)
        else:
            self.__dict__[key] = value

    def file_name(self):
        return "".join(letter if letter.isalnum() else "_" for letter in self.name)

    def outcome(self):
        return "refused" if self.refused else "warning" if self.told else "works"


def names(path=ROWS):
    """Of the rows of all engines, in the order of the file."""
    with open(path) as file:
        return [line[3:].strip() for line in file if line.startswith("== ")]


def line_of(engine, line):
    """The line as this engine has it, or None."""
    for other in ENGINES:
        if line.startswith(other + ":"):
            return line[len(other) + 1:].strip() if other == engine else None
    return line


def read(engine, path=ROWS):
    """The rows of an engine, in the order of the file."""
    rows = []
    with open(path) as file:
        for text in file:
            text = text.strip()
            if text.startswith("== "):
                rows.append(Row(text[3:], engine))
                continue
            line = None if not text or text.startswith("#") else line_of(engine, text)
            if line is None:
                continue
            if line.startswith("@"):
                key, _, value = line[1:].partition(" ")
                rows[-1].note(key, value)
            else:
                rows[-1].lines.append(line)
    return [row for row in rows if engine in row.engines.split()]
