# SPDX-License-Identifier: LGPL-2.1-or-later
"""The packages that FreeCAD's Python lacks, and the consequence."""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable
from typing import Any

from CNCStepper import dependencies
from CNCStepper.workbench import packages
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.translation import tr


@functools.cache
def why_not() -> str:
    """Return why no program can be made, "" when it can; looked up once, until `look_again`."""
    lacking = packages.missing(*packages.NEEDED)
    return tr("FreeCAD's Python lacks {0}").format(_listed(lacking)) if lacking else ""


def look_again() -> None:
    """Forget what was missing: it may have been installed since."""
    importlib.invalidate_caches()
    why_not.cache_clear()


def lacking_packages() -> list[str]:
    """Return all packages that FreeCAD's Python lacks of those that we use."""
    return packages.missing(*dependencies.REQUIRED, dependencies.FAST)


@functools.cache
def report_once(install: Callable[[], Any]) -> None:
    """Say what is missing and offer to install it; only the first time, for it stays so until somebody does.

    install: opens the dialog that asks before it installs anything.
    """
    lacking = lacking_packages()
    if lacking:
        advice = tr("'Install packages' asks first, and needs no administrator. You find it in the menu too.")
        messages.notice("\n".join(consequences(lacking)), advice, (tr("Install packages…"), install))


def consequences(lacking: list[str]) -> list[str]:
    """Return what the lack of some packages means, one sentence each."""
    found = []
    if needed := [name for name in lacking if name in packages.NEEDED]:
        found.append(tr("FreeCAD's Python lacks {0}. No program can be made without.").format(_listed(needed)))
    if reaching := [name for name in lacking if name in dependencies.modules(dependencies.MACHINE)]:
        found.append(tr("FreeCAD's Python lacks {0}. No machine can be reached without.").format(_listed(reaching)))
    if others := [name for name in lacking if name in _elsewhere()]:
        found.append(tr("FreeCAD's Python lacks {0}. Some files cannot be read without.").format(_listed(others)))
    if dependencies.FAST in lacking:
        found.append(tr("FreeCAD's Python lacks numba. All works without, but planning and simulating are slow."))
    return found


def _listed(names: list[str]) -> str:
    return ", ".join(dependencies.pip_names(names))


def _elsewhere() -> set[str]:
    """Return what neither a program nor a machine takes."""
    return (
        set(dependencies.REQUIRED)
        - set(dependencies.modules(dependencies.PROGRAM))
        - set(dependencies.modules(dependencies.MACHINE))
    )
