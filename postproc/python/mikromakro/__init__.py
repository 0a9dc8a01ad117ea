# SPDX-License-Identifier: GPL-2.0-or-later
"""Continuum fields from discs and contacts: what the program `mikromakro` does, with arrays in and out.

    import mikromakro
    profile = mikromakro.average("run.h5", rings=(0.1, 0.25, 30), bulk_types=[1, 2])
    profile["sigma_rphi"], profile.errors["sigma_rphi"], profile.units["sigma_rphi"]

Keywords are the options of the program: `--bulk-types 1,2` is `bulk_types=[1, 2]`. SI units. Numbers are those of the program
to the last bit. Errors are of the class Error, with the program's text; its warnings are Python's, of the class
MikromakroWarning. Ctrl-C ends a long call."""
from ._calls import MikromakroWarning, audit, average, draw, fit, frames, read
from ._core import Error, Frame, version as __version__
from ._field import Field
from ._reports import Audit, Balance, Picture, Report
from ._result import Result

__all__ = ["Audit", "Balance", "Error", "Field", "Frame", "MikromakroWarning", "Picture", "Report", "Result", "audit", "average",
           "draw", "fit", "frames", "read"]
