# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Formulas of study files: numbers, names and known functions only, so that a file can do nothing but
compute.
"""

import ast
from typing import Any, Callable, Dict

import numpy as np

from .errors import InputError
from .theory import hertz, johnson

FUNCTIONS: Dict[str, Callable[..., Any]] = {
    "sqrt": np.sqrt,
    "exp": np.exp,
    "ln": np.log,
    "log": np.log,
    "log2": np.log2,
    "log10": np.log10,
    "abs": np.abs,
    "sign": np.sign,
    "rint": np.rint,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "atan2": np.arctan2,
    "sinh": np.sinh,
    "cosh": np.cosh,
    "tanh": np.tanh,
    "ceil": np.ceil,
    "floor": np.floor,
    "hertz": hertz,
    "johnson": johnson,
    "min": lambda *values: np.minimum.reduce(np.broadcast_arrays(*values)),
    "max": lambda *values: np.maximum.reduce(np.broadcast_arrays(*values)),
}
CONSTANTS = {"pi": np.pi, "_e": np.e}
OPERATORS: Dict[type, Callable[..., Any]] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: np.divide,
    ast.Pow: np.power,
    ast.Lt: np.less,
    ast.LtE: np.less_equal,
    ast.Gt: np.greater,
    ast.GtE: np.greater_equal,
}
SIGNS: Dict[type, Callable[..., Any]] = {ast.USub: np.negative, ast.UAdd: np.positive}


class Formula:
    """
    A formula of names, to be worked out for numbers or arrays; `^` is a power, as in parameter
    files.

    >>> f = Formula("0.5 * (top + bottom)^2")
    >>> sorted(f.names), float(f({"top": 1., "bottom": 3.}))
    (['bottom', 'top'], 8.0)
    >>> float(Formula("johnson(0.01, 10e6, 0.45, 5e-3)")({})) > 0
    True
    """

    def __init__(self, text):
        self.text = text
        try:
            self.tree = ast.parse(text.strip().replace("^", "**"), mode="eval").body
        except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
            raise InputError(f"'{text}' is no formula") from error
        self.names = set()
        try:
            self.check(self.tree)
        except RecursionError as error:
            raise InputError(f"'{text[:40]}…' is too deep a formula") from error

    def check(self, node):
        """Refuses what is neither number, name, operator nor known function; collects the names."""
        if (
            isinstance(node, ast.Constant)
            and isinstance(node.value, (int, float))
            and not isinstance(node.value, bool)
        ):
            return
        if isinstance(node, ast.Name):
            if node.id not in CONSTANTS:
                self.names.add(node.id)
        elif isinstance(node, ast.UnaryOp) and type(node.op) in SIGNS:
            self.check(node.operand)
        elif isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
            self.check(node.left)
            self.check(node.right)
        elif (
            isinstance(node, ast.Compare) and len(node.ops) == 1 and type(node.ops[0]) in OPERATORS
        ):
            self.check(node.left)
            self.check(node.comparators[0])
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
            if node.func.id not in FUNCTIONS:
                raise InputError(
                    f"'{self.text}' calls {node.func.id}(); there are"
                    f" {', '.join(sorted(FUNCTIONS))}"
                )
            for argument in node.args:
                self.check(argument)
        else:
            raise InputError(f"'{self.text}' is no formula of numbers, names and functions")

    def __call__(self, values):
        """The result for {name: number or array}; every name must be there."""
        with np.errstate(all="ignore"):
            try:
                return self.work_out(self.tree, values)
            except (TypeError, ValueError, OverflowError) as error:
                raise InputError(f"'{self.text}' cannot be worked out: {error}") from error

    def work_out(self, node: Any, values):
        if isinstance(node, ast.Constant):
            return float(node.value)
        if isinstance(node, ast.Name):
            return CONSTANTS[node.id] if node.id in CONSTANTS else values[node.id]
        if isinstance(node, ast.UnaryOp):
            return SIGNS[type(node.op)](self.work_out(node.operand, values))
        if isinstance(node, ast.Call):
            name: Any = node.func
            return FUNCTIONS[name.id](*(self.work_out(one, values) for one in node.args))
        left, operator, right = (
            (node.left, node.op, node.right)
            if isinstance(node, ast.BinOp)
            else (node.left, node.ops[0], node.comparators[0])
        )
        result = OPERATORS[type(operator)](
            self.work_out(left, values), self.work_out(right, values)
        )
        return result if isinstance(node, ast.BinOp) else np.asarray(result, dtype=float)
