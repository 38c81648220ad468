# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files are written whole or not at all, under a random name first, and a planted link is not followed."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from CNCStepper import atomic_file as module
from CNCStepper.atomic_file import is_stream, open_live, whole_file, write_whole

ROOT = Path(__file__).parents[3]
posix = pytest.mark.skipif(os.name != "posix", reason="rights and links of POSIX")


def test_a_file_is_written_and_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / ("peça nº 1" + "x" * 200 + ".nc")  # the draft's name must not be longer than the file's
    write_whole(path, b"new")
    assert path.read_bytes() == b"new" and os.listdir(tmp_path) == [path.name]


def test_a_file_keeps_its_rights(tmp_path: Path) -> None:
    path = tmp_path / "peça.nc"
    path.write_bytes(b"old")
    path.chmod(0o640)
    with whole_file(path) as file:
        drafts = [draft.stat().st_mode & 0o077 for draft in tmp_path.iterdir() if draft != path]
        file.write(b"new")
    assert path.read_bytes() == b"new" and drafts == ([0] if os.name == "posix" else drafts)
    assert sys.platform == "win32" or path.stat().st_mode & 0o777 == 0o640


@posix
@pytest.mark.parametrize("fails", ["fchmod", "fchown"])
@pytest.mark.parametrize("number", [errno.EPERM, errno.EINVAL, errno.EOPNOTSUPP])
def test_a_file_system_without_modes_and_owners_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fails: str, number: int
) -> None:
    path = tmp_path / "peça.nc"
    path.write_bytes(b"old")

    def refuse(*_: int) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(os, fails, refuse)
    write_whole(path, b"new")
    assert path.read_bytes() == b"new"


@posix
def test_a_new_file_has_the_rights_that_the_user_wants(tmp_path: Path) -> None:
    (tmp_path / "plain").touch()
    write_whole(tmp_path / "ours", b"")
    assert (tmp_path / "ours").stat().st_mode == (tmp_path / "plain").stat().st_mode


@posix
@pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="only root can give files away")
def test_root_leaves_a_file_its_owner(tmp_path: Path) -> None:
    path = tmp_path / "a.nc"
    path.touch()
    os.chown(path, 1234, 1235)
    write_whole(path, b"new")
    assert (path.stat().st_uid, path.stat().st_gid) == (1234, 1235)


@pytest.mark.parametrize("old", [None, b"old"])
@pytest.mark.parametrize("fails", ["fsync", "replace", "open"])
def test_what_fails_leaves_all_as_it_was_and_names_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fails: str, old: bytes | None
) -> None:
    path = tmp_path / "a.nc"
    if old is not None:
        path.write_bytes(old)

    def full(*_: object, **__: object) -> int:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(module.os, fails, full)
    with pytest.raises(OSError, match="No space") as caught:
        write_whole(path, b"new")
    monkeypatch.undo()
    assert caught.value.filename == str(path)
    assert os.listdir(tmp_path) == ([] if old is None else ["a.nc"])
    assert old is None or path.read_bytes() == old


LIMITED = """
import resource, signal, sys
from pathlib import Path
from CNCStepper.atomic_file import whole_file
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))
try:
    with whole_file(Path(sys.argv[1])) as file:
        for _ in range(100):
            file.write(bytes(10_000))
except OSError as error:
    sys.exit(f"{error.filename}: {error.strerror}")
"""


@posix
def test_a_file_that_the_system_lets_grow_no_further_is_not_there_by_half(tmp_path: Path) -> None:
    path = tmp_path / "grande.nc"
    path.write_bytes(b"old")
    done = subprocess.run([sys.executable, "-c", LIMITED, str(path)], capture_output=True, text=True, cwd=ROOT)
    assert done.stderr == f"{path}: File too large\n"
    assert os.listdir(tmp_path) == ["grande.nc"] and path.read_bytes() == b"old"


def test_pieces_appear_only_when_all_are_there(tmp_path: Path) -> None:
    path = tmp_path / "steps.csv"
    with whole_file(path) as file:
        file.write(b"a")
        assert not path.exists()
        file.write(b"b")
    assert path.read_bytes() == b"ab"
    with pytest.raises(KeyboardInterrupt), whole_file(path) as file:
        file.write(b"c")
        raise KeyboardInterrupt
    assert path.read_bytes() == b"ab" and os.listdir(tmp_path) == ["steps.csv"]


def test_an_error_of_another_file_keeps_its_name(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError) as caught, whole_file(tmp_path / "out"):
        (tmp_path / "missing").read_bytes()
    assert caught.value.filename == str(tmp_path / "missing") and not os.listdir(tmp_path)


def test_a_planted_draft_is_not_written_through(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    victim = tmp_path / "victim"
    victim.write_bytes(b"mine")
    monkeypatch.setattr(module.secrets, "token_hex", lambda count: "known")
    (tmp_path / ".known.part").symlink_to(victim)
    with pytest.raises(FileExistsError) as caught:
        write_whole(tmp_path / "a.nc", b"theirs")
    assert victim.read_bytes() == b"mine" and caught.value.filename == str(tmp_path / "a.nc")


def test_drafts_have_no_name_that_can_be_known(tmp_path: Path) -> None:
    names = set()
    for _ in range(3):
        with whole_file(tmp_path / "a.nc"):
            names |= set(os.listdir(tmp_path)) - {"a.nc"}
    assert len(names) == 3


def test_a_link_of_ours_stays_one(tmp_path: Path) -> None:
    (tmp_path / "real.nc").write_bytes(b"old")
    (tmp_path / "link.nc").symlink_to("real.nc")
    write_whole(tmp_path / "link.nc", b"new")
    assert (tmp_path / "link.nc").is_symlink() and (tmp_path / "real.nc").read_bytes() == b"new"


@pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="only root can make another user's link")
@pytest.mark.parametrize("name", ["link.nc", "folder/a.nc"])
@pytest.mark.parametrize("write", [write_whole, lambda path, data: open_live(path)])
def test_another_users_link_in_a_shared_folder_is_not_followed(tmp_path: Path, name: str, write) -> None:
    shared, mine = tmp_path / "shared", tmp_path / "mine"
    shared.mkdir()
    mine.mkdir()
    shared.chmod(0o1777)
    (mine / "a.nc").write_bytes(b"mine")
    for link, target in (("link.nc", mine / "a.nc"), ("folder", mine)):
        (shared / link).symlink_to(target)
        os.lchown(shared / link, 1234, 1234)
    with pytest.raises(PermissionError, match="another user") as caught:
        write(shared / name, b"theirs")
    assert (mine / "a.nc").read_bytes() == b"mine" and caught.value.filename == str(shared / name)


def test_a_circle_of_links_ends_in_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    with pytest.raises(OSError, match="circle"):
        write_whole(tmp_path / "a", b"")


def test_a_read_only_file_and_a_folder_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.nc"
    path.write_bytes(b"old")
    path.chmod(0o444)
    with pytest.raises(PermissionError, match="read-only"):
        write_whole(path, b"new")
    with pytest.raises(IsADirectoryError):
        write_whole(tmp_path, b"new")
    assert path.read_bytes() == b"old"


@posix
def test_devices_and_pipes_are_written_directly(tmp_path: Path) -> None:
    write_whole(Path(os.devnull), b"gone")
    assert is_stream(Path(os.devnull))
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    write_whole(pipe, b"through")
    assert os.read(reader, 100) == b"through" and is_stream(pipe)
    os.close(reader)


@posix
def test_standard_output_is_written_wherever_it_leads(tmp_path: Path) -> None:
    code = "from pathlib import Path; from CNCStepper.atomic_file import *; write_whole(Path('/dev/stdout'), b'text')"
    with (tmp_path / "out").open("wb") as out:
        subprocess.run([sys.executable, "-c", code], stdout=out, cwd=ROOT, check=True)
    assert (tmp_path / "out").read_bytes() == b"text" and os.listdir(tmp_path) == ["out"]
