# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's material files: what FreeCAD writes is read, what is written comes back, all else is refused by line."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.errors import JobError
from CNCStepper.machine.files.fcmat_files import Content, fcmat_text, read_fcmat

# As FreeCAD 1.1 saves one: with a mark of the order of bytes, and lines of a text that begin in the first column.
SAVED = """\
\ufeff---
# File created by FreeCAD 1.1.3 Revision: 20260725 (Git shallow)
General:
  UUID: "6c388ddd-4abf-4ec8-9591-324b53a62ba1"
  Name: "Peça \\"ç\\" \\\\ #1"
  Description: "one: 1 # no comment
two 'x'

  three"
  Tags:
    - "a"
    - ["b",
      "c"]
# a comment

Models:
  Isotropic Linear Elastic:
    UUID: 'it''s' # a comment
    YoungsModulus: 210 GPa   # another
  "Hatch Pattern":
    PAT: |2
      *Square, 5: 5

        90,0
    Note: >-
      one
      two

      three
    Empty: ""
    # the end
"""
READ = {
    ("General", "UUID"): "6c388ddd-4abf-4ec8-9591-324b53a62ba1",
    ("General", "Name"): 'Peça "ç" \\ #1',
    ("General", "Description"): "one: 1 # no comment two 'x'\nthree",
    ("General", "Tags"): "",
    ("Models", "Isotropic Linear Elastic", "UUID"): "it's",
    ("Models", "Isotropic Linear Elastic", "YoungsModulus"): "210 GPa",
    ("Models", "Hatch Pattern", "PAT"): "*Square, 5: 5\n\n  90,0",
    ("Models", "Hatch Pattern", "Note"): "one two\nthree",
    ("Models", "Hatch Pattern", "Empty"): "",
}
REFUSED = {  # text: the line that is named
    "General\n": 1,
    "A:\n  B: 1\n C: 2\n": 3,
    "A: 1\n  B: 2\n": 2,
    "A: 1\nB: 2\nA: 3\n": 3,
    "A: x: y\n": 1,
    "A: *mark\n": 1,
    "A: {b: 1}\n": 1,
    "A: !tag 1\n": 1,
    "A:\n\tB: 1\n": 2,
    'A: 1\nB: "open\nC: 2\n': 2,
    'A: "x" y\n': 1,
    'A: "\\q"\n': 1,
    'A: "x\\': 1,
    "A: |x\n": 1,
    "A: 1\n---\nB: 1\n": 2,
    "\n".join(" " * depth + "a:" for depth in range(12)): 11,
}
LETTERS = st.characters(exclude_categories=["Cs"])
NAMES = st.from_regex(r"[A-Za-z]([\wçé ]{0,8}\w)?", fullmatch=True)
TEXTS = st.text(LETTERS, max_size=30) | st.sampled_from(["", "'", '"', "a: b", "# c", "x # y", "- z", "\\", "ç", "\n"])


def read(folder: Path, text: str) -> Content:
    file = folder / "a.FCMat"
    file.write_bytes(text.encode("utf-8"))
    return read_fcmat(file)


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_what_freecad_saves_is_read(tmp_path: Path, end: str) -> None:
    found = read(tmp_path, SAVED.replace("\n", end))
    assert {keys: entry.text for keys, entry in found.items()} == READ
    assert found["Models", "Isotropic Linear Elastic", "YoungsModulus"].line == 19


@given(content=st.dictionaries(NAMES, TEXTS | st.dictionaries(NAMES, TEXTS, min_size=1), min_size=1))
def test_what_is_written_comes_back(tmp_path_factory: pytest.TempPathFactory, content: dict[str, Any]) -> None:
    expected = {(key,): value for key, value in content.items() if isinstance(value, str)}
    expected |= {
        (key, inner): text for key, value in content.items() if isinstance(value, dict) for inner, text in value.items()
    }
    found = read(tmp_path_factory.getbasetemp(), fcmat_text(content))
    assert {keys: entry.text for keys, entry in found.items()} == expected


@pytest.mark.parametrize("text", REFUSED)
def test_a_malformed_file_is_refused_by_its_line(tmp_path: Path, text: str) -> None:
    with pytest.raises(JobError) as caught:
        read(tmp_path, text)
    assert caught.value.code == "fcmat" and caught.value.advice
    assert caught.value.place is not None and caught.value.place.line == REFUSED[text]


def test_a_file_of_freecad_0_20_is_refused_as_such(tmp_path: Path) -> None:
    with pytest.raises(JobError, match="fcmat-old"):
        read(tmp_path, "; Steel\n; (c) somebody\n\n[General]\nName = Steel\n")


def test_bytes_that_are_no_utf_8_are_refused(tmp_path: Path) -> None:
    (tmp_path / "b.FCMat").write_bytes(b"General:\n  Name: \xff\n")
    with pytest.raises(JobError, match="UTF-8"):
        read_fcmat(tmp_path / "b.FCMat")


@pytest.mark.parametrize("text", ['A: "' + "x\n" * 500_000, "A" + " " * 1_000_000, "A: " + " #" * 500_000 + ":"])
def test_a_hostile_file_costs_little(tmp_path: Path, text: str) -> None:
    with pytest.raises(JobError, match="fcmat"):
        read(tmp_path, text + "\nB\n")
