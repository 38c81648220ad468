# SPDX-License-Identifier: LGPL-2.1-or-later
"""`njit`: compiles a kernel where numba is present and leaves it plain Python where it is not.

Never `parallel=True`: with a cold cache it starts `sys.executable`, which inside FreeCAD is FreeCAD.
Import this module only from modules that hold kernels: numba costs 0.4 s.
"""

from __future__ import annotations

import hashlib
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import platformdirs

PACKAGE = Path(__file__).resolve().parent
ROOMS_ABOVE = {"cli", "control", "cycles", "drawing", "gcode", "job", "virtual", "workbench"}  # no kernel uses them
KEPT_CACHES = 16


def cache_folder(root: Path) -> Path:
    """Return the folder below `root` for the machine code of exactly these sources; older ones are pruned.

    numba looks only at the file of the kernel that is called: code of a changed kernel that it calls would
    live on in a cache shared by two versions.
    """
    digest = hashlib.sha256()
    for path in sorted(PACKAGE.rglob("*.py")):
        if path.relative_to(PACKAGE).parts[0] in ROOMS_ABOVE:
            continue
        state = path.stat()
        digest.update(f"{path}|{state.st_size}|{state.st_mtime_ns}\n".encode())
    folder = root / digest.hexdigest()[:16]
    if not folder.is_dir():
        _prune(root)
        folder.mkdir(parents=True, exist_ok=True)
    return folder


def _prune(root: Path) -> None:
    """Delete all but the newest caches; another process may be doing the same."""
    if root.is_dir():
        caches = sorted((path for path in root.iterdir() if path.is_dir()), key=lambda path: path.stat().st_mtime_ns)
        for path in caches[: -KEPT_CACHES + 1]:
            shutil.rmtree(path, ignore_errors=True)


if "NUMBA_CACHE_DIR" not in os.environ:
    os.environ["NUMBA_CACHE_DIR"] = str(cache_folder(platformdirs.user_cache_path("cncstepper", appauthor=False)))

numba: Any
try:
    import numba
except ImportError:  # everything still works, slowly; callers tell the user through COMPILED
    numba = None

COMPILED = numba is not None and not numba.config.DISABLE_JIT


def njit(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """Return `kernel` compiled on first call, its machine code kept in the user's cache folder."""
    if numba is None:
        return kernel
    return numba.njit(cache=True, nogil=True)(kernel)
