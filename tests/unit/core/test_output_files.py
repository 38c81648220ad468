# SPDX-License-Identifier: LGPL-2.1-or-later
"""No output is an input, none is written twice, and a foreign file is replaced only when that is asked."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from CNCStepper.errors import OutputError
from CNCStepper.output_files import MARKS, Input, Output, check_outputs, is_ours, is_same_file


@pytest.fixture
def program(tmp_path: Path) -> Path:
    folder = tmp_path / "peça 1"
    folder.mkdir()
    path = folder / "p.nc"
    path.write_text("G21\n", "ascii")
    return path


def spellings(path: Path) -> list[Path]:
    """Return other names of an existing file."""
    os.link(path, path.with_name("hard.nc"))
    path.with_name("soft.nc").symlink_to(path)
    path.parent.with_name("folder").symlink_to(path.parent)
    inside = path.parent / "inside"
    inside.mkdir()
    return [
        path.with_name("hard.nc"),
        path.with_name("soft.nc"),
        path.parent.with_name("folder") / path.name,
        inside / ".." / path.name,
        Path(os.path.relpath(path)),
    ]


def test_an_input_is_no_output_under_any_name_not_even_when_asked(program: Path) -> None:
    for path in (program, *spellings(program)):
        for overwrite in (False, True):
            with pytest.raises(OutputError) as caught:
                check_outputs([Output(path, "--out", "program")], [Input(program, "the program")], overwrite)
            assert caught.value.code == "output-is-input" and "--out" in str(caught.value)
            assert str(path) in str(caught.value)


def test_two_outputs_are_two_files_also_before_they_are_there(tmp_path: Path) -> None:
    (tmp_path / "folder").symlink_to(tmp_path)
    pairs = (("a.json", "a.json"), ("a.json", "folder/a.json"), ("new/a.json", "folder/new/../new/a.json"))
    for one, other in (*pairs, ("a.json", "A.json"), ("ação.json", "ac\u0327a\u0303o.json")):
        with pytest.raises(OutputError, match="--json and --out") as caught:
            check_outputs([Output(tmp_path / other, "--out"), Output(tmp_path / one, "--json")], [])
        assert caught.value.code == "output-twice"
    check_outputs([Output(tmp_path / "a.json", "--json"), Output(tmp_path / "b.json", "--out")], [])


def test_a_foreign_file_is_replaced_only_when_asked(program: Path) -> None:
    output = Output(program, "--out", "program")
    with pytest.raises(OutputError, match=r"p\.nc: --out would replace .*--overwrite") as caught:
        check_outputs([output], [])
    assert caught.value.code == "output-exists"
    check_outputs([output], [], overwrite=True)
    program.write_text("(made by CNCStepper: plate)\nG21\n", "ascii")
    check_outputs([output], [])
    with pytest.raises(OutputError):  # ours, but no report
        check_outputs([Output(program, "--json", "report")], [])
    program.write_bytes(b"")
    check_outputs([output], [])


def test_a_word_about_us_in_the_middle_of_a_foreign_file_is_no_mark(tmp_path: Path) -> None:
    foreign = b"G1 X1\n" * 20_000 + b"(made by CNCStepper)\n" + b"G1 X1\n" * 20_000
    (tmp_path / "p.nc").write_bytes(foreign)
    assert not is_ours(tmp_path / "p.nc", "program")
    for kind in MARKS:
        (tmp_path / "x").write_bytes(b"for the machine CNCStepper at home\n{}\n")
        assert not is_ours(tmp_path / "x", kind)


def test_devices_are_always_written() -> None:
    null = Path(os.devnull)
    check_outputs([Output(null, "--json", "report"), Output(null, "--out", "program")], [Input(null, "the program")])


def test_a_directory_is_refused_at_the_beginning(tmp_path: Path) -> None:
    with pytest.raises(IsADirectoryError):
        check_outputs([Output(tmp_path, "--json", "report")], [])


def test_files_that_are_not_there_differ_from_those_that_are(tmp_path: Path) -> None:
    (tmp_path / "a").touch()
    assert not is_same_file(tmp_path / "a", tmp_path / "b")
    assert is_same_file(tmp_path / "c", tmp_path / "." / "c")
