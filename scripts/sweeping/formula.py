# SPDX-License-Identifier: GPL-2.0-or-later
"""Formulae of columns, as pandas reads them: what can be wrong with one is known before there is a table."""
import ast

from sweeping.refused import guess, refuse

FUNCTIONS = ("abs", "sqrt", "exp", "expm1", "log", "log10", "log1p", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2", "sinh", "cosh", "tanh",
             "arcsinh", "arccosh", "arctanh", "floor", "ceil")
METHODS = ("mean", "min", "max", "median", "std", "sum")
PARTS = (ast.BinOp, ast.UnaryOp, ast.BoolOp, ast.Compare, ast.List)
FOREIGN = (ast.MatMult, ast.LShift, ast.RShift, ast.Is, ast.IsNot)


def parsed(where, text):
    try:
        tree = ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError):
        refuse(where, "a formula of columns", f"'{text}'")
    if isinstance(tree, (ast.Tuple, ast.List)):
        refuse(where, "one formula of columns", f"'{text}'")
    return tree


def is_method(node):
    """z.max(): one number of a column."""
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and isinstance(node.func.value, ast.Name) and not node.args and not node.keywords


def operands(where, node):
    """What an operation or a function acts on."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
        if node.func.id not in FUNCTIONS:
            refuse(where, f"a function out of {' '.join(FUNCTIONS)}", guess(node.func.id, FUNCTIONS))
        return node.args
    parts = list(ast.iter_child_nodes(node))
    if any(isinstance(part, ast.BitXor) for part in parts):
        refuse(where, "** for a power", "^")
    if not isinstance(node, PARTS) or any(isinstance(part, FOREIGN) for part in parts):
        refuse(where, "a formula of columns", f"'{ast.unparse(node)}' in it")
    return [part for part in parts if isinstance(part, ast.expr)]


def has_rows(where, node):
    """Whether its value depends on the row; refuses what is no formula."""
    if isinstance(node, ast.Name):
        return True
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float, str)):
        return False
    if is_method(node):
        if node.func.attr not in METHODS:
            refuse(where, f"one of {' '.join(METHODS)} of a column", guess(node.func.attr, METHODS))
        return False
    return any([has_rows(where, part) for part in operands(where, node)])


def check_formula(where, text):
    """Refuses what is no formula with a value for each row."""
    where = f"{where} '{text}'"
    if not has_rows(where, parsed(where, text)):
        refuse(where, "a formula with a value for each row (mean, max... of them is `take`)", "one number")


def columns_of(text):
    """Names of the columns in a checked formula."""
    nodes = list(ast.walk(ast.parse(text.strip(), mode="eval")))
    functions = [node.func for node in nodes if isinstance(node, ast.Call)]
    return [node.id for node in nodes if isinstance(node, ast.Name) and node not in functions]
