# SPDX-License-Identifier: LGPL-2.1-or-later
"""`make installer` asks pip for the pinned wheels of both systems, and writes one zip for each Python or none."""

from __future__ import annotations

import subprocess
import zipfile
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest

from CNCStepper import __version__, dependencies
from helpers.tools import load

STATUS = {"3.9": 1}  # of pip for a Python that has no wheels


@pytest.fixture
def asked() -> list[list[str]]:
    """What pip is called with."""
    return []


@pytest.fixture
def installer(tmp_path: Path, asked: list[list[str]], monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The tool with a pip that writes a wheel named for the system in place of asking the network."""
    tool = load("installer")

    def run(command: list[str]) -> SimpleNamespace:
        asked.append(command)
        options = dict(word.removeprefix("--").split("=", 1) for word in command if "=" in word)
        (Path(options["dest"]) / f"numpy-1-{options['platform']}.whl").write_bytes(b"wheel")
        return SimpleNamespace(returncode=STATUS.get(options["python-version"], 0))

    monkeypatch.setattr(subprocess, "run", run)
    monkeypatch.setattr(tool, "ROOT", tmp_path)
    monkeypatch.setattr(tool, "FOLDER", tmp_path / "installer")
    return tool


def test_each_python_gets_a_zip_with_the_wheels_of_both_systems(
    installer: ModuleType, asked: list[list[str]], tmp_path: Path
) -> None:
    assert installer.main(["3.11", "3.13"]) == 0
    names = [f"cncstepper-packages-{__version__}-py{python}.zip" for python in ("311", "313")]
    assert sorted(path.name for path in (tmp_path / "installer").iterdir()) == names
    for name in names:
        with zipfile.ZipFile(tmp_path / "installer" / name) as archive:
            assert archive.namelist() == ["numpy-1-manylinux2014_x86_64.whl", "numpy-1-win_amd64.whl"]
    assert len(asked) == 4
    for command in asked:
        assert {f"--requirement={dependencies.PINS}", "--no-deps", "--only-binary=:all:", "pip"} <= set(command)


def test_no_zip_is_left_where_wheels_are_missing(installer: ModuleType, tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match=r"the wheels for Python 3\.9 on Linux"):
        installer.main(["3.9"])
    assert list((tmp_path / "installer").iterdir()) == []
