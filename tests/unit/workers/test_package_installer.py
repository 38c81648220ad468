# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packages come into a folder all or none, in place of their older versions; a folder of wheels is the index here."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pip
import pytest

from CNCStepper.workers.package_installer import NO_PIP, PINS, installation_arguments, move_into, pip_arguments
from helpers.wheels import write_wheel

ROOT = Path(__file__).parents[3]


@pytest.fixture
def wheels(tmp_path: Path) -> Path:
    """A folder with two packages, of which one needs the other."""
    folder = tmp_path / "wheels"
    folder.mkdir()
    write_wheel(folder, "probe_upper", "2.0", ["probe_lower"])
    write_wheel(folder, "probe_lower", "1.5")
    return folder


def install(
    target: Path, *requirements: str, source: Path, python: str | Path = sys.executable
) -> subprocess.CompletedProcess[str]:
    arguments = installation_arguments(target, requirements, source)
    return subprocess.run(
        [python, "-P", "-m", "CNCStepper.workers.package_installer", *arguments],
        capture_output=True,
        text=True,
        timeout=60,
        env={**os.environ, "PYTHONPATH": str(ROOT), "PIP_CONFIG_FILE": os.devnull, "PIP_USER": "1"},
    )


def names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()} if folder.exists() else set()


def version_in(target: Path, module: str) -> str:
    found: dict[str, str] = {}
    exec((target / module / "__init__.py").read_text("utf-8"), found)
    return found["VERSION"]


def test_packages_come_from_a_folder_with_what_they_need(wheels: Path, tmp_path: Path) -> None:
    target = tmp_path / "AdditionalPythonPackages" / "py311"
    result = install(target, "probe_upper==2.0", source=wheels)
    assert result.returncode == 0, result.stderr
    assert names(target) == {"probe_upper", "probe_lower", "probe_upper-2.0.dist-info", "probe_lower-1.5.dist-info"}
    assert names(target.parent) == {"py311"}, "nothing half done stays"
    assert version_in(target, "probe_upper") == "2.0"


def test_packages_come_from_a_zip_in_place_of_older_ones(wheels: Path, tmp_path: Path) -> None:
    target = tmp_path / "py311"
    assert install(target, "probe_upper", source=wheels).returncode == 0
    (target / "probe_upper" / "gone_since.py").touch()
    newer = write_wheel(tmp_path, "probe_upper", "2.1", ["probe_lower"])
    archive = tmp_path / "packages.zip"
    with zipfile.ZipFile(archive, "w") as written:
        for wheel in (newer, wheels / "probe_lower-1.5-py3-none-any.whl"):
            written.write(wheel, f"../{wheel.name}")  # only its name counts
    result = install(target, "probe_upper==2.1", source=archive)
    assert result.returncode == 0, result.stderr
    assert version_in(target, "probe_upper") == "2.1"
    assert names(target / "probe_upper") == {"__init__.py"}
    assert {name for name in names(target) if name.endswith("info")} == {
        "probe_upper-2.1.dist-info",
        "probe_lower-1.5.dist-info",
    }


@pytest.mark.parametrize("lacks", ["probe_lower", "all"])
def test_where_something_is_missing_nothing_comes(lacks: str, wheels: Path, tmp_path: Path) -> None:
    for wheel in wheels.glob("*.whl"):
        if lacks == "all" or wheel.name.startswith(lacks):
            wheel.unlink()
    target = tmp_path / "py311"
    result = install(target, "probe_upper", source=wheels)
    assert result.returncode
    expected = "no wheels in" if lacks == "all" else "No matching distribution found for probe_lower"
    assert expected in result.stderr
    assert not target.exists()
    assert names(tmp_path) == {"wheels"}


def test_a_folder_that_cannot_take_one_keeps_all_as_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    target, new, old = tmp_path / "target", tmp_path / "new", tmp_path / "old"
    for folder in (target / "a", new / "a", new / "b"):
        folder.mkdir(parents=True)
    (target / "a" / "older").touch()
    rename = Path.rename

    def refuse_b(self: Path, other: Path) -> Path:
        if (self.name, other.parent) == ("b", target):
            raise PermissionError("[WinError 32] used by another process")
        return rename(self, other)

    monkeypatch.setattr(Path, "rename", refuse_b)
    with pytest.raises(PermissionError):
        move_into(target, new, old)
    assert names(target) == {"a"}
    assert names(target / "a") == {"older"}
    assert names(new) == {"a", "b"}


def test_a_python_without_pip_takes_the_one_among_the_wheels(wheels: Path, tmp_path: Path) -> None:
    bare = tmp_path / "bare"
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(bare)], check=True)
    python = bare / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    refused = install(tmp_path / "py311", "probe_upper", source=wheels, python=python)
    assert refused.returncode
    assert NO_PIP in refused.stderr
    folder = Path(pip.__file__).parent
    with zipfile.ZipFile(wheels / f"pip-{pip.__version__}-py3-none-any.whl", "w") as archive:
        for path in folder.rglob("*"):
            if "__pycache__" not in path.parts:
                archive.write(path, path.relative_to(folder.parent))
    result = install(tmp_path / "py311", "probe_upper", source=wheels, python=python)
    assert result.returncode == 0, result.stderr
    assert version_in(tmp_path / "py311", "probe_lower") == "1.5"


def test_pip_is_asked_for_pinned_wheels_from_where_it_was_told(tmp_path: Path) -> None:
    online = pip_arguments(tmp_path, ["pyserial==3.5"], None, "http://proxy:8080")
    assert online[0] == "install"
    assert {"--only-binary=:all:", f"--constraint={PINS}", f"--target={tmp_path}", "pyserial==3.5"} <= set(online)
    assert "--proxy=http://proxy:8080" in online
    assert "--no-index" not in online
    offline = pip_arguments(tmp_path, ["pyserial==3.5"], tmp_path / "wheels")
    assert {"--no-index", f"--find-links={tmp_path / 'wheels'}"} <= set(offline)


def test_a_zip_that_is_none_is_refused(tmp_path: Path) -> None:
    broken = tmp_path / "packages.zip"
    broken.write_bytes(b"half of it")
    process = install(tmp_path / "py311", "probe_upper", source=broken)
    assert process.returncode == 1
    assert process.stderr.startswith("ERROR: ")
    assert "not a zip file" in process.stderr
    assert names(tmp_path) == {"packages.zip"}
