# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pinned versions are whole, and the ones that these tests run with."""

from __future__ import annotations

import re
from importlib.metadata import PackageNotFoundError, requires, version

import pytest

from CNCStepper import dependencies

NEEDED = dependencies.pip_names([need.module for need in dependencies.NEEDS if need.module != "distributed"])


def needed_by(name: str) -> set[str]:
    """Return what a package needs on any system, without its extras."""
    plain = [line for line in requires(name) or [] if "extra ==" not in line]
    return {re.split(r"[<>=!~\[( ;]", line)[0] for line in plain}


def test_every_package_is_pinned_with_all_that_it_needs() -> None:
    pins, waiting, seen = dependencies.pins(), [*NEEDED], set[str]()
    while waiting:
        name = waiting.pop().lower().replace("_", "-")
        if name not in seen:
            seen.add(name)
            try:
                waiting += needed_by(name)
            except PackageNotFoundError:  # of another system, or of an older Python
                seen.discard(name)
    assert set(NEEDED) <= seen
    assert seen == set(pins)


@pytest.mark.parametrize(("name", "pinned"), dependencies.pins().items(), ids=[*dependencies.pins()])
def test_what_is_installed_is_what_is_pinned(name: str, pinned: str) -> None:
    assert version(name) == pinned


def test_a_requirement_is_what_pip_calls_it_with_its_version() -> None:
    pins = dependencies.pins()
    assert dependencies.requirements(["serial", "fontTools"]) == [
        f"pyserial=={pins['pyserial']}",
        f"fonttools=={pins['fonttools']}",
    ]
