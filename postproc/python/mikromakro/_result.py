# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of averages."""
import json
from collections.abc import Mapping
from itertools import takewhile

import numpy as np

from . import _core

# Columns that say where a volume is; columns before them say which window of frames a row belongs to.
PLACES_BY_KIND = (("r_inner", "r_outer", "r"), ("phi_begin", "phi_end", "phi"), ("x_min", "x_max", "y_min", "y_max", "x", "y"))
PLACES = sum(PLACES_BY_KIND, ())
AXES = ("r", "phi", "x", "y")


class Result(Mapping):
    """A table of averages: columns by name, as arrays with one number per row (volume, or volume of a window of frames).

    values     all numbers, shape (rows, columns); columns are views of it
    columns    names, in the order of the program's table
    units, equations, texts   of each column, by name
    errors     standard errors by the name of the quantity; nan where they are not known
    header     [(name, value)]: program, input and options, as above the program's table
    error_report   how the errors were made (the program's --json); None if there is none"""

    def __init__(self, header, columns, values, error_report="null"):
        self.header = list(header)
        self.values = values
        self._described = [tuple(column) for column in columns]
        self._index = {column[0]: i for i, column in enumerate(self._described)}
        self.error_report = json.loads(error_report)

    # A comparison of all numbers would be one of arrays.
    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def __getitem__(self, name):
        if name not in self._index:
            raise KeyError(f"no column {name!r}; there are {', '.join(self.columns)}")
        return self.values[:, self._index[name]]

    def __iter__(self):
        return iter(self._index)

    def __len__(self):
        return len(self._index)

    def __repr__(self):
        return f"<mikromakro.Result: {len(self.values)} rows of {', '.join(self.columns)}>"

    def _repr_html_(self):
        try:
            return self.to_frame()._repr_html_()
        except ImportError:
            return None

    def _ipython_key_completions_(self):
        return list(self.columns)

    @property
    def columns(self):
        return tuple(self._index)

    @property
    def units(self):
        return {name: unit for name, unit, _, _ in self._described}

    @property
    def equations(self):
        return {name: equation for name, _, equation, _ in self._described}

    @property
    def texts(self):
        return {name: text for name, _, _, text in self._described}

    @property
    def errors(self):
        return {name: self[name + "_err"] for name in self.columns if name + "_err" in self._index}

    def to_csv(self, file=None):
        """The table as the program writes it: into a file, or as text."""
        text = _core.csv_text(self.header, self._described, self.values)
        if file is None:
            return text
        with open(file, "w", encoding="utf-8") as out:
            out.write(text)
        return None

    def to_frame(self):
        """A pandas.DataFrame; units, equations and header are in its attrs."""
        import pandas
        frame = pandas.DataFrame({name: self[name] for name in self.columns})
        frame.attrs.update(units=self.units, equations=self.equations, header=self.header)
        return frame

    def _windows(self):
        """Names of the columns of windows, and of places; the numbers of windows and volumes."""
        of_window = list(takewhile(lambda name: name not in PLACES, self.columns))
        # Fields may have such names as well, behind them.
        places = []
        for kind in PLACES_BY_KIND:
            begin = len(of_window) + len(places)
            if self.columns[begin:begin + len(kind)] == kind:
                places += kind
        if "step_first" not in of_window:
            return [], places, 1, len(self.values)
        keys = self.values[:, [self._index[name] for name in of_window if name in ("step_first", "step_last", "run")]]
        others = np.flatnonzero((keys != keys[:1]).any(axis=1))
        volumes = int(others[0]) if len(others) else len(self.values)
        return of_window, places, len(self.values) // volumes, volumes

    def to_xarray(self):
        """An xarray.Dataset over r, (r, phi) or (y, x), with `time` first if there are windows; units and equations are attrs."""
        import xarray
        of_window, places, windows, volumes = self._windows()
        axes = [name for name in AXES if name in places]
        lengths = {name: len(np.unique(self[name][:volumes])) for name in axes}
        # The axis along which successive rows differ is the last one.
        axes.sort(key=lambda name: volumes > 1 and self[name][0] != self[name][1])
        if np.prod([lengths[name] for name in axes]) != volumes:
            raise ValueError("the volumes of this table form no grid")
        shape = [lengths[name] for name in axes]
        data, coords = {}, {}
        for name in self.columns:
            numbers = self[name].reshape([windows, *shape])
            attrs = {"units": self.units[name], "equation": self.equations[name], "long_name": self.texts[name]}
            if name in of_window:
                numbers, dims = numbers.reshape(windows, -1)[:, 0], ("time",)
            elif name in places:
                axis = next(one for one in axes if name.split("_")[0] == one)
                cut = tuple(slice(None) if one == axis else 0 for one in axes)
                numbers, dims = numbers[0][cut], (axis,)
            else:
                dims = (*(["time"] if of_window else []), *axes)
                numbers = numbers if of_window else numbers[0]
            (coords if name in of_window or name in places else data)[name] = (dims, numbers, attrs)
        return xarray.Dataset(data, coords, {name: value for name, value in self.header})
