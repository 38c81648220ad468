# SPDX-License-Identifier: LGPL-2.1-or-later
"""How near two places must be to count as the same is declared in one table; no module has a constant of its own."""

from __future__ import annotations

import ast
import re

import pytest

from CNCStepper import tolerances
from helpers.imports import PACKAGE, modules

TABLE = PACKAGE / "tolerances.py"
SAMENESS = {"SAME", "SIMILAR", "EQUAL", "COINCIDENT", "TOUCH", "TOUCHING", "NODE", "NOTHING"}  # words of their names
LARGEST = 1.0  # larger constants are counts, picture points or milliseconds


def declared(source: str) -> list[str]:
    """Return the names of numbers that a module declares and that are tolerances of being the same."""
    return [
        target.id
        for statement in ast.parse(source).body
        if isinstance(statement, ast.Assign | ast.AnnAssign) and isinstance(statement.value, ast.Constant)
        if isinstance(statement.value.value, int | float) and statement.value.value <= LARGEST
        for target in (statement.targets if isinstance(statement, ast.Assign) else [statement.target])
        if isinstance(target, ast.Name) and is_tolerance(target.id)
    ]


def is_tolerance(name: str) -> bool:
    """Whether a name is that of a tolerance of being the same place, length, angle or number."""
    return bool(SAMENESS & set(name.strip("_").split("_")))


def test_no_module_declares_when_places_are_the_same() -> None:
    others = {module: path for module, path in modules().items() if path != TABLE and ".virtual." not in module}
    found = {module: declared(path.read_text("utf-8")) for module, path in others.items()}
    assert len(found) > 500
    assert not {module: names for module, names in found.items() if names}, "import these from CNCStepper.tolerances"


@pytest.mark.parametrize(
    "line", ["SAME_MM = 1e-6", "_SAME_PLACE_MM: float = 0.01", "TOUCH_MM = 1", "SAME = 1e-9", "SAME_FEED = 0.1"]
)
def test_a_planted_tolerance_is_found(line: str) -> None:
    assert len(declared(line)) == 1


@pytest.mark.parametrize("line", ["SAME_MS = 5", "SAME_PX = 1.5", "LIMIT_MM = 2.0", "from m import SAME_MM"])
def test_other_constants_are_none(line: str) -> None:
    assert not declared(line)


def test_each_row_has_its_value_and_its_meaning_once() -> None:
    rows = re.findall(r"^([A-Z_0-9]+) = ([0-9.e-]+)(?:  # (.+))?$", TABLE.read_text("utf-8"), re.MULTILINE)
    names = {name for name in vars(tolerances) if name.isupper()}
    assert [name for name, _, _ in rows] == list(dict.fromkeys(name for name, _, _ in rows))
    assert {name for name, _, _ in rows} == names
    assert all(0.0 < float(value) < 1.0 and len(meaning) > 10 for _, value, meaning in rows), rows


def test_each_row_is_used() -> None:
    text = "".join(path.read_text("utf-8") for path in modules().values() if path != TABLE)
    assert not [name for name in vars(tolerances) if name.isupper() and not re.search(rf"\b{name}\b", text)]
