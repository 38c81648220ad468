# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the third-party packages reachable from FreeCAD's Python.

Their folders are appended to sys.path, never inserted: FreeCAD's own numpy and matplotlib must win.
"""

from __future__ import annotations

import importlib.util
import os
import sys
from pathlib import Path

from CNCStepper import dependencies
from CNCStepper.errors import MissingPackage, Text

ROOT = Path(__file__).resolve().parents[2]
NEEDED = dependencies.modules(dependencies.PROGRAM)

_found: set[str] = set()  # looking takes milliseconds, and every recompute asks


def make_available() -> None:
    """Append the folders that may hold third-party packages to sys.path; loads none of them."""
    known = set(sys.path)
    sys.path.extend(folder for folder in map(str, folders()) if folder not in known)


def folders() -> list[Path]:
    """Return the folders with packages for this Python that exist: the user's choice, the checkout's, FreeCAD's."""
    version = f"python{sys.version_info[0]}.{sys.version_info[1]}"
    chosen = [Path(part) for part in os.environ.get("CNCSTEPPER_PACKAGES", "").split(os.pathsep) if part]
    checkout = [ROOT / ".venv" / "lib" / version / "site-packages"]
    return [folder for folder in chosen + checkout + _addon_manager_folders() if folder.is_dir()]


def _addon_manager_folders() -> list[Path]:
    """Return where FreeCAD's Addon Manager puts packages; newer versions keep one folder for each Python."""
    try:
        import FreeCAD
    except ImportError:
        return []
    if not hasattr(FreeCAD, "getUserAppDataDir"):
        return []
    return [own_folder(), own_folder().parent]


def own_folder() -> Path:
    """Return the folder in which FreeCAD keeps additional packages for its Python; it need not exist.

    FreeCAD names it so since 0.21. FreeCAD 0.20 uses the folder above, without a version, and a newer FreeCAD moves
    what lies there into its own Python's folder, for which compiled packages may not be made.
    """
    import FreeCAD

    base = Path(FreeCAD.getUserAppDataDir()) / "AdditionalPythonPackages"
    return base / f"py{sys.version_info[0]}{sys.version_info[1]}"


def missing(*names: str) -> list[str]:
    """Return those of the packages that cannot be found, in their order; loads none of them."""
    unknown = [name for name in names if name not in _found]
    if unknown:
        make_available()
        _found.update(name for name in unknown if importlib.util.find_spec(name) is not None)
    return [name for name in unknown if name not in _found]


def require(*names: str) -> None:
    """Raise MissingPackage with install instructions when one of the packages cannot be found."""
    if _found.issuperset(names or NEEDED):
        return
    lacking = missing(*(names or NEEDED))
    if lacking:
        raise MissingPackage(
            "package-missing",
            Text("FreeCAD's Python lacks {lacking}", lacking=", ".join(lacking)),
            advice=Text(
                "choose 'Install packages…' in the CNCStepper menu, or install them for Python "
                "{version_info}.{version_info2} into a folder of their own (pip install --target FOLDER) and name it "
                "in the environment variable CNCSTEPPER_PACKAGES",
                version_info=sys.version_info[0],
                version_info2=sys.version_info[1],
            ),
        )
