# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file that a person names is a regular one of bounded size, or it is refused in words, and nothing waits."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

import pytest

from CNCStepper.errors import JobError, ProgramError
from CNCStepper.input_file import read_input

posix = pytest.mark.skipif(os.name != "posix", reason="only POSIX has FIFOs and devices in folders")


def refusal(path: str | Path, most_bytes: int = 1000) -> JobError:
    """Return the error of a file that is refused; whatever waits for more than a second fails."""
    found: list[BaseException] = []

    def read() -> None:
        try:
            read_input(path, most_bytes)
        except BaseException as error:
            found.append(error)

    reader = threading.Thread(target=read, daemon=True)
    reader.start()
    reader.join(5.0)
    assert not reader.is_alive(), "it waits"
    assert isinstance(found[0], JobError), found
    return found[0]


def test_a_file_is_read_to_the_last_byte_that_is_allowed(tmp_path: Path) -> None:
    file = tmp_path / "peça com espaço.toml"
    file.write_bytes(b"\x00\r\n\x1a" * 250)
    assert read_input(file, 1000) == b"\x00\r\n\x1a" * 250
    error = refusal(file, 999)
    assert error.code == "input-large"
    assert (error.value, error.limit) == ("0.001 MB", "0.000999 MB")
    assert "peça com espaço.toml" in str(error)


@posix
def test_a_link_to_a_file_is_followed(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"x")
    (tmp_path / "link").symlink_to(tmp_path / "file")
    assert read_input(tmp_path / "link") == b"x"


def test_folders_and_names_of_nothing_are_named(tmp_path: Path) -> None:
    assert refusal(tmp_path).code == "input-kind"
    assert "a folder" in str(refusal(tmp_path))
    assert refusal(tmp_path / "nothing").code == "input-missing"
    assert refusal("a\x00b").code == "input-unreadable"
    assert refusal("x" * 5000).code in ("input-unreadable", "input-missing")
    assert "\x1b" not in str(refusal("\x1b]0;title\x07"))


@posix
def test_fifos_devices_and_sockets_are_refused_at_once(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "fifo")
    assert "FIFO" in refusal(tmp_path / "fifo").what
    for device in ("/dev/zero", "/dev/null"):
        assert "a device" in refusal(device).what
    (tmp_path / "zero").symlink_to("/dev/zero")
    assert refusal(tmp_path / "zero").code == "input-kind"
    with tempfile.TemporaryDirectory() as folder, socket.socket(socket.AF_UNIX) as listener:
        listener.bind(f"{folder}/s")
        assert "a socket" in refusal(f"{folder}/s").what


@posix
def test_a_name_that_becomes_a_fifo_after_the_first_look_does_not_wait(tmp_path: Path, monkeypatch) -> None:
    (tmp_path / "file").write_bytes(b"x")
    os.mkfifo(tmp_path / "fifo")
    monkeypatch.setattr("CNCStepper.input_file.input_kind", lambda path: "")
    assert refusal(tmp_path / "fifo").code == "input-kind"


@posix
def test_a_file_that_grows_while_it_is_read_is_refused(tmp_path: Path, monkeypatch) -> None:
    file = tmp_path / "file"
    file.write_bytes(b"x" * 10)
    real = os.fstat

    def smaller(handle: int) -> os.stat_result:
        status = list(real(handle))
        status[6] = 10
        return os.stat_result(status)

    file.write_bytes(b"x" * 100)
    monkeypatch.setattr("CNCStepper.input_file.os.fstat", smaller)
    assert refusal(file, 50).code == "input-large"


READ = """
import sys
from CNCStepper.input_file import read_input
from CNCStepper.errors import ProgramError
try:
    print(len(read_input(sys.argv[1], int(sys.argv[2]), streams=sys.argv[3] == "yes", refusal=ProgramError)))
except ProgramError as error:
    print(error.code)
"""


def told(name: str, most_bytes: int, streams: bool, given: bytes) -> str:
    """Return what a process of its own says that reads `name` with `given` as its standard input."""
    command = [sys.executable, "-c", READ, name, str(most_bytes), "yes" if streams else "no"]
    return subprocess.run(command, input=given, capture_output=True, timeout=60, check=True).stdout.decode().strip()


def test_standard_input_is_read_where_it_is_allowed() -> None:
    assert told("-", 1000, True, b"x" * 1000) == "1000"
    assert told("-", 999, True, b"x" * 1000) == "input-large"
    assert told("-", 1000, False, b"x") == "input-missing"


@posix
def test_the_names_of_standard_input_are_pipes_only_where_allowed() -> None:
    for name in ("/dev/stdin", "/dev/fd/0"):
        assert told(name, 3_000_000, True, b"x" * 2_500_000) == "2500000"
        assert told(name, 1000, False, b"x") == "input-kind"


@posix
def test_the_refusal_is_of_the_kind_that_the_caller_wants(tmp_path: Path) -> None:
    with pytest.raises(ProgramError):
        read_input(tmp_path, refusal=ProgramError)
