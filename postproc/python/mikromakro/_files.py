# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables in files."""
import os
import re

import numpy as np

from . import _core
from ._result import Result


def read_csv(file):
    comments, names, values = _core.read_csv(file)
    header, described = [], {}
    for line in comments:
        column = re.fullmatch(r"column (\S+) \[(.*?)\] \((.*?)\) (.*)", line)
        if column:
            described[column[1]] = column.groups()
        elif ": " in line:
            header.append(tuple(line.split(": ", 1)))
    return Result(header, [described.get(name, (name, "", "", "")) for name in names], values)


def _texts(value):
    listed = np.atleast_1d(value)
    return [one.decode() if isinstance(one, bytes) else str(one) for one in listed]


def _opened(h5py, file):
    try:
        return h5py.File(file, "r")
    except FileNotFoundError as error:
        raise _core.Error(f"{file}: cannot find the file") from error
    except OSError as error:
        raise _core.Error(f"{file}: cannot be read as HDF5: {error}") from error


def read_hdf5(file):
    try:
        import h5py
    except ImportError as error:
        raise ImportError("tables in HDF5 are read by h5py (Debian: python3-h5py)") from error
    with _opened(h5py, file) as content:
        if "table" not in content:
            raise _core.Error(f"{file}: the file holds no table; expected a table of `mikromakro average`, or "
                              "mikromakro.frames() for snapshots, got none")
        table = content["table"]
        names = _texts(table.attrs["columns"])
        header = [(name, text) for name, value in content.attrs.items() for text in _texts(value)]
        described = [(name, *(_texts(table[name].attrs[key])[0] for key in ("unit", "equation", "text"))) for name in names]
        columns = [table[name][()] for name in names]
        axes = [_texts(table[name].attrs["axes"]) if "axes" in table[name].attrs else ["volume"] for name in names]
    shape = np.broadcast_shapes(*(column.shape if "volume" in of else (len(column), 1) for column, of in zip(columns, axes)))
    # What belongs to a window stands in all of its rows.
    rows = [np.broadcast_to(column[:, None] if of == ["time"] else column, shape).ravel() for column, of in zip(columns, axes)]
    return Result(header, described, np.column_stack(rows))


def read(file):
    """A table of averages: a Result from a .csv or .h5 file of `mikromakro average` (or of `fix ave/micromacro`)."""
    file = os.fsdecode(file)
    return read_hdf5(file) if file.endswith(".h5") else read_csv(file)
