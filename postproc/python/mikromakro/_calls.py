# SPDX-License-Identifier: GPL-2.0-or-later
"""The verbs of the program."""
import os
import sys
import tempfile
import warnings

from . import _core, _files
from ._field import Field
from ._keywords import NOT_IN_PYTHON, of_verb
from ._reports import Audit, Picture, Report
from ._result import Result

read = _files.read


class MikromakroWarning(UserWarning):
    """What the program warns of."""


def _warn_at(level):
    """Warnings point to the line of the caller, `level` calls up."""
    return lambda text: warnings.warn(text, MikromakroWarning, stacklevel=level + 1)


class _Line:
    """Progress as a line of text, for terminals and notebooks."""

    def __init__(self):
        self._length = 0

    def __call__(self, part, frames):
        self._show(f"{100 * part:3.0f} %, {frames} frames")

    def _show(self, text):
        print("\r" + text.ljust(self._length), end="", file=sys.stderr, flush=True)
        self._length = len(text)

    def clear(self):
        if self._length:
            self._show("")
            print("\r", end="", file=sys.stderr, flush=True)


def _with_progress(progress, call):
    """Runs call(function or None); progress: True for a line of text, or a function of (part, frames)."""
    if not (progress is None or isinstance(progress, bool) or callable(progress)):
        raise TypeError(f"progress: expected True, False or a function, got {progress!r}")
    if progress is not True:
        return call(progress or None)
    line = _Line()
    try:
        return call(line)
    finally:
        line.clear()


def _keywords(verb, options, name, first):
    for option, instead in NOT_IN_PYTHON.items():
        if option in options:
            raise TypeError(f"{verb}(): {option} is about what the program prints; in Python: {instead}")
    return options if first is None else {name: first, **options}


@of_verb("average")
def average(input=None, /, *, fields=None, progress=False, **options):
    """Fields over rings, sectors or rectangles from particles and contacts; returns a Result.

    input     HDF5 snapshots of one run: a name or pattern, or several; or particles= and contacts= name text dumps.
    fields    names, "all", and objects of the class Field: quantities of your own.
    progress  True: a line of text; or a function, called with the part done (0 to 1) and the number of frames.
    every=, per_frame=, moving= give a table with a row for each volume of each window of frames, and columns step, time, ...

    Without out= no file is written. Under mpirun every process averages all frames by itself."""
    listed = [fields] if isinstance(fields, (str, Field)) else list(fields or [])
    own = [field for field in listed if isinstance(field, Field)]
    options["fields"] = [field.name if isinstance(field, Field) else field for field in listed] or None
    keywords = _keywords("average", options, "input", input)
    return Result(*_with_progress(progress, lambda function: _core.average(keywords, own, function, _warn_at(4))))


@of_verb("frames")
def frames(input=None, /, **options):
    """An iterator over frames, one in memory at a time.

    A Frame has `step`, `time` (s; nan: not in the files), `box` (m, shape (2, 2): low and high of x, of y), `periodic`, and two
    structured arrays without copies, one row for each disc and for each contact:
    particles  id type x y radius vx vy omegaz mass   (m, m/s, rad/s, kg)
    contacts   id1 id2 index1 index2 nx ny overlap fx fy xi   (m, N): indices into particles, index2 = -1 at walls; the normal
               points from 1 to 2, the force acts on 1
    What the files do not give is nan (type: 0). They are kept alive by the arrays, and cannot be written to."""
    return _core.Frames(_keywords("frames", options, "input", input), _warn_at(2))


def _as_files(tables, folder):
    """Names of files with these tables."""
    if isinstance(tables, (str, bytes, os.PathLike, Result)):
        tables = [tables]
    files = []
    for i, table in enumerate(tables):
        files.append(table)
        if isinstance(table, Result):
            files[-1] = os.path.join(folder, f"result{i + 1 if i else ''}.csv")
            table.to_csv(files[-1])
    return files


@of_verb("fit")
def fit(tables, /, **options):
    """The exponential velocity profile v0 exp(-(r - R_i)/s); returns a Report: v0 (m/s), s (m), v0_err, s_err, s_low, s_high, ...

    tables    a Result over rings, or the name of a table; further ones are choices beside the first. Of a table of windows: a Result
              with v0 and s as functions of time."""
    with tempfile.TemporaryDirectory() as folder:
        keywords = _keywords("fit", options, "file", _as_files(tables, folder))
        *report, windows = _core.fit(keywords, _warn_at(3))
        return Report(*report) if windows is None else Result(*windows)


@of_verb("audit")
def audit(input=None, /, *, progress=False, **options):
    """Balances of torque, stress, forces and volume over rings or a box; returns an Audit.

    With bound=, a balance that is off by more raises Error. With every=, per_frame= or moving=: a Result with the balances of each
    window."""
    keywords = _keywords("audit", options, "input", input)
    *report, windows = _with_progress(progress, lambda function: _core.audit(keywords, function, _warn_at(4)))
    return Audit(*report) if windows is None else Result(*windows)


@of_verb("draw")
def draw(input=None, /, *, out=None, progress=False, **options):
    """Pictures of frames, a list of Picture; notebooks show them.

    out       FILE.png or FILE.svg; without it the pictures (PNG) are kept in memory only."""
    with tempfile.TemporaryDirectory() as folder:
        options["out"] = os.path.join(folder, "frame.png") if out is None else out
        keywords = _keywords("draw", options, "input", input)
        files = _with_progress(progress, lambda function: _core.draw(keywords, function, _warn_at(4)))
        return [Picture(file, out is not None) for file in files]
