# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refuses calls of kernels while test files are imported."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NoReturn

from CNCStepper import kernels


@contextmanager
def refused(path: Path) -> Iterator[None]:
    """Raise AssertionError where a kernel is called that is not compiled yet; `path` is the file being imported.

    With a cold cache every worker would compile it while it collects the tests, all at the same time. While tests are
    collected no kernel has been called before, so none is missed, whatever the cache holds.
    """

    def refuse() -> NoReturn:
        raise AssertionError(f"{path.name} calls a kernel when it is imported: call it in a fixture or in the test")

    with kernels.uncompiled(refuse):
        yield
