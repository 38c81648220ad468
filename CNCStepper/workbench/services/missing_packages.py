# SPDX-License-Identifier: LGPL-2.1-or-later
"""The packages that FreeCAD's Python lacks, the consequence, and how to install them."""

from __future__ import annotations

import functools
import importlib
import os
import sys

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
def report_once() -> None:
    """Say what is missing and how to get it; only the first time, for it stays so until somebody installs it."""
    lacking = lacking_packages()
    if lacking:
        messages.notice("\n".join(consequences(lacking)), how_to_get(lacking))


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


def how_to_get(lacking: list[str]) -> str:
    """Return how to get packages for FreeCAD's Python, with the command to type."""
    version = f"{sys.version_info[0]}.{sys.version_info[1]}"
    python = f"py -{version}" if os.name == "nt" else f"python{version}"
    names = " ".join(dependencies.pip_names(lacking))
    return (
        tr("To install the missing packages, type in a terminal, with Python {0}, and start FreeCAD again:").format(
            version
        )
        + f'\n\n{python} -m pip install --target "{packages.own_folder()}" {names}'
    )


def _listed(names: list[str]) -> str:
    return ", ".join(dependencies.pip_names(names))


def _elsewhere() -> set[str]:
    """Return what neither a program nor a machine takes."""
    return (
        set(dependencies.REQUIRED)
        - set(dependencies.modules(dependencies.PROGRAM))
        - set(dependencies.modules(dependencies.MACHINE))
    )
