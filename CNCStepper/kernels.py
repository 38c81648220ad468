# SPDX-License-Identifier: LGPL-2.1-or-later
"""`njit`: compiles a kernel where numba is present and leaves it plain Python where it is not.

Never `parallel=True`: with a cold cache it starts `sys.executable`, which inside FreeCAD is FreeCAD.
Import this module only from modules that hold kernels: numba costs 0.4 s.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeVar

import numpy as np

from CNCStepper import kernel_cache

kernel_cache.folder()  # numba reads its variable when it is loaded

numba: Any
try:
    import numba
except ImportError:  # everything still works, slowly; callers tell the user through COMPILED
    numba = None

COMPILED = numba is not None and not numba.config.DISABLE_JIT

Arrays = TypeVar("Arrays", bound=tuple)

_look: Callable[[], None] | None = None  # called in place of compiling, while that must wait


def njit(kernel: Callable[..., Any], **options: Any) -> Callable[..., Any]:
    """Return `kernel` compiled on first call, its machine code kept in the user's cache folder."""
    if not COMPILED:
        return kernel
    compiled = numba.njit(cache=True, nogil=True, **options)(kernel)
    compile_for = compiled._compile_for_args  # numba calls it for what is not compiled, and then what it returns

    def compile_or_not(*arguments: Any, **named: Any) -> Any:
        if _look is None:
            return compile_for(*arguments, **named)
        _look()
        return kernel

    compiled._compile_for_args = compile_or_not
    return compiled  # type: ignore[no-any-return]


def njit_in_place(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """Return what `njit` does of a kernel that makes no arrays, nor do those that it calls.

    No references to arrays are counted then, which takes longer at each call than a small kernel's own work.
    """
    return njit(kernel, _nrt=False)


def njit_inline(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """Return what `njit_in_place` does of a kernel whose code is to stand in every kernel that calls it.

    For small kernels that take many arrays: handing these over takes longer than the kernel's own work.
    """
    return njit(kernel, _nrt=False, forceinline=True)


def bare(arrays: Arrays) -> Arrays:
    """Return a named tuple of arrays, which may hold further ones, over the same memory, as kernels take it quickest.

    Compiled, a kernel is called eight times as quickly with plain records as with those that have attributes, which
    plain Python needs. For who calls small kernels again and again, and reads their records by `record["field"]`.
    """
    return type(arrays)(*map(_bare, arrays)) if COMPILED else arrays


def _bare(entry: Any) -> Any:
    if isinstance(entry, tuple):
        return bare(entry)
    return entry.view(np.dtype((np.void, entry.dtype)), np.ndarray) if entry.dtype.names else entry


def compiles() -> bool:
    """Whether a kernel that is called now runs as machine code."""
    return COMPILED and _look is None


@contextmanager
def uncompiled(look: Callable[[], None]) -> Iterator[None]:
    """Run those kernels as plain Python that are not compiled yet; `look` is called before each and may raise."""
    global _look
    before, _look = _look, look
    try:
        yield
    finally:
        _look = before
