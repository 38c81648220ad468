# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FreeCAD that cannot be set up is a failure with a sentence, never left out; the table tells it."""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
TOOLS = ("bash", "dirname", "mkdir", "realpath", "flock", "rm", "tail", "cat", "mktemp", "rmdir", "true")


@pytest.fixture
def matrix() -> Any:
    spec = importlib.util.spec_from_file_location("matrix_of_freecads", ROOT / "tools" / "matrix.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


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


def set_up(programs: Path, version: str = "1.0.0") -> tuple[subprocess.CompletedProcess[str], Path]:
    root = programs.parent / "peça nº 1" / version
    command = [str(shutil.which("bash")), str(ROOT / "tools" / "freecad_root.sh"), version, str(root)]
    environment = {**os.environ, "PATH": str(programs), "CNCSTEPPER_DEBIAN_MIRROR": "file:///nowhere"}
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60), root


def test_a_failed_set_up_is_said_with_its_last_words(programs: Path) -> None:
    result, root = set_up(programs)
    assert result.returncode == 1
    assert "debootstrap could not make trixie" in result.stderr and "planted failure" in result.stderr
    assert not root.exists()


def test_a_half_made_folder_is_removed_and_made_again(programs: Path) -> None:
    half = programs.parent / "peça nº 1" / "1.0.0.part" / "usr" / "half-made"
    half.mkdir(parents=True)
    result, _ = set_up(programs)
    assert result.returncode == 1 and not half.exists()


def test_who_is_not_root_is_told_what_to_do(programs: Path) -> None:
    stub(programs, "id", "echo 1000")
    result, _ = set_up(programs)
    assert result.returncode == 1 and "sudo make matrix" in result.stderr


def test_an_unknown_version_is_refused(programs: Path) -> None:
    result, _ = set_up(programs, "0.19")
    assert result.returncode == 1 and "0.20.2, 1.0.0 and 1.1.3" in result.stderr


def test_what_cannot_be_set_up_has_failed_and_the_rest_still_runs(
    matrix: Any, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(matrix, "system_version", lambda: "0.20.2")
    monkeypatch.setattr(matrix, "set_up", lambda version: version == "1.1.3")
    monkeypatch.setattr(matrix, "told_version", lambda where: f"{where} ['…']")
    monkeypatch.setattr(matrix, "headless", lambda where, environment: True)
    monkeypatch.setattr(matrix, "followed", lambda where: True)
    monkeypatch.setattr(matrix, "window", lambda where, kind, environment: where != "host" or kind != "scaled")
    assert matrix.main([]) == 1
    lines = {line.split()[0]: line for line in capsys.readouterr().out.splitlines() if line[:1].isdigit()}
    assert lines["1.0.0"].count("NOT SET UP") == 7
    assert lines["0.20.2"].count("passed") == 6 and lines["0.20.2"].count("FAILED") == 1
    assert lines["1.1.3"].count("passed") == 7
    assert matrix.main(["1.1.3"]) == 0
