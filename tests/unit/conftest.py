# SPDX-License-Identifier: LGPL-2.1-or-later
"""No test file calls a kernel when it is imported: see helpers/kernels_at_import.py."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from helpers.kernels_at_import import refused


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(collector: pytest.Collector) -> Iterator[None]:
    """Let the import of a test file fail that calls a kernel."""
    with refused(collector.path):
        return (yield)
