# SPDX-License-Identifier: LGPL-2.1-or-later
"""The journal of an order: each finished task, by the digest of all that it was made of; a killed run goes on from it.

    {"format": "CNCStepper batch journal"}
    {"key": "5e1f…", "result": {...}, "files": {"job-1-1.nc": "9b0c…"}}      a line each, on the disk before the next

A task is done when its key is here and its files have the bytes that are noted. A last line that is torn is left out.
The file is locked by the process that writes it: two orders at once would mix their programs in one folder.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Any

from CNCStepper.atomic_file import checked_target, write_whole
from CNCStepper.control.processes.file_lock import take_lock
from CNCStepper.errors import JobError, Place
from CNCStepper.job.request_digest import digest_of

FORMAT = {"format": "CNCStepper batch journal"}
JOURNAL_NAME = "journal.jsonl"


def task_key(task: Mapping[str, Any]) -> str:
    """Return what names a task: the digest of its values and of the bytes of its files."""
    files = {name: sha256(data) for name, data in task["files"].items()}
    return digest_of({**task, "files": files})


def sha256(data: bytes) -> str:
    """Return the digest of a file's bytes."""
    return hashlib.sha256(data).hexdigest()


class TaskJournal:
    """The finished tasks of an order in its folder; one process writes it."""

    def __init__(self, folder: Path):
        self._folder, self._path = folder, folder / JOURNAL_NAME
        self._entries: dict[str, dict[str, Any]] = {}
        self._file: Any = None

    def __enter__(self) -> TaskJournal:
        self._file = checked_target(self._path).open("a+b")
        self._lock()
        self._file.seek(0)
        content = self._file.read()
        self._entries = _entries(content)
        if not content.endswith(b"\n"):
            self._file.write(b"\n" if content else _line(FORMAT))
        return self

    def _lock(self) -> None:
        """Keep other processes out as long as this one lives; raises JobError where one is in."""
        try:
            take_lock(self._file)
        except (BlockingIOError, PermissionError) as error:
            self._file.close()
            what = "another process writes an order into this folder"
            advice = "wait until it is done, or name another folder"
            raise JobError("batch-running", what, advice=advice, place=Place(str(self._folder))) from error

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._file.close()

    def found(self, key: str) -> dict[str, Any] | None:
        """Return the result of a finished task whose files are as they were; None where it has to be done."""
        entry = self._entries.get(key)
        if entry is None or any(_sha256_of(self._folder / name) != told for name, told in entry["files"].items()):
            return None
        return dict(entry["result"])

    def note(self, key: str, result: Mapping[str, Any]) -> dict[str, Any]:
        """Write the files of a result, then its line; return the result without the files' bytes."""
        files: Mapping[str, bytes] = result.get("files", {})
        for name, data in files.items():
            write_whole(self._folder / name, data)
        told = {name: value for name, value in result.items() if name != "files"}
        entry = {"key": key, "result": told, "files": {name: sha256(data) for name, data in files.items()}}
        self._entries[key] = entry
        self._file.write(_line(entry))
        self._file.flush()
        os.fsync(self._file.fileno())
        return told

    def drop_others(self, keys: Iterable[str]) -> None:
        """Delete the files of tasks of an earlier order, and forget them; a file that was changed since stays."""
        kept = set(keys)
        needed = {name for key in kept & set(self._entries) for name in self._entries[key]["files"]}
        for key in set(self._entries) - kept:
            entry = self._entries.pop(key)
            for name, told in entry["files"].items():
                if name not in needed and _sha256_of(self._folder / name) == told:
                    (self._folder / name).unlink()


def _line(entry: Mapping[str, Any]) -> bytes:
    return json.dumps(entry).encode("ascii") + b"\n"


def _entries(content: bytes) -> dict[str, dict[str, Any]]:
    """Return the entries of a journal by their keys; of a line that is torn or says something else none."""
    found: dict[str, dict[str, Any]] = {}
    for line in content.splitlines():
        with suppress(ValueError):
            entry = json.loads(line)
            if _is_entry(entry):
                found[entry["key"]] = entry
    return found


def _is_entry(entry: Any) -> bool:
    """Return whether a line is of this format, and names files of the folder alone."""
    if not isinstance(entry, dict) or not isinstance(entry.get("key"), str):
        return False
    files = entry.get("files")
    return isinstance(entry.get("result"), dict) and isinstance(files, dict) and all(Path(n).name == n for n in files)


def _sha256_of(path: Path) -> str:
    try:
        return sha256(path.read_bytes())
    except OSError:
        return ""
