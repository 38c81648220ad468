# SPDX-License-Identifier: LGPL-2.1-or-later
"""`njit`: compiles a kernel where numba is present and leaves it plain Python where it is not.

Never `parallel=True`: with a cold cache it starts `sys.executable`, which inside FreeCAD is FreeCAD.
Import this module only from modules that hold kernels: numba costs 0.4 s.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

import platformdirs

os.environ.setdefault("NUMBA_CACHE_DIR", platformdirs.user_cache_dir("cncstepper", appauthor=False))

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
