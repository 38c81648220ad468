# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cache of compiled kernels belongs to exactly one state of the sources."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numba.core import caching

from CNCStepper import kernel_cache, kernels


def test_other_sources_get_another_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "package"
    package.mkdir()
    source = package / "kernel.py"
    source.write_text("x = 1\n", encoding="utf-8")
    monkeypatch.setattr(kernel_cache, "PACKAGE", package)
    first = kernel_cache.cache_folder(tmp_path / "cache")
    assert kernel_cache.cache_folder(tmp_path / "cache") == first
    source.write_text("x = 22\n", encoding="utf-8")
    assert kernel_cache.cache_folder(tmp_path / "cache") != first


def test_checkouts_with_the_same_sources_share_a_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = set()
    for name in ("one", "another one ç"):
        (tmp_path / name / "room").mkdir(parents=True)
        (tmp_path / name / "room" / "kernel.py").write_text("x = 1\n", encoding="utf-8")
        monkeypatch.setattr(kernel_cache, "PACKAGE", tmp_path / name)
        found.add(kernel_cache.cache_folder(tmp_path / "cache"))
    (tmp_path / name / "room" / "kernel.py").rename(tmp_path / name / "kernel.py")
    assert len(found) == 1 and kernel_cache.cache_folder(tmp_path / "cache") not in found


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="XDG_CACHE_HOME")
def test_a_copy_of_the_package_elsewhere_compiles_nothing_again(tmp_path: Path) -> None:
    script = (
        "import numpy as np; from CNCStepper.geometry.arc_length import area_of; from CNCStepper import kernel_cache;"
        "area_of(np.zeros((3, 2)), np.zeros(3));"
        "print(kernel_cache.PACKAGE, sum(area_of.stats.cache_hits.values()), sum(area_of.stats.cache_misses.values()))"
    )
    package, copy = kernel_cache.PACKAGE, tmp_path / "another one ç" / "CNCStepper"
    shutil.copytree(package, copy, ignore=lambda _folder, names: [name for name in names if name == "__pycache__"])
    environment = {**os.environ, "XDG_CACHE_HOME": str(tmp_path / "cache")}
    environment.pop(kernel_cache.VARIABLE, None)  # of this process
    for root, counts in ((package.parent, "0 1"), (copy.parent, "1 0")):
        words = [sys.executable, "-X", "utf8", "-c", script]
        run = subprocess.run(words, cwd=root, env=environment, capture_output=True, check=True)
        assert run.stdout.decode("utf-8").strip() == f"{root / package.name} {counts}"


def test_old_caches_are_pruned(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kernel_cache, "PACKAGE", tmp_path / "package")
    (tmp_path / "package").mkdir()
    for number in range(kernel_cache.KEPT_CACHES + 5):
        old = tmp_path / "cache" / f"old{number}"
        old.mkdir(parents=True)
        os.utime(old, (number, number))
    kernel_cache.cache_folder(tmp_path / "cache")
    left = {path.name for path in (tmp_path / "cache").iterdir()}
    assert len(left) == kernel_cache.KEPT_CACHES
    assert f"old{kernel_cache.KEPT_CACHES + 4}" in left and "old0" not in left


def test_without_numba_a_kernel_is_plain_python(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kernels, "COMPILED", False)

    def kernel() -> int:
        return 1

    assert kernels.njit(kernel) is kernel


def test_rooms_without_kernels_do_not_matter(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "package"
    (package / "cli").mkdir(parents=True)
    monkeypatch.setattr(kernel_cache, "PACKAGE", package)
    first = kernel_cache.cache_folder(tmp_path / "cache")
    (package / "cli" / "verb.py").write_text("x = 1\n", encoding="utf-8")
    assert kernel_cache.cache_folder(tmp_path / "cache") == first


def test_the_rooms_left_out_hold_no_kernel() -> None:
    for room in kernel_cache.ROOMS_ABOVE:
        for path in (kernel_cache.PACKAGE / room).rglob("*.py"):
            assert "njit" not in path.read_text("utf-8"), path


def test_a_kernel_that_must_wait_runs_as_plain_python() -> None:
    looks = []

    def kernel(number: int) -> int:
        return number + 1

    compiled = kernels.njit(kernel)
    with kernels.uncompiled(lambda: looks.append(1)):
        assert compiled(1) == 2 and compiled(2) == 3
    assert len(looks) == 2 and not compiled.signatures
    assert compiled(1) == 2 and len(looks) == 2 and compiled.signatures


def test_what_looks_may_refuse_to_wait_longer() -> None:
    def refuse() -> None:
        raise TimeoutError

    kernel = kernels.njit(abs_of)
    with pytest.raises(TimeoutError), kernels.uncompiled(refuse):
        kernel(-1)
    assert kernel(-1) == 1


def abs_of(number: int) -> int:
    return -number if number < 0 else number


def test_the_stamp_is_of_these_sources_and_this_python(monkeypatch: pytest.MonkeyPatch) -> None:
    kernel_cache.stamp.cache_clear()
    here = kernel_cache.stamp()
    assert here.parent == kernel_cache.folder() and kernel_cache.digest() in here.name
    monkeypatch.setattr(kernel_cache, "digest", lambda: "other")
    kernel_cache.stamp.cache_clear()
    assert kernel_cache.stamp() != here
    kernel_cache.stamp.cache_clear()


def test_a_kernel_in_place_changes_arrays_and_can_make_none() -> None:
    numbers = np.array([3, 4])
    assert kernels.njit_in_place(first_doubled)(numbers) == 6 and numbers.tolist() == [6, 4]
    with pytest.raises(Exception, match="array"):
        kernels.njit_in_place(new_array)(2)


def first_doubled(numbers: np.ndarray) -> int:
    numbers[0] = 2 * numbers[0]
    return int(numbers[0])


def new_array(count: int) -> np.ndarray:
    return np.zeros(count)


def test_processes_that_keep_machine_code_at_the_same_time_never_load_each_others(tmp_path: Path) -> None:
    """Both have read the index before the other's entry was in it; one writes its code when the other has ended."""
    one, other = (caching.IndexDataCacheFile(str(tmp_path), "kernel-1", "stamp") for _ in range(2))
    write = one._save_data

    def late(name: str, data: str) -> None:
        other._load_index = dict
        other.save("array of rows", "code for rows")
        write(name, data)

    one._save_data = late
    one.save("array of columns", "code for columns")
    reader = caching.IndexDataCacheFile(str(tmp_path), "kernel-1", "stamp")
    assert reader.load("array of columns") in (None, "code for columns")
    assert reader.load("array of rows") in (None, "code for rows")
    assert [reader.load(key) for key in reader._load_index()] == ["code for rows"]
