# SPDX-License-Identifier: GPL-2.0-or-later
"""What an input script says, with the scripts that it includes: its content, and the variables that it uses."""
import dataclasses
import hashlib
import re

INCLUDE = re.compile(r"\binclude\s+([^\s\"']+)")
DEFAULT = re.compile(r"^\s*variable\s+(\w+)\s+(?:index|string)\s+(\S+)", re.MULTILINE)
USED = re.compile(r"\$\{(\w+)\}|\bv_(\w+)|\bvariable\s+(\w+)")


@dataclasses.dataclass(frozen=True)
class ScriptText:
    """`digest` changes with any character of the script or of those it includes; `unread` are names of included files that nothing could be read from."""

    digest: str
    variables: frozenset
    unread: tuple


def without_comments(text):
    return "\n".join(line.split("#")[0] for line in text.splitlines())


def substituted(name, values):
    """A name with ${...} replaced as far as values are known."""
    return re.sub(r"\$\{(\w+)\}", lambda match: values.get(match[1], match[0]), name)


def read_script(path, given):
    """`given` are values of the command line, which come before the defaults of the script. OSError where the script itself is not there."""
    values, content, variables, unread, known = dict(given), hashlib.sha256(), set(), [], set()
    waiting = [path]
    while waiting:
        file = waiting.pop(0)
        if file in known:
            continue
        known.add(file)
        try:
            with open(file, encoding="utf-8", errors="replace") as script:
                text = script.read()
        except OSError:
            if file == path:
                raise
            unread.append(file)
            continue
        content.update(text.encode())
        text = without_comments(text)
        variables.update(name for names in USED.findall(text) for name in names if name)
        for name, value in DEFAULT.findall(text):
            values.setdefault(name, value)
        waiting += [substituted(name, values) for name in INCLUDE.findall(text)]
    return ScriptText(content.hexdigest(), frozenset(variables), tuple(unread))
