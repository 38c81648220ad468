# SPDX-License-Identifier: LGPL-2.1-or-later
"""`njit`: compiles a kernel where numba is present and leaves it plain Python where it is not.

Never `parallel=True`: with a cold cache it starts `sys.executable`, which inside FreeCAD is FreeCAD.
Import this module only from modules that hold kernels: numba costs 0.4 s. A short command postpones that
(`kernel_cache.postponed`): its kernels run as plain Python for PYTHON_S, and are compiled if there is more to do.
"""

from __future__ import annotations

import importlib.util
import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, ClassVar, TypeVar

import numpy as np

from CNCStepper import kernel_cache

PYTHON_S = 0.15  # of plain Python before numba is loaded, which takes twice as long

LOOK_EVERY = 32  # calls of kernels by kernels, to have the time: asking for it takes as long as a small one


def _load_numba() -> Any:
    """Return numba, which keeps the machine code of the kernels in our folder of the user's cache."""
    kernel_cache.folder()  # numba reads its variable when it is loaded
    import numba
    from numba.core import caching

    if hasattr(caching, "UserProvidedCacheLocator"):  # of versions that know sources by their contents
        caching.CacheImpl._locator_classes.insert(0, _locator(caching.UserProvidedCacheLocator))
    caching.IndexDataCacheFile._data_name = _data_name  # type: ignore[method-assign]
    return numba


def _data_name(file: Any, number: int) -> str:
    """Return a name for machine code that no other process gives.

    numba takes the next number that is free in its index. Two processes that compile a kernel for different types at
    the same time would take the same one, and each could load the other's machine code.
    """
    return f"{file._index_name.removesuffix('.nbi')}.{number}-{os.urandom(8).hex()}.nbc"


def _locator(base: Any) -> Any:
    """Return what lets checkouts with the same sources share machine code: numba names folders by absolute paths."""

    class Locator(base):  # type: ignore[misc]
        @classmethod
        def from_function(cls, kernel: Callable[..., Any], file: str) -> Any:
            return super().from_function(kernel, file) if kernel_cache.subfolder(file) else None

        @classmethod
        def get_suitable_cache_subpath(cls, file: str) -> str:
            return kernel_cache.subfolder(file)

    return Locator


numba: Any = None
if not kernel_cache.postponed:
    try:
        numba = _load_numba()
    except ImportError:  # everything still works, slowly; callers tell the user through COMPILED
        numba = None


def _can_compile() -> bool:
    if kernel_cache.postponed:
        return importlib.util.find_spec("numba") is not None and os.environ.get("NUMBA_DISABLE_JIT", "0") in ("", "0")
    return numba is not None and not numba.config.DISABLE_JIT


COMPILED = _can_compile()

Arrays = TypeVar("Arrays", bound=tuple)

_look: Callable[[], None] | None = None  # called in place of compiling, while that must wait


def njit(kernel: Callable[..., Any], **options: Any) -> Callable[..., Any]:
    """Return `kernel` compiled on first call, its machine code kept in the user's cache folder."""
    if not COMPILED:
        return kernel
    return _compiled(kernel, options) if numba else _Postponed(kernel, options)


def _compiled(kernel: Callable[..., Any], options: dict[str, Any]) -> Callable[..., Any]:
    compiled = numba.njit(cache=True, nogil=True, **options)(kernel)
    compile_for = compiled._compile_for_args  # numba calls it for what is not compiled, and then what it returns

    def compile_or_not(*arguments: Any, **named: Any) -> Any:
        if _look is None:
            return compile_for(*arguments, **named)
        _look()
        return kernel

    compiled._compile_for_args = compile_or_not
    return compiled  # type: ignore[no-any-return]


class _Postponed:
    """A kernel that runs as plain Python until all of them together have taken PYTHON_S."""

    made: ClassVar[list[_Postponed]] = []
    spent_s = 0.0
    begun_s: float | None = None  # when the outermost kernel that runs was called
    calls = 0
    late = False  # their time is over

    def __init__(self, kernel: Callable[..., Any], options: dict[str, Any]):
        self._kernel, self._options = kernel, options
        self.compiled: Callable[..., Any] | None = None
        self.made.append(self)

    def __call__(self, *arguments: Any, **named: Any) -> Any:
        if self.compiled is None and self._has_time():
            return self._run(*arguments, **named)
        load()
        assert self.compiled
        return self.compiled(*arguments, **named)

    @classmethod
    def _has_time(cls) -> bool:
        cls.calls += 1
        if cls.begun_s is None or cls.calls % LOOK_EVERY == 0:
            running_s = 0.0 if cls.begun_s is None else time.thread_time() - cls.begun_s
            cls.late = cls.late or cls.spent_s + running_s >= PYTHON_S
        return not cls.late

    def _run(self, *arguments: Any, **named: Any) -> Any:
        if _Postponed.begun_s is not None:
            return self._kernel(*arguments, **named)
        _Postponed.begun_s = time.thread_time()
        try:
            return self._kernel(*arguments, **named)
        finally:
            _Postponed.spent_s += time.thread_time() - _Postponed.begun_s
            _Postponed.begun_s = None

    def compile(self) -> None:
        """Make the kernel that numba compiles at its first call."""
        self.compiled = _compiled(self._kernel, self._options)


def load() -> None:
    """Load numba where that was postponed; kernels that call others then find these compiled, too."""
    global numba
    if numba is not None:
        return
    numba = _load_numba()
    kernel_cache.postponed = False
    for kernel in _Postponed.made:
        kernel.compile()
    for name, module in list(sys.modules.items()):
        if name.startswith("CNCStepper"):
            for held, value in list(vars(module).items()):
                if isinstance(value, _Postponed):
                    setattr(module, held, value.compiled)


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
    if COMPILED:
        load()  # plain Python could not read these records
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
