# SPDX-License-Identifier: GPL-2.0-or-later
"""Results that are no tables."""
import json
import math
import pathlib
from typing import Any, NamedTuple, Optional

import numpy as np


def _from_json(value):
    """null is nan, lists are arrays."""
    if value is None:
        return math.nan
    if isinstance(value, dict):
        return {key: _from_json(one) for key, one in value.items()}
    return np.array([_from_json(one) for one in value]) if isinstance(value, list) else value


class Report(dict):
    """The numbers of `--json` by name, also as attributes; unknown ones are nan. str() is what the program prints."""

    def __init__(self, text, shown):
        super().__init__(_from_json(json.loads(text)))
        self._shown = shown

    def __getattr__(self, name) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"no {name!r}; there are {', '.join(self)}") from None

    def __dir__(self):
        return [*super().__dir__(), *self]

    def __str__(self):
        return self._shown.rstrip("\n")

    __repr__ = __str__


class Balance(NamedTuple):
    """A balance of an audit."""
    value: float  #: relative error; nan: it could not be evaluated
    text: str  #: what it compares, or why it was not evaluated
    judged: bool  #: whether `bound` counts


class Audit(Report):
    """Numbers of an audit, and its balances by name."""

    def __init__(self, text, shown, balances):
        super().__init__(text, shown)
        self.balances = {name: Balance(*one) for name, *one in balances}


class Picture:
    """A picture, shown by notebooks: its bytes, and its file if it was kept."""

    def __init__(self, file, kept):
        self.kind = "svg" if file.endswith(".svg") else "png"
        self.file: Optional[str] = file if kept else None
        self._data = None if kept else pathlib.Path(file).read_bytes()

    @property
    def data(self) -> bytes:
        return pathlib.Path(self.file).read_bytes() if self._data is None else self._data

    def _repr_png_(self):
        return self.data if self.kind == "png" else None

    def _repr_svg_(self):
        return self.data.decode() if self.kind == "svg" else None
