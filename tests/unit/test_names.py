# SPDX-License-Identifier: LGPL-2.1-or-later
"""Modules have the field's words: none has a name that was given up, and the glossary has each word once."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[2]
GIVEN_UP_WORDS = """
    acts bare belief beside blame desk desk_client desk_worker earlier found front gap grid hand held idle items
    kept led leader letters lift loose made_with meanwhile memory moment one_way overheard page patience pieces
    plain play prepare reached read_runs reins relief retrace rounds said_modes same_switches same_work
    saved_modes simple speech stand stored story subject surface suspension take_up tape tell telling told watch
    ways wire_and_ways wishes
"""
COLUMNS = 4  # English, Portuguese, meaning, source


def rows() -> list[list[str]]:
    """Return the cells of the glossary's rows."""
    lines = (ROOT / "docs" / "glossary.md").read_text("utf-8").splitlines()
    table = [line for line in lines if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in table[1:]]


def test_no_module_has_a_name_that_was_given_up() -> None:
    stems = Counter(path.stem for path in (ROOT / "CNCStepper").rglob("*.py"))
    assert len(stems) > 500
    assert not sorted(set(GIVEN_UP_WORDS.split()) & set(stems))


def test_no_unit_test_imports_another_test() -> None:
    files = [path for folder in ("unit", "helpers") for path in (ROOT / "tests" / folder).rglob("*.py")]
    assert len(files) > 300
    found = [
        path.name for path in files if re.search(r"^\s*(from|import) test_", path.read_text("utf-8"), re.MULTILINE)
    ]
    assert not found, "what tests share is in tests/helpers"


def test_the_glossary_gives_each_word_once_in_both_languages() -> None:
    words = rows()
    assert len(words) > 50
    assert all(len(row) == COLUMNS and row[0] and row[1] and row[2] for row in words)
    english = [row[0] for row in words]
    assert len(set(english)) == len(english) and english == sorted(english, key=str.casefold)
