# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rule for every file that a command writes: none is an input, none is written twice, none is another's unasked.

A file is its identity on the disk (device and number), whatever its name: hard links, symbolic links and spellings of
one file are the same. An existing file is replaced without asking only where CNCStepper made it, and as what it is:

    program        a comment in its first lines says "made by CNCStepper", or "restart of ... at line ..."
    report         JSON whose "format" is "CNCStepper report"
    certificate    a zip whose proof.json, or in an old one JSON whose "format" is "CNCStepper certificate"
    picture        PNG, SVG, GIF, APNG, WebP or MP4 whose description names CNCStepper
    drawing        DXF or SVG whose first lines say "made by CNCStepper"
    placements     JSON list whose first object begins with "sheet" and "item"
    job            a job file whose first line is a comment that says so
    sheet          PDF or HTML whose creator or generator is CNCStepper
    mesh           STL whose header names CNCStepper
    signals        CSV that begins with one of our headers, or VCD of the module "motion"
    path           CSV that begins with t_s,x_mm,y_mm,z_mm, of a lathe t_s,x_mm,z_mm
    pulses         a recording that begins with "CNCStepper pulses"
    order table    CSV that begins with the columns of an order's rows or sheets
    order text     text whose first line says "made by CNCStepper"
    batch journal  JSON lines whose first has the "format" "CNCStepper batch journal"

Programs that keep the user's own text (edit, compact), tools, letters and bytes carry no mark of ours.
"""

from __future__ import annotations

import os
import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from CNCStepper.atomic_file import checked_target, followed, is_stream
from CNCStepper.errors import OutputError, Place, Text

MADE_BY = "made by CNCStepper"  # in comments
LOOKED_AT = 8192  # bytes at the begin and at the end of a file
MARKS = {
    "program": rb"(?m)^[^\n]*[(;][^\n]*made by CNCStepper|\A\(restart of [^\n]* at line \d+",
    "report": rb'\A\s*\{[^{}]*"format": "CNCStepper report"',
    "certificate": rb'(?s)\A(PK\x03\x04.{26}proof\.json.{0,64}|\s*)\{[^{}]*"format": "CNCStepper certificate"',
    "picture": rb"(?s)\A(\x89PNG\r\n|GIF8|RIFF|<\?xml|....ftyp).*CNCStepper",
    "drawing": rb"\A(999\r?\n|<\?xml[^\n]*\n[^\n]*\n<desc>)made by CNCStepper",
    "placements": rb'\A\[\s*(\{"sheet": \d+, "item": \d+, "x": |\]\s*\Z)',
    "job": rb"\A# [^\n]*made by CNCStepper",
    "sheet": rb"(?s)\A(%PDF|<!DOCTYPE html>).*made by CNCStepper",
    "mesh": rb"\ACNCStepper, binary STL",
    "signals": rb"\A(time_s,(x_steps|x,|0x)|\$timescale [^\n]*\n\$scope module motion)",
    "path": rb"\At_s,x_mm(,y_mm)?,z_mm\r?\n",
    "pulses": rb"\ACNCStepper pulses ",
    "order table": rb"\A(line,drawing,template,|sheet,parts,metres,)",
    "order text": rb"\A[^\n]*, made by CNCStepper\n",
    "batch journal": rb'\A\{"format": "CNCStepper batch journal"\}\n',
}


@dataclass(frozen=True)
class Output:
    """A file that a command is going to write. option: as it is spelled; kind: one of MARKS, "" where no mark fits."""

    path: Path
    option: str
    kind: str = ""


@dataclass(frozen=True)
class Input:
    """A file that a command reads. what: as a sentence names it, such as "the program" or "--job"."""

    path: Path
    what: str


def check_outputs(outputs: Sequence[Output], inputs: Iterable[Input], overwrite: bool = False) -> None:
    """Refuse outputs that would cost a file: an input, one another, or a foreign one unless `overwrite`.

    Raises OutputError that names the file and the option, OSError for what cannot be written. Devices and pipes are
    always written.
    """
    files = [output for output in outputs if not is_stream(output.path)]
    for output in files:
        followed(output.path)
    read = [each for each in inputs if not is_stream(each.path)]
    for number, output in enumerate(files):
        for each in read:
            if is_same_file(output.path, each.path):
                raise _refusal(
                    "output-is-input",
                    Text("{option} would write over {what}", option=output.option, what=each.what),
                    output,
                )
        for other in files[:number]:
            if is_same_file(output.path, other.path):
                what = Text("{option} and {other} would write the same file", option=output.option, other=other.option)
                raise _refusal("output-twice", what, output)
    for output in files:
        checked_target(output.path)
        if not overwrite and output.path.is_file() and not is_ours(output.path, output.kind):
            raise _refusal("output-exists", _foreign(output), output, "give another name, or --overwrite to replace it")


def _refusal(code: str, what: str, output: Output, advice: str = "give another name") -> OutputError:
    return OutputError(code, what, advice=advice, place=Place(str(output.path)))


def _foreign(output: Output) -> Text:
    """Return why a file that is there would be lost."""
    if output.kind:
        return Text("{option} would replace a file of another kind, or of somebody else's", option=output.option)
    return Text("{option} would replace a file that exists already", option=output.option)


def is_same_file(one: Path, other: Path) -> bool:
    """Return whether two paths are one file, also when it is not there yet.

    Files that are not there yet are taken for the same where their names differ in upper and lower case alone: many
    disks make no difference.
    """
    try:
        return os.path.samefile(one, other)
    except OSError:
        if one.exists() or other.exists():
            return False
    return _future_identity(one) == _future_identity(other)


def _future_identity(path: Path) -> tuple[int, int, tuple[str, ...]]:
    """Return the nearest folder that exists, by device and number, and the names from there on."""
    path, names = path.resolve(), list[str]()
    while not path.exists() and path != path.parent:
        names.append(unicodedata.normalize("NFC", path.name).casefold())
        path = path.parent
    found = path.stat()
    return found.st_dev, found.st_ino, tuple(names)


def is_ours(path: Path, kind: str) -> bool:
    """Return whether CNCStepper made a file, as one of MARKS; an empty file is nobody's and may be written."""
    size = path.stat().st_size
    if size == 0:
        return True
    if kind not in MARKS:
        return False
    with path.open("rb") as file:
        seen = file.read(LOOKED_AT)
        if size > LOOKED_AT:
            file.seek(max(LOOKED_AT, size - LOOKED_AT))
            seen += file.read(LOOKED_AT)
    return re.search(MARKS[kind], seen) is not None


def in_folder(folder: Path, names: str) -> Iterator[Path]:
    """Yield the files of a folder whose whole names match a regular expression."""
    if folder.is_dir():
        yield from (path for path in sorted(folder.iterdir()) if re.fullmatch(names, path.name))
