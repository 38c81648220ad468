# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first thing in a process of our own: `python -m CNCStepper.control.processes.bootstrap MODULE ARGUMENTS...`.

Where this Python lacks a package that we use, those that the starting process sees (FreeCAD's, the Addon Manager's)
stand behind its own, if both are of one version; then MODULE runs as if it had been started itself.
"""

from __future__ import annotations

import os
import runpy
import sys
from importlib.util import find_spec

from CNCStepper.dependencies import FAST, REQUIRED

BEHIND = "CNCSTEPPER_BEHIND"  # a version of Python, then the folders that it imports from
USED = (*REQUIRED, FAST)


def python_version() -> str:
    """Return the version for which compiled packages are made, for example "3.11"."""
    return f"{sys.version_info[0]}.{sys.version_info[1]}"


def see_packages(*needs: str) -> None:
    """Append the folders of the starting process to sys.path, when it was this version of Python and one of `needs`
    is missing (without any: of USED).

    Else they stay out: this Python's own numpy would meet packages that were compiled for another.
    """
    if all(find_spec(name) for name in needs or USED):
        return
    version, *folders = os.environ.get(BEHIND, "").split(os.pathsep)
    if version == python_version():
        sys.path.extend(folder for folder in folders if folder not in sys.path)


if __name__ == "__main__":
    see_packages()
    del sys.argv[0]
    runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)
