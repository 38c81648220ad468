# SPDX-License-Identifier: LGPL-2.1-or-later
"""The import statements of the package: which module imports which, and when."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "CNCStepper"
QT = {"PySide", "PySide2", "PySide6", "PyQt5", "PyQt6", "shiboken2", "shiboken6", "pivy"}
FREECAD = {"FreeCAD", "FreeCADGui", "Part", "PartDesign", "Sketcher", "Draft", "Path", "Mesh", "Import"}


FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


@cache
def imported(source: str, package: str) -> tuple[tuple[str, bool], ...]:
    """Return every dotted name that `source` imports and whether that happens when the module is loaded."""
    return tuple(_imported(ast.parse(source), package, at_load=True))


def _imported(node: ast.AST, package: str, at_load: bool) -> Iterator[tuple[str, bool]]:
    for name in names_of(node, package):
        yield name, at_load
    for child in ast.iter_child_nodes(node):
        yield from _imported(child, package, at_load and not isinstance(node, FUNCTIONS))


def names_of(node: ast.AST, package: str) -> Iterator[str]:
    """Yield the dotted names that one statement imports."""
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
    elif isinstance(node, ast.ImportFrom):
        outer = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
        base = ".".join([*outer, *([node.module] if node.module else [])])
        yield from (f"{base}.{alias.name}" for alias in node.names)
    elif isinstance(node, ast.Call) and _is_import(node.func):
        for argument in node.args[:1]:
            if isinstance(argument, ast.Constant):
                yield str(argument.value)
            elif isinstance(argument, ast.JoinedStr):  # f"CNCStepper.cli.{name}" names its room at the front
                yield ast.unparse(argument)[2:].split("{")[0]


def _is_import(function: ast.expr) -> bool:
    if isinstance(function, ast.Attribute):
        return function.attr == "import_module"
    return isinstance(function, ast.Name) and function.id in ("import_module", "__import__")


def modules() -> dict[str, Path]:
    """Return all modules of the package by dotted name."""
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def package_of(module: str, path: Path) -> str:
    """Return the package to which a module's relative imports refer."""
    return module if path.name == "__init__.py" else module.rpartition(".")[0]
