# SPDX-License-Identifier: GPL-2.0-or-later
"""Type hints of the package, with a keyword for each option of the program: write_stub.py FILE"""
import sys

from mikromakro._keywords import keywords_of

HEAD = '''# SPDX-License-Identifier: GPL-2.0-or-later
# Written by postproc/python/write_stub.py from the options of the program.
import os
from typing import Any, Callable, Iterator, Literal, Mapping, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

Text = str | os.PathLike[str]
Array = npt.NDArray[np.float64]
Progress = bool | Callable[[float, int], object]
__version__: str

class Error(RuntimeError): ...
class MikromakroWarning(UserWarning): ...

class Frame:
    step: int
    time: float
    index: int
    run: int
    contacts_known: bool
    box: Array
    periodic: tuple[bool, bool]
    particles: npt.NDArray[np.void]
    contacts: npt.NDArray[np.void]
    def sum_over_contacts(self, of_first: npt.ArrayLike, of_second: npt.ArrayLike | None = None) -> Array: ...

class Field:
    function: Callable[[Frame], npt.ArrayLike]
    name: str
    columns: Sequence[str]
    unit: str
    equation: str
    text: str
    mean: Literal["volume", "discs"]
    needs: Sequence[str]
    def __init__(self, function: Callable[[Frame], npt.ArrayLike], name: str = "", columns: Sequence[str] = (), unit: str = "1",
                 equation: str = "-", text: str = "", mean: Literal["volume", "discs"] = "volume", needs: Sequence[str] = ()) -> None: ...

class Result(Mapping[str, Array]):
    values: Array
    header: list[tuple[str, str]]
    error_report: dict[str, Any] | None
    @property
    def columns(self) -> tuple[str, ...]: ...
    @property
    def units(self) -> dict[str, str]: ...
    @property
    def equations(self) -> dict[str, str]: ...
    @property
    def texts(self) -> dict[str, str]: ...
    @property
    def errors(self) -> dict[str, Array]: ...
    def __getitem__(self, name: str) -> Array: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def to_csv(self, file: Text | None = None) -> str | None: ...
    def to_frame(self) -> Any: ...
    def to_xarray(self) -> Any: ...

class Report(dict[str, Any]):
    def __getattr__(self, name: str) -> Any: ...

class Balance(NamedTuple):
    value: float
    text: str
    judged: bool

class Audit(Report):
    balances: dict[str, Balance]

class Picture:
    kind: Literal["png", "svg"]
    file: str | None
    @property
    def data(self) -> bytes: ...

def read(file: Text) -> Result: ...
'''
FILES = "input: Text | Sequence[Text] | None = None, /, *"
# verb: arguments of its own, what it returns
VERBS = {"average": (f"{FILES}, fields: str | Field | Sequence[str | Field] | None = None, progress: Progress = False", "Result"),
         "frames": (FILES, "Iterator[Frame]"),
         "fit": ("tables: Result | Text | Sequence[Result | Text], /, *", "Report | Result"),
         "audit": (f"{FILES}, progress: Progress = False", "Audit | Result"),
         "draw": (f"{FILES}, out: Text | None = None, progress: Progress = False", "list[Picture]")}


def function(verb):
    own, result = VERBS[verb]
    named = [f"{name}: {kind} | None = None" for name, kind, _ in keywords_of(verb) if f" {name}: " not in own]
    return f"def {verb}({own},\n    " + ",\n    ".join(named) + f") -> {result}: ...\n"


with open(sys.argv[1], "w", encoding="utf-8") as file:
    file.write(HEAD + "\n".join(function(verb) for verb in VERBS))
