# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `resume` says of jobs that were killed, stopped, done, and of one that runs."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from click.testing import CliRunner

from CNCStepper.cli.main import group
from CNCStepper.control.journal import store
from CNCStepper.control.journal.journal_records import Group
from CNCStepper.control.journal.replay import FORMAT, VERSION
from CNCStepper.control.journal.writer import JournalFile
from CNCStepper.control.program.certificate import digest_of_text
from CNCStepper.errors import JobError, MachineRefusal

TEXT = "G21\nG1X1F600\nG1X2\n"
LONG = TEXT + "X3\nX2\n" * 500
HEADER = {
    "format": FORMAT, "version": VERSION, "begin": "2026-11-22 08:00:00", "machine": "Cutting table A", "port": "COM3",
    "firmware": "1.1h", "lines": 300, "last_line": 301, "homing": True, "goes_back": False, "file": "",
    "program_sha256": digest_of_text(TEXT),
}  # fmt: skip
GROUP = Group(1.8e9, 97, 60, 41, 43, 98, "Run", (-90.0, -40.0, -10.0), (10.0, 10.0, 10.0))


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "peça 1.nc"
    path.write_text(TEXT, "utf-8")
    return path


def journal(folder: Path, name: str = "1", group: Group = GROUP, end: dict | None = None, **header) -> JournalFile:
    file = JournalFile(folder / f"{name}.journal")
    file.append(HEADER | header)
    file.append(group.to_content() | (end or {}))
    return file


def said(*arguments: object) -> str:
    result = CliRunner().invoke(group, ["resume", *map(str, arguments)])
    if result.exception and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.output


def told(folder: Path, **header) -> str:
    file = journal(folder, **header)
    file.close()
    return said(file.path)


def test_a_killed_job_states_its_interval_and_the_restart(tmp_path, program):
    program.write_text(LONG, "utf-8")
    text = told(tmp_path, file=str(program), program_sha256=digest_of_text(LONG))
    assert "all before line 43 is cut" in text
    assert "line 43 may not have been begun, line 98 may have been sent" in text
    assert "Run at work X10.000 Y10.000 Z10.000, machine X-90.000 Y-40.000 Z-10.000 mm" in text
    assert "unknown: home it before the restart" in text
    assert "spindle, torch or beam may still be on" in text
    quote = '"' if os.name == "nt" else "'"
    sending = "--machine table-a --port COM3 --home"
    assert text.endswith(f"cncstepper restart {quote}{program}{quote} --line 43 --without-stock {sending}\n")


PATH = {
    "modes": "G0 G54 G17 G21 G90 G94", "offsets_mm": {"G54": [-100.0, -50.0, -20.0], "TLO": [0.0]},
    "mpos_mm": [-100.0, -50.0, -20.0], "lines": 3, "last_line": 3, "dialect": "grbl",
}  # fmt: skip


@pytest.mark.parametrize(("y_mm", "words"), [(-50.0, "on the path at line 3"), (-49.0, "OFF the path of these lines")])
def test_the_interval_is_told_as_places_and_the_last_place_beside_it(tmp_path, program, y_mm, words):
    group = Group(1.8e9, 3, 2, 2, 3, 3, "Run", (-98.5, y_mm, -20.0), (1.5, y_mm + 50, 0.0))
    text = told(tmp_path, file=str(program), group=group, **PATH)
    assert "from X1.000 Y0.000 Z0.000 at line 3, to X2.000 Y0.000 Z0.000 at line 3 (work, mm)" in text
    assert words in text


@pytest.mark.parametrize(("homing", "option"), [(True, "--work-zero -100.000,-50.000,-12.500"), (False, "")])
def test_a_zero_that_was_set_within_the_job_is_told_and_restarted_with(tmp_path, program, homing, option):
    group = Group(1.8e9, 3, 2, 2, 3, 3, "Run", (-98.5, -50.0, -12.5), (1.5, 0.0, 0.0))
    zero = {"line": 2, "modes": "G0 G54 G21", "offsets_mm": {"G54": [-100.0, -50.0, -12.5], "TLO": [0.0]}}
    end = {"zero": zero, "end": "stopped", "why": "stopped as asked", "position_known": True}
    text = told(tmp_path, file=str(program), group=group, end=end, **PATH | {"homing": homing})
    assert "set again at the pause at line 2: G54 X-100.000 Y-50.000 Z-12.500 (machine, mm)" in text
    assert "kept only if the controller stayed powered" in text and "may still be on" not in text
    words = ["--line", "3", "--without-stock", "--machine", "table-a", *option.split(), "--port", "COM3"]
    assert text.endswith(" ".join(words) + "\n")  # the position is kept: no --home


def test_of_a_restart_the_first_program_is_restarted_again(tmp_path, program):
    program.write_text(LONG, "utf-8")
    first = {"file": str(program), "program_sha256": digest_of_text(LONG), "lines": [[40, 812]]}
    text = told(tmp_path, file="part-restart.nc", program_sha256="00", restart_of=first)
    assert f"goes on with {program}: restart that one again" in text
    assert "--line 815 --without-stock --machine table-a " in text and "peça 1.nc" in text.splitlines()[-1]
    program.write_text("G21\n", "utf-8")
    assert "was changed since" in told(tmp_path, name="2", file="part-restart.nc", restart_of=first)
    again = first | {"lines": [[9, 812], [20, 812]]}
    assert "choose the pass yourself" in told(tmp_path, name="3", file="part-restart.nc", restart_of=again)


def test_a_job_that_lost_its_position_must_be_homed_or_set(tmp_path, program):
    end = {"end": "failed", "why": "the cable broke", "position_known": False}
    assert "unknown: home it" in told(tmp_path, file=str(program), end=end)
    text = told(tmp_path, name="2", file=str(program), end=end, homing=False)
    assert "unknown: set its zero again" in text and "failed       the cable broke\n" in text


@pytest.mark.parametrize(
    ("header", "words"),
    [
        ({"goes_back": True}, "choose the pass yourself"),
        ({"program_sha256": "00"}, "was changed since"),
        ({"file": "gone.nc"}, "not a file here any more: gone.nc"),
        ({"group": Group(1.0, 300, 300, 300, 0, 301)}, "every line is cut"),
        ({"group": Group(1.0, 64, 0, 0, 2, 65)}, "nothing is certainly cut"),
    ],
)
def test_no_command_is_offered_where_it_could_be_wrong(tmp_path, program, header, words):
    text = told(tmp_path, **{"file": str(program)} | header)
    assert words in text
    assert "cncstepper restart" not in text
    assert ("cncstepper send" in text) == ("nothing" in words)


def test_where_nothing_is_left_to_cut_no_restart_is_needed(tmp_path, program):
    program.write_text(f"{TEXT}G0Z5\nM5\n", "utf-8")
    group = Group(1.8e9, 5, 3, 3, 4, 5)
    text = told(tmp_path, file=str(program), program_sha256="", group=group, lines=5)
    assert text.endswith("none is needed: from there on the program cuts nothing\n")


def test_a_program_of_the_lathe_is_sent_whole_again(tmp_path, program):
    records = "G01 X-1. F1. #\n" + "Z-1. #\nZ1. #\n" * 50
    program.write_text(records, "utf-8")
    lathe = {"dialect": "mini-lathe", "machine": "Mini-lathe", "homing": False}
    text = told(tmp_path, file=str(program), program_sha256=digest_of_text(records), **lathe)
    assert "no entry in its middle: switch the lathe off and on" in text
    assert "cncstepper send " in text and "cncstepper restart" not in text


def test_damage_is_told(tmp_path, program):
    file = journal(tmp_path, file=str(program))
    file.append(GROUP.to_content())
    file.close()
    file.path.write_bytes(file.path.read_bytes()[:-9] + b"x" * 8 + b"\n")
    text = said(file.path)
    assert "line 3 of the journal is damaged" in text and "line 301 may have been sent" in text


def test_a_running_job_is_refused(tmp_path):
    file = journal(tmp_path)
    try:
        with pytest.raises(MachineRefusal, match=r"still runs, on COM3.*job-runs"):
            said(file.path)
    finally:
        file.close()


def test_what_is_no_journal_is_refused(tmp_path, program):
    with pytest.raises(JobError, match="journal-damaged"):
        said(program)


def test_the_latest_unfinished_is_taken_and_all_are_listed(tmp_path, monkeypatch):
    monkeypatch.setattr(store, "session_folder", lambda: tmp_path)
    assert "no job is unfinished" in said()
    journal(tmp_path, "1", file="a.nc").close()
    journal(tmp_path, "2", file="b.nc").close()
    journal(tmp_path, "3", file="c.nc", end={"end": "done", "why": "", "position_known": True}).close()
    assert "b.nc" in said() and "c.nc" not in said()
    assert [line.split()[2:4] for line in said("--all").splitlines()] == [
        ["done", "c.nc"],
        ["killed", "b.nc"],
        ["killed", "a.nc"],
    ]
