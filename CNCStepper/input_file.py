# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one way to read a file that a person names: a regular file of bounded size, or a refusal in words.

    path ──► stat: folder, FIFO, device, socket? ──► open without waiting ──► fstat: still that? ──► read, bounded

A FIFO without a writer would block for ever, a device such as /dev/zero never ends, and a folder gives another error
on each system. A shell's `-`, `/dev/stdin` and `/dev/fd/N` are pipes: only a caller that asks for them gets them.
"""

from __future__ import annotations

import io
import os
import re
import stat
from collections.abc import Iterator
from pathlib import Path

from CNCStepper.errors import CNCStepperError, JobError, Place, Text
from CNCStepper.safe_text import printable

MOST_TEXT_BYTES = 64_000_000  # of a job, a profile, a tool file, a point list: far more than a person or a CAD writes
CHUNK_BYTES = 1 << 20
MB = 1e6
STREAM_NAME = re.compile(r"-|/dev/stdin|/(?:dev|proc/self)/fd/(\d{1,6})")
FLAGS = os.O_RDONLY | getattr(os, "O_BINARY", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0)
KINDS = (
    (stat.S_ISDIR, "a folder"),
    (stat.S_ISFIFO, "a pipe (FIFO)"),
    (stat.S_ISCHR, "a device"),
    (stat.S_ISBLK, "a device"),
    (stat.S_ISSOCK, "a socket"),
)


class Unchanged:
    """Notices when a file that is read more than once is written, or another takes its place, meanwhile."""

    def __init__(self, path: Path):
        self._path = path
        self._stamp = self._now()

    def check(self) -> None:
        """Raise JobError where the file is not the one that it was."""
        if self._now() != self._stamp:
            raise JobError(
                "file-changed",
                "the file was changed while it was read",
                advice="wait until the program that writes it is done, then begin again",
                place=Place(str(self._path)),
            )

    def _now(self) -> tuple[int, int, int] | None:
        try:
            found = self._path.stat()
        except OSError:
            return None
        return found.st_size, found.st_mtime_ns, found.st_ino


def read_input(
    path: str | Path,
    most_bytes: int = MOST_TEXT_BYTES,
    *,
    streams: bool = False,
    refusal: type[CNCStepperError] = JobError,
) -> bytes:
    """Return the bytes of a regular file of at most `most_bytes`; links are followed.

    streams: whether "-", "/dev/stdin" and "/dev/fd/N" may name a pipe, which is then read to its end. Raises `refusal`
    with the code input-missing, input-kind, input-large or input-unreadable, which names the file.
    """
    return b"".join(input_chunks(path, most_bytes, streams=streams, refusal=refusal))


def input_chunks(
    path: str | Path,
    most_bytes: int = MOST_TEXT_BYTES,
    *,
    streams: bool = False,
    refusal: type[CNCStepperError] = JobError,
) -> Iterator[bytes]:
    """Yield the bytes that `read_input` returns in pieces of at most CHUNK_BYTES; the file is closed after the last."""
    name = str(path)
    try:
        with open(_opened(name, streams, refusal), "rb", buffering=0) as file:
            if (size_bytes := os.fstat(file.fileno()).st_size) > most_bytes:  # 0 for a stream
                raise _too_large(name, size_bytes, most_bytes, refusal)
            yield from _bounded(file, name, most_bytes, refusal)
    except (OSError, ValueError) as error:  # ValueError: a name with a zero byte
        if isinstance(error, CNCStepperError):
            raise
        raise _unreadable(name, error, refusal) from error


def input_kind(path: str | Path) -> str:
    """Return what a path names in words, "a folder" or "a device", and "" for a regular file; raises OSError."""
    return _kind(os.stat(path).st_mode)


def is_there(path: Path) -> bool:
    """Return whether a path names anything; a name that no file system takes names nothing."""
    try:
        return path.exists()
    except (OSError, ValueError):
        return False


def _kind(mode: int) -> str:
    if stat.S_ISREG(mode):
        return ""
    return next((words for is_kind, words in KINDS if is_kind(mode)), "no regular file")


def _opened(name: str, streams: bool, refusal: type[CNCStepperError]) -> int:
    """Return a handle of the file; raises for what is none, also when the name stands for something else by now."""
    stream = STREAM_NAME.fullmatch(name) if streams else None
    if not stream and (kind := input_kind(name)):
        raise _wrong_kind(name, kind, refusal)
    handle = os.dup(int(stream[1] or 0)) if stream else os.open(name, FLAGS)
    kind = _kind(os.fstat(handle).st_mode)
    if kind and (not stream or kind == "a folder"):
        os.close(handle)
        raise _wrong_kind(name, kind, refusal)
    return handle


def _bounded(file: io.FileIO, name: str, most_bytes: int, refusal: type[CNCStepperError]) -> Iterator[bytes]:
    """Yield all that the file gives; raises for more than `most_bytes`, also of a file that grows meanwhile."""
    total = 0
    while piece := file.read(CHUNK_BYTES):
        total += len(piece)
        if total > most_bytes:
            raise _too_large(name, total, most_bytes, refusal)
        yield piece


def _wrong_kind(name: str, kind: str, refusal: type[CNCStepperError]) -> CNCStepperError:
    advice = "give the path of a file"
    return refusal("input-kind", Text("this is {kind}, not a file", kind=kind), advice=advice, place=Place(name))


def _too_large(name: str, size_bytes: int, most_bytes: int, refusal: type[CNCStepperError]) -> CNCStepperError:
    return refusal(
        "input-large",
        "the file is too large",
        value=f"{size_bytes / MB:.3g} MB",
        limit=f"{most_bytes / MB:.3g} MB",
        advice="give a smaller file",
        place=Place(name),
    )


def _unreadable(name: str, error: Exception, refusal: type[CNCStepperError]) -> CNCStepperError:
    if isinstance(error, FileNotFoundError):
        what, advice = "there is no such file", "correct the path"
        return refusal("input-missing", what, advice=advice, place=Place(name))
    why = printable(getattr(error, "strerror", None) or str(error))
    what, advice = Text("the file cannot be read: {why}", why=why), "correct the path or the file's permissions"
    return refusal("input-unreadable", what, advice=advice, place=Place(name))
