# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of a program: messages come back from a file as they were, however many and in any order asked for."""

from __future__ import annotations

import io
import random
import zipfile
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.control.program.bundle import BLOCK, array_bytes, line_bytes, read_bundle, write_bundle
from CNCStepper.control.program.certificate import FORMAT, VERSION, Certificate, digest_of_lines
from CNCStepper.control.program.program_columns import (
    MESSAGE_MAP,
    MESSAGES,
    ColumnWriter,
    Messages,
    message_bytes,
    message_members,
    messages_of,
)
from CNCStepper.control.program.send_job import SendJob, read_job, write_job
from CNCStepper.errors import JobError, Place, ProgramError

LINES = [f"G1X{number}Y.5" for number in range(3 * BLOCK + 7)]
NUMBERS = [3 * number + 2 for number in range(len(LINES))]
TEXTS = ("turn it over", "two\nlines", "aperte o parafuso nº 3 ç", '\ud800 \v\t"quoted"\\', "", "x" * 4000)


def messages(seed: int, count: int, most: int) -> dict[int, str]:
    draw = random.Random(seed)
    return {index: f"{draw.choice(TEXTS)} {index}" for index in sorted(draw.sample(range(most), count))}


@pytest.mark.parametrize(("seed", "count"), [(1, 1), (2, 5), (3, BLOCK), (4, BLOCK + 1), (5, 3 * BLOCK + 3)])
def test_messages_of_a_job_come_back(tmp_path: Path, seed: int, count: int) -> None:
    lines, told = ["M0"] * (5 * BLOCK), messages(seed, count, 5 * BLOCK)
    write_job(tmp_path / "job.wire", SendJob("port", lines, messages=told))
    read = read_job(tmp_path / "job.wire").messages
    assert read == told and list(read) == list(told) and len(read) == count
    draw = random.Random(seed)
    rising, any_order = range(-1, len(lines) + 1), [draw.randrange(-3, len(lines) + 3) for _ in range(3000)]
    for order in (rising, any_order):
        assert [read.get(index) for index in order] == [told.get(index) for index in order]
    write_job(tmp_path / "again.wire", SendJob("port", lines, messages=read))
    assert (tmp_path / "again.wire").read_bytes() == (tmp_path / "job.wire").read_bytes()


def test_a_job_without_messages_has_no_columns_of_them(tmp_path: Path) -> None:
    write_job(tmp_path / "job.wire", SendJob("port", LINES))
    with zipfile.ZipFile(tmp_path / "job.wire") as file:
        assert file.namelist() == ["job.json", "wire.txt", "line_map.npy"]
    assert read_job(tmp_path / "job.wire").messages == {}


def test_any_zip_program_reads_them(tmp_path: Path) -> None:
    write_job(tmp_path / "job.wire", SendJob("port", LINES, messages={7: "turn\nit", 2: "lóok"}))
    with zipfile.ZipFile(tmp_path / "job.wire") as file:
        assert file.read(MESSAGES) == b'"l\\u00f3ok"\n"turn\\nit"\n'
        assert np.load(io.BytesIO(file.read(MESSAGE_MAP))).tolist() == [2, 7]


@pytest.mark.parametrize("indices", [[], [1], [1, 1], [2, 1], [-1, 1], [1, 2, 3]])
def test_a_map_that_does_not_fit_the_messages_is_refused(tmp_path: Path, indices: list[int]) -> None:
    members = {"job.json": [b'{"port": ""}'], MESSAGES: [b'"a"\n"b"\n'], MESSAGE_MAP: array_bytes(indices)}
    with (tmp_path / "job.wire").open("wb") as file:
        write_bundle(file, members)
    with pytest.raises(JobError, match="do not fit"):
        read_job(tmp_path / "job.wire")


def test_texts_without_a_map_are_refused(tmp_path: Path) -> None:
    with (tmp_path / "job.wire").open("wb") as file:
        write_bundle(file, {"job.json": [b'{"port": ""}'], MESSAGES: [b'"a"\n']})
    with pytest.raises(JobError, match="do not fit"):
        read_job(tmp_path / "job.wire")


@pytest.mark.parametrize("column", ["turn it", "[" * 100_000, '"turn'])
def test_a_text_that_was_damaged_is_shown_as_it_stands(column: str) -> None:
    assert Messages([4], [column])[4] == column


def certificate(told: dict[int, str]) -> Certificate:
    content = {"format": FORMAT, "version": VERSION, "findings": [], "send": {}}
    return Certificate(content | {"wire": {"sha256": digest_of_lines(LINES)}}, LINES, NUMBERS, told)


def test_a_changed_message_of_a_certificate_is_refused(tmp_path: Path) -> None:
    file, told = tmp_path / "certificate.zip", messages(7, 50, len(LINES))
    certificate(told).write(file)
    read = Certificate.read(file)
    assert read.messages == told and read.send_job().messages == told and read.sha256 == certificate(told).sha256
    for changed in ({}, told | {max(told): "another"}, {index + 1: text for index, text in told.items()}):
        bundle = read_bundle(file)
        columns = {name: bundle.columns[name] for name in bundle.columns if name not in (MESSAGES, MESSAGE_MAP)}
        other = {index: changed[index] for index in sorted(changed)}
        with file.with_suffix(".changed").open("wb") as out:
            write_bundle(
                out,
                {
                    "proof.json": [file_head(file)],
                    "wire.txt": line_bytes(columns["wire.txt"]),
                    "line_map.npy": array_bytes(columns["line_map.npy"]),
                    **message_members(other),
                },
            )
        with pytest.raises(JobError) as refused:
            Certificate.read(file.with_suffix(".changed"))
        assert refused.value.code == "certificate-changed"


def file_head(file: Path) -> bytes:
    with zipfile.ZipFile(file) as archive:
        return archive.read("proof.json")


def test_messages_in_the_head_of_an_earlier_file_are_read(tmp_path: Path) -> None:
    plain = certificate({})
    Certificate({**plain.content, "send": {"messages": {"2": "look"}}}, LINES, NUMBERS).write(tmp_path / "old.zip")
    assert Certificate.read(tmp_path / "old.zip").send_job().messages == {2: "look"}


def test_columns_of_a_program_that_is_still_read(tmp_path: Path) -> None:
    told = messages(3, 2000, len(LINES))
    with ColumnWriter(tmp_path, "part.nc") as writer:
        for first in range(0, len(LINES), 1000):
            own = {index - first: text for index, text in told.items() if first <= index < first + 1000}
            writer.add(np.array(NUMBERS[first : first + 1000]), LINES[first : first + 1000], own)
    lines, numbers, found = writer.columns()
    assert list(lines) == LINES and list(numbers) == NUMBERS and len(numbers) == len(LINES) and found == told
    assert b"".join(line_bytes(lines)) == b"".join(line_bytes(LINES))
    assert b"".join(array_bytes(numbers)) == b"".join(array_bytes(NUMBERS))
    assert b"".join(message_bytes(found)) == b"".join(message_bytes(told))


def test_a_program_without_messages_has_no_members_of_them(tmp_path: Path) -> None:
    with ColumnWriter(tmp_path, "part.nc") as writer:
        writer.add(np.array([7]), ["G1"], {})
    assert message_members(writer.columns()[2]) == {} and messages_of({}) == {}


def test_a_line_that_holds_two_is_refused_while_the_program_is_read(tmp_path: Path) -> None:
    with pytest.raises(ProgramError) as refused, ColumnWriter(tmp_path, "part.nc") as writer:
        writer.add(np.array([7]), ["G1\nM3"], {})
    assert refused.value.place == Place("part.nc", 7, 3)
