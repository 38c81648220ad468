# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the machine code of the kernels is kept, and whether all of it is there; loads no numba."""

from __future__ import annotations

import contextlib
import functools
import hashlib
import os
import platform
import shutil
import sys
import time
from collections.abc import Collection, Iterator
from pathlib import Path

import platformdirs

PACKAGE = Path(__file__).resolve().parent
# No kernel uses them.
ROOMS_ABOVE = {"cli", "control", "controllers", "drawing", "job", "recovery", "workbench", "workers"}
KEPT_CACHES = 16
CHECKOUTS = "checkouts"  # the folder in which their digests are noted
KEPT_CHECKOUTS = 64
VARIABLE = "NUMBA_CACHE_DIR"

postponed = False  # set before kernels are imported: numba is loaded only once they take longer than that would


def digest() -> str:
    """Return what names exactly these sources of the kernels, in whatever folder they lie.

    To read them all takes 50 ms, which a short verb does not have: each state of a checkout is noted in the cache.
    """
    noted = _user_cache() / CHECKOUTS / _state_of_checkout()
    try:
        return noted.read_text("ascii")
    except OSError:
        found = _digest_of_contents()
    with contextlib.suppress(OSError):  # a folder that cannot be written costs time alone
        noted.parent.mkdir(parents=True, exist_ok=True)
        _prune(noted.parent, KEPT_CHECKOUTS)
        draft = noted.with_suffix(f".{os.getpid()}")  # other processes see all of it or nothing
        draft.write_text(found, "ascii")
        draft.replace(noted)
    return found


def _state_of_checkout() -> str:
    found = hashlib.sha256()
    for path, size, mtime_ns in sorted(_sources(str(PACKAGE), ROOMS_ABOVE)):
        found.update(f"{path}|{size}|{mtime_ns}\n".encode())
    return found.hexdigest()[:16]


def _digest_of_contents() -> str:
    found = hashlib.sha256()
    for path, _, _ in sorted(_sources(str(PACKAGE), ROOMS_ABOVE)):
        source = Path(path)
        found.update(f"{source.relative_to(PACKAGE).as_posix()}|".encode() + source.read_bytes())
    return found.hexdigest()[:16]


def _user_cache() -> Path:
    return platformdirs.user_cache_path("cncstepper", appauthor=False)


def subfolder(file: str) -> str:
    """Return the folder, within that of the machine code, for a module of the package; "" for any other file."""
    package = os.path.dirname(__file__)  # as its modules are named, through a link too
    folder = os.path.dirname(file)
    inside = folder == package or folder.startswith(package + os.sep)
    return f"kernels{folder.removeprefix(package)}".replace(os.sep, "-") if inside else ""


def _sources(folder: str, left_out: Collection[str] = ()) -> Iterator[tuple[str, int, int]]:
    """Yield path, bytes and time in ns of each module below a folder; pathlib would take a third of a short verb."""
    with os.scandir(folder) as entries:
        for entry in entries:
            if entry.is_dir():
                if entry.name not in left_out:
                    yield from _sources(entry.path)
            elif entry.name.endswith(".py"):
                state = entry.stat()
                yield entry.path, state.st_size, state.st_mtime_ns


def cache_folder(root: Path) -> Path:
    """Return the folder below `root` for the machine code of exactly these sources; older ones are pruned.

    numba looks only at the file of the kernel that is called: code of a changed kernel that it calls would
    live on in a cache shared by two versions.
    """
    folder = root / digest()
    if not folder.is_dir():
        _prune(root, KEPT_CACHES)
        folder.mkdir(parents=True, exist_ok=True)
    return folder


@functools.cache
def folder() -> Path:
    """Return the folder that this process and those that it starts use: the user's choice, or one of our own."""
    if VARIABLE not in os.environ:
        os.environ[VARIABLE] = str(cache_folder(_user_cache()))
    return Path(os.environ[VARIABLE])


@functools.cache
def stamp() -> Path:
    """Return the file that `workers/kernel_warm_up.py` leaves: for these sources, this Python, numba and processor.

    Raises importlib.metadata.PackageNotFoundError without numba.
    """
    import importlib.metadata  # takes 30 ms, which a short command does not have

    version = f"{sys.version_info[0]}.{sys.version_info[1]}"
    numba = importlib.metadata.version("numba")
    return folder() / f"warm-{digest()}-py{version}-numba{numba}-{platform.machine()}"


def has_grown(within_s: float) -> bool:
    """Return whether a kernel was compiled within the last seconds, by this process or by another one."""
    if VARIABLE not in os.environ or not folder().is_dir():  # numba is not loaded, or has kept nothing yet
        return False
    newest_ns = max((path.stat().st_mtime_ns for path in folder().iterdir()), default=0)
    return time.time_ns() - newest_ns < within_s * 1e9


def _prune(root: Path, kept: int) -> None:
    """Delete all but the newest entries, so that one more is `kept`; another process may be doing the same."""
    entries = [path for path in root.glob("*") if path.name != CHECKOUTS]
    for path in sorted(entries, key=_changed_ns)[: -kept + 1]:
        shutil.rmtree(path, ignore_errors=True)
        path.unlink(missing_ok=True)


def _changed_ns(path: Path) -> int:
    try:
        return path.stat().st_mtime_ns
    except FileNotFoundError:
        return 0
