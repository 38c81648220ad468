# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cache of compiled kernels belongs to exactly one state of the sources."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from CNCStepper import kernels


def test_other_sources_get_another_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "package"
    package.mkdir()
    source = package / "kernel.py"
    source.write_text("x = 1\n", encoding="utf-8")
    monkeypatch.setattr(kernels, "PACKAGE", package)
    first = kernels.cache_folder(tmp_path / "cache")
    assert kernels.cache_folder(tmp_path / "cache") == first
    source.write_text("x = 22\n", encoding="utf-8")
    assert kernels.cache_folder(tmp_path / "cache") != first


def test_old_caches_are_pruned(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kernels, "PACKAGE", tmp_path / "package")
    (tmp_path / "package").mkdir()
    for number in range(kernels.KEPT_CACHES + 5):
        old = tmp_path / "cache" / f"old{number}"
        old.mkdir(parents=True)
        os.utime(old, (number, number))
    kernels.cache_folder(tmp_path / "cache")
    left = {path.name for path in (tmp_path / "cache").iterdir()}
    assert len(left) == kernels.KEPT_CACHES
    assert f"old{kernels.KEPT_CACHES + 4}" in left and "old0" not in left


def test_without_numba_a_kernel_is_plain_python(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kernels, "numba", None)

    def kernel() -> int:
        return 1

    assert kernels.njit(kernel) is kernel


def test_rooms_without_kernels_do_not_matter(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "package"
    (package / "cli").mkdir(parents=True)
    monkeypatch.setattr(kernels, "PACKAGE", package)
    first = kernels.cache_folder(tmp_path / "cache")
    (package / "cli" / "verb.py").write_text("x = 1\n", encoding="utf-8")
    assert kernels.cache_folder(tmp_path / "cache") == first


def test_the_rooms_left_out_hold_no_kernel() -> None:
    for room in kernels.ROOMS_ABOVE:
        for path in (kernels.PACKAGE / room).rglob("*.py"):
            assert "njit" not in path.read_text("utf-8"), path
