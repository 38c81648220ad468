# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bundle: the same columns as in memory, whatever is asked for, never many at once; what is none is refused."""

from __future__ import annotations

import io
import json
import os
import random
import sys
import tracemalloc
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.control.program import bundle as bundles
from CNCStepper.control.program.bundle import (
    BLOCK,
    LINE_MAP,
    WIRE,
    head_bytes,
    is_bundle,
    line_bytes,
    read_bundle,
    write_bundle,
)
from CNCStepper.control.program.certificate import FORMAT, VERSION, Certificate, digest_of_lines, sendable
from CNCStepper.control.program.send_job import SendJob, read_job, write_job
from CNCStepper.errors import CNCStepperError, JobError, Place, ProgramError

LINES = [f"G1X{number}Y.5" for number in range(3 * BLOCK + 7)]
NUMBERS = [3 * number + 2 for number in range(len(LINES))]
FUZZ = int(os.environ.get("CNCSTEPPER_FILE_FUZZ", "300"))


@pytest.fixture(scope="module")
def stored(tmp_path_factory: pytest.TempPathFactory) -> SendJob:
    path = tmp_path_factory.mktemp("bundle ç") / "job.wire"
    write_job(path, SendJob("port", LINES, "part.nc", NUMBERS, baud=9600))
    if os.name == "posix":
        assert path.stat().st_mode & 0o077 == 0
    return read_job(path)


def archive(path: Path, members: dict[str, bytes], **how: Any) -> Path:
    """Write a zip as any program does."""
    with zipfile.ZipFile(path, "w", **how) as file:
        for name, data in members.items():
            file.writestr(name, data)
    return path


def array(numbers: Any) -> bytes:
    data = io.BytesIO()
    np.save(data, numbers)
    return data.getvalue()


def test_lines_and_their_places_are_the_same(stored: SendJob) -> None:
    assert stored.baud == 9600 and list(stored.lines) == LINES and list(stored.file_lines) == NUMBERS
    assert len(stored.lines) == len(LINES) and stored.lines[5:8] == tuple(LINES[5:8])
    assert stored.place(2 * BLOCK).line == NUMBERS[2 * BLOCK] and type(stored.file_lines[0]) is int
    stored.check()


@given(places=st.lists(st.integers(-len(LINES), len(LINES) - 1), max_size=20))
def test_any_line_is_found_in_any_order(stored: SendJob, places: list[int]) -> None:
    assert [stored.lines[place] for place in places] == [LINES[place] for place in places]
    assert [stored.file_lines[place] for place in places] == [NUMBERS[place] for place in places]


@pytest.mark.parametrize("place", [len(LINES), -len(LINES) - 1])
def test_no_line_beyond_the_end(stored: SendJob, place: int) -> None:
    with pytest.raises(IndexError):
        stored.lines[place]


@pytest.mark.parametrize("count", [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK])
@pytest.mark.parametrize("piece", [7, 1 << 20])
def test_blocks_end_where_they_should(count: int, piece: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bundles, "CHUNK_BYTES", piece)
    lines = [str(number) for number in range(count)]
    write_job(tmp_path / "job.wire", SendJob("port", lines))
    job = read_job(tmp_path / "job.wire")
    assert list(job.lines) == lines and not len(job.file_lines)
    assert all(job.lines[place] == lines[place] for place in range(0, count, 100))


def test_lines_of_any_text_come_back(tmp_path: Path) -> None:
    write_job(tmp_path / "job.wire", SendJob("port", ["", "G1 X1", "é", ""]))
    assert list(read_job(tmp_path / "job.wire").lines) == ["", "G1 X1", "é", ""]


def test_line_that_holds_two_is_refused_at_its_place(tmp_path: Path) -> None:
    lines = ["G1X1"] * bundles.CHUNK + ["G1X2\nM3"]
    with pytest.raises(ProgramError, match="act as a command") as refused:
        write_job(tmp_path / "job.wire", SendJob("port", lines, "part.nc"))
    assert refused.value.place == Place("part.nc", len(lines), 5)


def test_what_cannot_be_written_leaves_the_file_before(tmp_path: Path) -> None:
    write_job(tmp_path / "job.wire", SendJob("port", LINES))
    with pytest.raises(ProgramError):
        write_job(tmp_path / "job.wire", SendJob("port", [*LINES, "\n"]))
    assert list(read_job(tmp_path / "job.wire").lines) == LINES and len(list(tmp_path.iterdir())) == 1


def test_the_same_job_gives_the_same_bytes_that_any_zip_program_reads(tmp_path: Path) -> None:
    for name in "ab":
        write_job(tmp_path / name, SendJob("port", LINES, "part.nc", NUMBERS))
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes() and is_bundle(tmp_path / "a")
    with zipfile.ZipFile(tmp_path / "a") as file:
        assert file.testzip() is None and file.namelist() == ["job.json", WIRE, LINE_MAP]
        assert json.loads(file.read("job.json"))["port"] == "port"
        assert file.read(WIRE).decode("ascii").splitlines() == LINES
        assert np.load(io.BytesIO(file.read(LINE_MAP))).tolist() == NUMBERS


def test_a_pipe_takes_a_bundle_too(tmp_path: Path) -> None:
    """What cannot be sought in is written with the sizes behind each member, and read all the same."""

    class Pipe(io.BytesIO):
        def seekable(self) -> bool:
            return False

        def seek(self, *_: Any) -> int:
            raise OSError("a pipe")

        def tell(self) -> int:
            raise OSError("a pipe")

    pipe = Pipe()
    write_bundle(pipe, {"job.json": head_bytes({"a": 1}), WIRE: line_bytes(LINES)})
    (tmp_path / "piped").write_bytes(pipe.getvalue())
    found = read_bundle(tmp_path / "piped")
    assert found.head == {"a": 1} and list(found.lines) == LINES and found.file_lines == ()


def test_a_file_that_is_changed_while_it_is_read_is_noticed(tmp_path: Path) -> None:
    path = tmp_path / "job.wire"
    write_job(path, SendJob("port", LINES))
    found = read_bundle(path)
    assert found.lines[0] == LINES[0]
    path.write_bytes(path.read_bytes().replace(b"X2000Y", b"X99Y"))
    with pytest.raises(JobError) as refused:
        found.lines[2 * BLOCK]
    assert refused.value.code == "file-changed"


GOOD = {"job.json": b'{"port": "x"}', WIRE: b"G21\nG0\n", LINE_MAP: array(np.array([1, 2], "<i4"))}
BAD: dict[str, dict[str, bytes | None]] = {
    "head that is no JSON": {"job.json": b"{"},
    "head that is a list": {"job.json": b"[]"},
    "head that is nested too deeply": {"job.json": b"[" * 100_000},
    "two heads": {"other.json": b"{}"},
    "no head": {"job.json": None},
    "line without an end": {WIRE: b"G21\nG0"},
    "lines too long": {WIRE: b"G" * (bundles.MOST_BLOCK_BYTES + 1) + b"\n"},
    "member of another kind": {"run.exe": b"MZ"},
    "member in a folder": {"../../a": b""},
    "array of floats": {LINE_MAP: array(np.array([1.0, 2.0]))},
    "array of objects": {LINE_MAP: array(np.array([{}, []], object))},
    "array of two dimensions": {LINE_MAP: array(np.ones((2, 1), "<i4"))},
    "array that is cut short": {LINE_MAP: array(np.array([1, 2], "<i4"))[:-4]},
    "array of a lying length": {LINE_MAP: array(np.array([1, 2], "<i4")).replace(b"(2,)", b"(9,)")},
    "array with code for its kind": {LINE_MAP: array(np.array([1, 2], "<i4")).replace(b"'<i4'", b"f(1) ")},
    "no array": {LINE_MAP: b"1 2"},
    "empty array": {LINE_MAP: b""},
    "too many members": {f"{number}.txt": b"" for number in range(9)},
}


@pytest.mark.parametrize("case", BAD)
def test_what_is_no_bundle_is_refused(case: str, tmp_path: Path) -> None:
    members = {name: data for name, data in {**GOOD, **BAD[case]}.items() if data is not None}
    with pytest.raises(ValueError):
        read_bundle(archive(tmp_path / "bad", members))


def test_what_was_compressed_anew_is_refused_unread(tmp_path: Path) -> None:
    """A zip bomb: 30 MB of lines in 30 kB."""
    bomb = archive(tmp_path / "bomb", {**GOOD, WIRE: b"G0\n" * 10_000_000}, compression=zipfile.ZIP_DEFLATED)
    tracemalloc.start()
    with pytest.raises(ValueError, match="compressed"):
        read_bundle(bomb)
    assert tracemalloc.get_traced_memory()[1] < 1_000_000
    tracemalloc.stop()


def test_a_huge_directory_is_refused_unread(tmp_path: Path) -> None:
    path = archive(tmp_path / "huge", {f"{number:0200}.txt": b"" for number in range(500)})
    with pytest.raises(ValueError, match="directory"):
        read_bundle(path)


def test_a_head_that_is_too_large_is_refused_unread(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bundles, "MOST_HEAD_BYTES", 10)
    with pytest.raises(ValueError, match="head is too large"):
        read_bundle(archive(tmp_path / "huge", GOOD))


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no pipes with names")
def test_a_pipe_and_a_folder_are_refused_at_once(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path, tmp_path / "pipe"):
        with pytest.raises(ValueError, match="not a file"):
            read_bundle(path)
        with pytest.raises(CNCStepperError):
            sendable(path)


def test_a_damaged_file_is_read_or_refused_by_name(tmp_path: Path) -> None:
    """Changed bytes, cut ends, pieces said twice: another error than ours never, nor much memory."""
    pick = random.Random(5)
    write_job(tmp_path / "good", SendJob("port", LINES[:40], "part.nc", NUMBERS[:40]))
    good, refused = (tmp_path / "good").read_bytes(), 0
    tracemalloc.start()
    for case in range(FUZZ):
        (tmp_path / "bad").write_bytes(damaged(good, pick))
        try:
            job = sendable(tmp_path / "bad")
            assert len(list(job.lines)) == len(job.lines)
        except CNCStepperError as error:
            assert error.code and error.advice and str(error).isprintable(), (case, error)
            refused += 1
    assert tracemalloc.get_traced_memory()[1] < 5_000_000
    tracemalloc.stop()
    assert refused > FUZZ / 4


def damaged(good: bytes, pick: random.Random) -> bytes:
    data = bytearray(good)
    for _ in range(pick.randint(1, 4)):
        at = pick.randrange(len(data)) if pick.random() < 0.5 else max(0, len(data) - 1 - pick.randrange(400))
        how = pick.randrange(4)
        if how == 0:
            data[at] = pick.randrange(256)
        elif how == 1:
            data[at : at + 4] = pick.choice([b"\xff\xff\xff\xff", b"\0\0\0\0", b"\xff\xff\xff\x7f"])
        elif how == 2:
            del data[at : at + pick.randrange(60)]
        else:
            data[at:at] = data[max(0, at - pick.randrange(200)) : at]
    return bytes(data)


def test_memory_does_not_grow_with_the_program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bundles, "CHUNK_BYTES", 20_000)

    def most_bytes(count: int) -> int:
        path = tmp_path / f"{count}.wire"
        write_job(path, SendJob("port", [LINES[0]] * count, file_lines=range(count)))
        tracemalloc.start()
        job = read_job(path)
        for _ in zip(job.lines, job.file_lines, strict=True):
            pass
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return most

    most_bytes(10)
    few, many = most_bytes(20 * BLOCK), most_bytes(60 * BLOCK)
    assert many < few + 40 * 64 + sys.getsizeof(LINES[0]) * BLOCK


def _certificate(folder: Path, **head: Any) -> Path:
    """Write a certificate of one line whose head is damaged, with the fingerprint of what it holds."""
    wire = {"sha256": digest_of_lines(["G1X1"]), "dialect": "grbl"}
    content = {"format": FORMAT, "version": VERSION, "wire": wire, "findings": [], "send": {"file": "a.nc"}}
    Certificate({**content, **head}, ["G1X1"]).write(folder / "a.zip")
    return folder / "a.zip"


@pytest.mark.parametrize(
    "head",
    [{"wire": {"sha256": 5}}]
    + [{"findings": findings} for findings in (5, [5], None, [{"severity": "error"}])],
)  # fmt: skip
def test_a_certificate_whose_head_is_damaged_is_refused(head: dict[str, Any], tmp_path: Path) -> None:
    with pytest.raises(JobError):
        sendable(_certificate(tmp_path, **head))


def test_the_lines_of_a_certificate_are_those_that_were_compared(tmp_path: Path) -> None:
    assert list(sendable(_certificate(tmp_path, send={"file": "a.nc", "lines": ["G0Z-99"]})).lines) == ["G1X1"]
