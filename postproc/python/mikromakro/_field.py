# SPDX-License-Identifier: GPL-2.0-or-later
"""Fields written in Python."""
from dataclasses import dataclass
from typing import Any, Callable, Sequence


def _names(names):
    """A single text is one name."""
    return (names,) if isinstance(names, str) else tuple(names)


@dataclass
class Field:
    """A quantity Q^p of discs to be averaged like the built-in ones: mikromakro.average(..., fields=["stress", my_field]).

    function  is called once per frame with a Frame, and returns a value for each disc: shape (discs,), or (discs, columns), of bool,
              int or float. It may be called by several threads, one at a time, in any order of frames.
    name      of the field, and of its column unless there are `columns`.
    columns   names of the columns, if there are several.
    unit, equation, text  describe the columns, above the table.
    mean      "volume": 1/V sum w V^p Q^p (Latzel2001 Eq. 4), a density; "discs": sum w V^p Q^p / sum w V^p, nan without discs.
              w is the part of the disc in the volume, V^p = pi a^2 h.
    needs     columns that the files must have, such as "mass", "fx" (else values that are missing are nan).

    Values of all discs are returned, those of other types than bulk_types count in no average. A nan counts as it is."""
    function: Callable[[Any], Any]
    name: str = ""
    columns: Sequence[str] = ()
    unit: str = "1"
    equation: str = "-"
    text: str = ""
    mean: str = "volume"
    needs: Sequence[str] = ()

    def __post_init__(self):
        self.name = self.name or self.function.__name__
        self.columns = _names(self.columns) or (self.name,)
        self.needs = _names(self.needs)
        self.text = self.text or (self.function.__doc__ or self.name).strip().split("\n")[0]
        for word in (self.name, *self.columns):
            if not word.isidentifier():
                raise ValueError(f"Field: a name of letters, digits and _ is expected, got {word!r}")
        for name in ("unit", "equation", "text"):
            text = getattr(self, name)
            if len((text + ".").splitlines()) > 1:
                raise ValueError(f"Field {self.name}: {name}= is one line, got {text!r}")
        if set(self.unit) & set("[]"):
            raise ValueError(f"Field {self.name}: unit= is without brackets, got {self.unit!r}")
        if self.mean not in ("volume", "discs"):
            raise ValueError(f"Field {self.name}: mean= is 'volume' or 'discs', got {self.mean!r}")
