# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which journals are kept, which is the one to resume, and who holds its lock."""

from __future__ import annotations

import os
import subprocess
import sys
import time

import pytest

from CNCStepper.control.journal import store
from CNCStepper.control.journal.journal_records import Group
from CNCStepper.control.journal.replay import FORMAT, KILLED, RUNNING, VERSION, read_replay
from CNCStepper.control.journal.store import (
    RECENT_S,
    journals,
    latest_unfinished,
    prune,
    unfinished_at,
)
from CNCStepper.control.journal.writer import JournalFile
from CNCStepper.control.processes.file_lock import is_locked

GROUP = Group(1.0, 10, 5, 2, 3, 11).to_content()
HEADER = {"format": FORMAT, "version": VERSION, "lines": 20, "last_line": 20}


def written(path, end="", age_s=0.0, **header):
    file = JournalFile(path)
    file.append(HEADER | header)
    file.append(GROUP)
    if end:
        file.append({"end": end, "why": "so", "position_known": True, **GROUP})
    file.close()
    os.utime(path, (time.time() - age_s,) * 2)
    return path


def test_the_oldest_finished_go_and_the_unfinished_stay(tmp_path, monkeypatch):
    monkeypatch.setattr(store, "KEPT_JOBS", 3)
    unfinished = written(tmp_path / "00.journal")
    failed = written(tmp_path / "01.journal", "failed")
    given_up = written(tmp_path / "02.journal", age_s=RECENT_S + 60)
    damaged = tmp_path / "03.journal"
    damaged.write_bytes(b"no journal")
    done = [written(tmp_path / f"{number}.journal", "done") for number in range(10, 16)]
    prune(tmp_path)
    assert set(journals(tmp_path)) == {unfinished, failed, *done[-3:]}
    assert not given_up.exists() and not damaged.exists()


def test_too_many_bytes_go_too(tmp_path, monkeypatch):
    kept = [written(tmp_path / f"{number}.journal", "done") for number in range(10, 16)]
    monkeypatch.setattr(store, "KEPT_BYTES", 2 * kept[0].stat().st_size)
    prune(tmp_path)
    assert journals(tmp_path) == [kept[5], kept[4]]


def test_the_latest_that_was_not_cut_to_its_end_is_the_one_to_resume(tmp_path):
    assert latest_unfinished(tmp_path) is None
    written(tmp_path / "1.journal")
    stopped = written(tmp_path / "2.journal", "stopped")
    written(tmp_path / "3.journal", "done")
    story = latest_unfinished(tmp_path)
    assert story.path == stopped and story.why == "so" and story.position_known


def test_the_last_job_of_a_machine_is_offered_where_it_did_not_end(tmp_path):
    written(tmp_path / "1.journal", "stopped", port="COM3")
    lost = written(tmp_path / "2.journal", port="COM4")
    written(tmp_path / "3.journal", "done", port="COM3")
    assert unfinished_at("COM3", tmp_path) is None and unfinished_at("COM5", tmp_path) is None
    assert unfinished_at("COM4", tmp_path).path == lost
    running = JournalFile(tmp_path / "4.journal")
    running.append(HEADER | {"port": "COM4"})
    running.append(GROUP)
    assert unfinished_at("COM4", tmp_path) is None
    running.close()
    assert unfinished_at("COM4", tmp_path).end == KILLED


@pytest.mark.parametrize(
    ("port", "other", "same"),
    [
        ("socket://127.0.0.1:4711", "socket://localhost:4712", True),  # virtual machines are told by no number
        ("socket://192.168.0.7:23", "socket://192.168.0.8:23", False),
        ("socket://192.168.0.7:23", "telnet://192.168.0.7/", True),
        ("/dev/ttyUSB0", "/dev/ttyUSB0", True),
        ("COM3", "com3", True),
        ("COM3", "COM33", False),
    ],
)
def test_a_machine_is_known_by_its_port_whatever_it_is_called(tmp_path, port, other, same):
    lost = written(tmp_path / "1.journal", port=port)
    story = unfinished_at(other, tmp_path)
    assert (story.path if story else None) == (lost if same else None)


def test_a_running_job_is_told_from_a_killed_one(tmp_path):
    path = tmp_path / "1.journal"
    script = (
        "import sys, time; from pathlib import Path; from CNCStepper.control.journal.writer import JournalFile\n"
        f"file = JournalFile(Path(sys.argv[1])); file.append({HEADER!r}); file.append({GROUP!r})\n"
        "print('written', flush=True); time.sleep(600)"
    )
    with subprocess.Popen([sys.executable, "-c", script, str(path)], stdout=subprocess.PIPE) as process:
        assert process.stdout.readline() == b"written" + os.linesep.encode()
        assert is_locked(path) and read_replay(path).end == RUNNING
        process.kill()
    assert not is_locked(path) and read_replay(path).end != RUNNING


@pytest.mark.skipif(os.name != "posix", reason="rights of files are kept otherwise there")
def test_a_journal_is_its_owners_only(tmp_path):
    assert written(tmp_path / "1.journal").stat().st_mode & 0o777 == 0o600
