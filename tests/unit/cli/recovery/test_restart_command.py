# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that `resume` offers: all that the job was made with, so that it runs as it is pasted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from CNCStepper.cli.common.options import merged, plain_options
from CNCStepper.cli.job import send as send_verb
from CNCStepper.cli.main import group
from CNCStepper.cli.recovery.restart_command import NO_PROFILE, RestartLine
from CNCStepper.control.journal.journal_records import Group
from CNCStepper.control.journal.replay import FORMAT, VERSION, JobReplay, read_replay
from CNCStepper.control.journal.writer import JournalFile
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.machine.profile import load_machine

TEXT = "G21 G90\nM3 S12000\nG0 Z5\nX0 Y0\nG1 Z-1 F300\nX20 F2000\nY10\nX0\nY0\nG0 Z5\nM5\nM2\n"
SHIPPED = Path(__file__).parents[4] / "CNCStepper" / "machine" / "profiles" / "table-a.toml"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "peças do João"
    folder.mkdir()
    (folder / "peça 1.nc").write_text(TEXT, "utf-8")
    return folder


@pytest.fixture
def profile(folder: Path) -> Path:
    path = folder / "My own çable.toml"
    path.write_text(SHIPPED.read_text("utf-8").replace("Cutting table A", "My own çable"), "utf-8")
    assert load_machine(path).name == "My own çable"
    return path


@pytest.fixture
def sent(monkeypatch: pytest.MonkeyPatch) -> list[SendJob]:
    """The jobs that `send` would have begun."""
    jobs: list[SendJob] = []

    def confirmed(job: SendJob, confirmed: bool) -> SendJob:
        jobs.append(job)
        raise KeyboardInterrupt

    monkeypatch.setattr(send_verb, "confirmed", confirmed)
    return jobs


def called(*arguments: object) -> str:
    return CliRunner().invoke(group, list(map(str, arguments))).output


def story(folder: Path, job: SendJob | None = None, *, end: dict[str, Any] | None = None, **header: Any) -> JobReplay:
    content: dict[str, Any] = {
        "format": FORMAT, "version": VERSION, "begin": "", "file": "", "program_sha256": "", "machine": "",
        "port": "COM3", "firmware": "1.1h", "lines": 12, "last_line": 12, "homing": False, "goes_back": False,
    }  # fmt: skip
    if job:
        content |= {"machine": job.machine, "profile": job.retrace["machine"], "made_with": job.made_with}
        content |= {"dialect": job.retrace["dialect"], "baud": job.baud}
    with_end = Group(1.8e9, 9, 9, 6, 7, 9, "Run", None, None).to_content() | (end or {})
    file = JournalFile(folder / "20261122-081502-5d0c7f1e.journal")
    file.append(content | header)
    file.append(with_end)
    file.close()
    return read_replay(file.path)


def line_of(story: JobReplay, folder: Path) -> RestartLine:
    return RestartLine(story, folder / "peça 1.nc", 7)


def test_all_that_send_was_given_is_offered_again_and_proven_as_pasted(
    folder: Path, profile: Path, sent: list[SendJob], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    against = ("--stock", "100,100.5,10", "--origin", "top-left-front", "--tool", "flat:2", "--dialect", "grbl")
    more = ("--search", ".", "--work-zero", "-100,-50,-20", "--baud", "9600")
    called("send", "peça 1.nc", "--port", "COM3", "--machine", profile.name, *against, *more)
    monkeypatch.chdir(folder.parent)
    offered = line_of(story(folder, sent[0], homing=True), folder)
    assert offered.told == []
    assert offered.words == [
        *("cncstepper", "restart", str(folder / "peça 1.nc"), "--line", "7", "--machine", str(profile), *against[:4]),
        *("--tool", "flat:2", "--work-zero", "-100,-50,-20", "--search", str(folder), "--dialect", "grbl"),
        *("--port", "COM3", "--baud", "9600", "--home"),
    ]
    dry = [word for word in offered.words[1:] if word not in ("--port", "COM3", "--baud", "9600", "--home")]
    result = CliRunner().invoke(group, dry)
    assert result.exit_code == 0, result.output
    assert "simulated on the stock that the earlier moves have left" in result.output


def test_a_profile_that_is_gone_is_offered_as_the_journal_has_it(
    folder: Path, profile: Path, sent: list[SendJob]
) -> None:
    called("send", folder / "peça 1.nc", "--port", "COM3", "--machine", profile)
    machine = load_machine(profile)
    profile.unlink()
    offered = line_of(story(folder, sent[0]), folder)
    copy = offered.words[offered.words.index("--machine") + 1]
    assert load_machine(copy) == machine
    assert any(str(profile) in text and copy in text for _, text in offered.told)


def test_the_language_of_the_job_is_offered_where_the_machine_alone_would_not_say_it(folder: Path) -> None:
    words = line_of(story(folder, machine="Cutting table A", dialect="grblhal"), folder).words
    assert words[words.index("--dialect") + 1] == "grblhal"


@pytest.mark.parametrize(("machine", "named"), [("Cutting table A", "table-a"), ("my-table", NO_PROFILE)])
def test_a_journal_without_a_profile_says_which_is_missing(folder: Path, machine: str, named: str) -> None:
    offered = line_of(story(folder, machine=machine), folder)
    assert offered.words[offered.words.index("--machine") + 1] == named
    assert any("the profile of my-table" in text for _, text in offered.told) == (named == NO_PROFILE)


def test_a_job_without_stock_is_offered_as_one_and_says_so(folder: Path, sent: list[SendJob]) -> None:
    called("send", folder / "peça 1.nc", "--port", "COM3", "--machine", "table-a")
    offered = line_of(story(folder, sent[0]), folder)
    assert "--without-stock" in offered.words
    assert any("give --stock and --tool, or --job" in text for _, text in offered.told)


def test_files_that_are_not_as_they_were_are_told(folder: Path) -> None:
    job, table = folder / "part.toml", folder / "tool.tbl"
    for file in (job, table):
        file.write_text("", "utf-8")
    made_with = plain_options({"--job": [job], "--tool-table": [table], "--part": [2]})
    job.write_text("#", "utf-8")
    table.unlink()
    offered = line_of(story(folder, made_with=made_with), folder)
    assert [name for name, _ in offered.told] == ["changed", "missing"]
    assert "--machine" not in offered.words and offered.words[-6:-2] == ["--tool-table", str(table), "--part", "2"]


@pytest.mark.parametrize(
    ("homing", "greeted", "end", "home"),
    [
        (True, False, {}, True),
        (True, False, {"end": "stopped", "position_known": True}, False),
        (True, True, {"end": "stopped", "position_known": True}, True),
        (True, False, {"end": "failed", "position_known": False}, True),
        (False, False, {"end": "failed", "position_known": False}, False),
    ],
)
def test_a_machine_that_may_have_lost_its_place_is_homed_if_it_can(
    folder: Path, homing: bool, greeted: bool, end: dict[str, Any], home: bool
) -> None:
    zero = {"options": {"--work-zero": ["1,2,3"]}, "files": {}}
    offered = line_of(story(folder, end=end, homing=homing, greeted=greeted, made_with=zero), folder)
    assert ("--home" in offered.words) == home
    assert ("--work-zero" in offered.words) == homing  # else machine coordinates mean nothing any more


def test_the_command_line_wins_over_what_the_certificate_was_made_with() -> None:
    proven = {"options": {"--job": ["a.toml"], "--part": ["2"], "--search": ["s"]}, "files": {"a.toml": "0"}}
    own = {"options": {"--stock": ["1,1,1"], "--tool": ["flat:2"]}, "files": {}}
    assert set(merged(proven, own)["options"]) == {"--search", "--stock", "--tool"}
    assert merged(proven, {"options": {}, "files": {}}) == proven
    assert merged({}, own) == own


def test_a_certificate_tells_the_job_that_it_was_made_from(folder: Path, sent: list[SendJob]) -> None:
    certificate = folder / "peça.json"
    against = ("--machine", "table-a", "--stock", "100,100,10", "--tool", "flat:2")
    called("check", folder / "peça 1.nc", *against, "--certificate", certificate)
    called("send", folder / "peça 1.nc", "--port", "COM3", "--certificate", certificate)
    offered = line_of(story(folder, sent[0]), folder)
    assert offered.words[5:11] == list(against)
