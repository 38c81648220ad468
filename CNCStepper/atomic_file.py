# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are written whole or not at all, and symbolic links that are followed only where nobody can plant one."""

from __future__ import annotations

import errno
import os
import secrets
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

WRITABLE = 0o222  # bits of a file's mode
MOST_LINKS = 40  # as Linux follows
_FLAGS = os.O_WRONLY | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)


def write_whole(path: Path, data: bytes) -> None:
    """Write a file whole or not at all: a full disk does not cost the old one.

    A symbolic link stays one: the file that it leads to is written. Raises OSError that names `path`, for a read-only
    file too, and for another user's link in a folder that everybody may write to.
    """
    with whole_file(path) as file:
        file.write(data)


@contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """Give a file to write into piece by piece, which takes the name `path` when the block ends without an error.

    Until then it has a random name in the same folder; after an error nothing is left of it. Devices and pipes are
    written directly. Raises as `write_whole` does.
    """
    if is_stream(path):
        with open(path, "wb") as stream:
            yield stream
        return
    target = checked_target(path)
    draft = target.with_name(f".{secrets.token_hex(8)}.part")
    try:
        mode = 0o600 if target.exists() else 0o666  # nobody reads what is going to be private
        with open(os.open(draft, _FLAGS | os.O_EXCL, mode), "wb") as file:
            yield file
            file.flush()
            _take_mode(file.fileno(), target)
            os.fsync(file.fileno())
        os.replace(draft, target)
    except BaseException as error:  # an interrupt too leaves nothing behind
        with suppress(OSError):
            draft.unlink()
        if isinstance(error, OSError) and error.errno and error.filename in (None, str(draft)):
            raise OSError(error.errno, error.strerror, str(path)) from error
        raise
    sync_folder(target.parent)


def open_live(path: Path) -> BinaryIO:
    """Return an empty file of that name that others read while it grows: it cannot be written whole.

    Raises OSError as `write_whole` does.
    """
    if is_stream(path):
        return open(path, "wb")
    return open(os.open(followed(path), _FLAGS | os.O_TRUNC, 0o666), "wb")


def is_stream(path: Path) -> bool:
    """Return whether a path is a device, a pipe or one of the process's own streams: it holds nothing to be lost."""
    if os.name == "nt":
        return path.name.upper() in ("NUL", "CON")
    if str(path).startswith(("/dev/std", "/dev/fd/", "/proc/self/fd/")):
        return True
    try:
        mode = path.stat().st_mode
    except OSError:
        return False
    return stat.S_ISCHR(mode) or stat.S_ISFIFO(mode) or stat.S_ISSOCK(mode)


def checked_target(path: Path) -> Path:
    """Return the file that a path leads to, which may be written anew; raises OSError as `write_whole` does."""
    target = followed(path)
    _require_writable(target, path)
    return target


def followed(path: Path) -> Path:
    """Return the file to which a path leads over its symbolic links.

    Raises OSError for a link that another user made in a folder that everybody may write to, such as /tmp, and for a
    circle of links.
    """
    _check_links(Path.cwd() / path, path, 0)
    return path.resolve()


def _check_links(path: Path, named: Path, depth: int) -> None:
    if depth > MOST_LINKS:
        raise OSError(errno.ELOOP, "its symbolic links form a circle", str(named))
    for part in (*reversed(path.parents), path):
        if part.is_symlink():
            if not _may_follow(part):
                what = "a symbolic link of another user in a folder that everybody may write to is not followed"
                raise PermissionError(errno.EACCES, what, str(named))
            _check_links(part.parent / os.readlink(part), named, depth + 1)


def _may_follow(link: Path) -> bool:
    """Return whether a link is ours, the folder's owner's, or where nobody else can make one; as Linux decides."""
    if os.name != "posix":
        return True
    folder = link.parent.stat()
    return not folder.st_mode & stat.S_IWOTH or link.lstat().st_uid in (os.geteuid(), folder.st_uid)


def _require_writable(target: Path, path: Path) -> None:
    """Refuse what no file can take the place of; raises OSError."""
    try:
        mode = target.stat().st_mode
    except FileNotFoundError:
        return
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(errno.EISDIR, "it is a folder", str(path))
    if not stat.S_ISREG(mode):
        raise PermissionError(errno.EACCES, "it is a device", str(path))
    if not mode & WRITABLE:
        raise PermissionError(errno.EACCES, "the file is read-only", str(path))


def _take_mode(descriptor: int, target: Path) -> None:
    """Give a new file the mode and the owner of the one whose place it takes, as far as user and file system allow."""
    if os.name != "posix":
        return
    with suppress(FileNotFoundError):
        old = target.stat()
        with suppress(OSError):  # only root can give a file away; some file systems know no owners
            os.fchown(descriptor, old.st_uid, old.st_gid)
        with suppress(OSError):  # nor modes: the file stays its owner's only
            os.fchmod(descriptor, stat.S_IMODE(old.st_mode))


def sync_folder(folder: Path) -> None:
    """Put the names in a folder on the disk too, where the system lets a folder be opened."""
    if os.name != "posix":
        return
    with suppress(OSError):  # the file itself is on the disk; a network folder may refuse
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
