# SPDX-License-Identifier: GPL-2.0-or-later
"""Signatures and docstrings from the options of the program, which are their only definition."""
import inspect
import re

from . import _core

# Options about what is printed, and what there is in Python for them.
NOT_IN_PYTHON = {"json": "the result has it", "quiet": "progress="}


def keywords_of(verb):
    """[(keyword, type, description)] of a verb, without the files, which are the first argument."""
    return [option for option in _core.options_of(verb) if option[0] not in NOT_IN_PYTHON and option[0] not in ("input", "file")]


def in_python(description):
    """`--wall-contacts` as it is written here."""
    return re.sub(r"--([a-z]+(?:-[a-z]+)*)", lambda match: match[1].replace("-", "_") + "=", description)


def of_verb(verb):
    """Gives a function the keywords of a verb, for help() and completion."""
    def decorate(function):
        own = inspect.signature(function)
        fixed = [one for one in own.parameters.values() if one.kind is not inspect.Parameter.VAR_KEYWORD]
        names = {one.name for one in fixed}
        options = [option for option in keywords_of(verb) if option[0] not in names]
        function.__signature__ = own.replace(parameters=[
            *fixed, *(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=kind) for name, kind, _ in options)])
        lines = [f"    {name}: {kind}\n        {in_python(text)}" for name, kind, text in keywords_of(verb)]
        function.__doc__ = inspect.cleandoc(function.__doc__) + "\n\nKeywords, as of `mikromakro " + verb + "`:\n" + "\n".join(lines)
        return function
    return decorate
