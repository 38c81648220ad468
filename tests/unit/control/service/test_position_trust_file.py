# SPDX-License-Identifier: LGPL-2.1-or-later
"""An unknown position on the disk: kept by port, gone when it is known, and never in the way of people's files."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from CNCStepper.control.service.position_trust_file import POSITION, PositionTrustFile
from CNCStepper.control.session import files
from CNCStepper.control.stream.position_trust import AT_HOME, LOST, NOTHING_AGAINST
from CNCStepper.errors import JobError

PORTS = ("/dev/ttyUSB0", "COM3", "socket://127.0.0.1:2217", "/tmp/peça 1/table", "../../etc/passwd", "x" * 500, "")
HALF_ZEROED = LOST._replace(zeroed=frozenset("XY"))
FROM_HERE = LOST._replace(counts_from_here=True)


def kept(folder: Path, port: str = "COM3") -> PositionTrustFile:
    return PositionTrustFile.of_port(folder, port)


@pytest.mark.parametrize("trust", [LOST, HALF_ZEROED, FROM_HERE])
def test_what_is_unknown_is_found_again_by_whoever_comes_next(tmp_path, trust):
    kept(tmp_path).keep(trust)
    assert kept(tmp_path).trust == trust
    assert kept(tmp_path, "COM4").trust == NOTHING_AGAINST


@pytest.mark.parametrize("trust", [NOTHING_AGAINST, AT_HOME])
def test_what_is_known_again_leaves_no_file(tmp_path, trust):
    kept(tmp_path).keep(LOST)
    kept(tmp_path).keep(trust)
    assert kept(tmp_path).trust == NOTHING_AGAINST and not list(tmp_path.iterdir())


def test_names_of_ports_stay_in_the_folder_and_apart(tmp_path):
    folder = tmp_path / "sessions ç"
    folder.mkdir()
    for port in PORTS:
        kept(folder, port).keep(LOST)
    assert len(list(folder.glob(f"*{POSITION}"))) == len(PORTS) and list(tmp_path.iterdir()) == [folder]


@pytest.mark.skipif(os.name != "posix", reason="modes of files")
def test_only_its_owner_reads_it(tmp_path):
    kept(tmp_path).keep(LOST)
    assert [path.stat().st_mode & 0o777 for path in tmp_path.iterdir()] == [0o600]


@pytest.mark.parametrize("text", ["", "{", "[]", "{}", '{"counts_from_here": true}', "\x00\xff"])
def test_a_damaged_file_still_says_that_the_position_was_lost(tmp_path, text):
    kept(tmp_path).keep(FROM_HERE)
    (path,) = tmp_path.iterdir()
    path.write_bytes(text.encode("latin-1"))
    assert kept(tmp_path).trust == LOST


def test_a_full_disk_is_refused_in_words_told_once_and_changes_nothing(tmp_path, monkeypatch):
    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    kept(tmp_path).keep(HALF_ZEROED)
    monkeypatch.setattr(files.os, "fsync", full)
    told = []
    file = kept(tmp_path)
    for _ in range(3):
        file.save_or_warn(LOST, lambda *words: told.append(words))
    assert [kind for kind, _ in told] == ["warning"] and "No space left" in told[0][1]
    with pytest.raises(JobError, match="make room"):
        kept(tmp_path).keep(LOST)
    assert kept(tmp_path).trust == HALF_ZEROED and len(list(tmp_path.iterdir())) == 1


def test_without_a_path_nothing_is_written():
    file = PositionTrustFile(None)
    file.keep(LOST)
    assert file.trust == LOST
