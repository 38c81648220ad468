# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs this folder's tests inside FreeCAD's own process: `freecadcmd tests/freecad/run.py -M CHECKOUT`.

FreeCAD has then run Init.py, which makes pytest reachable too. freecadcmd swallows an uncaught
exception and runs the script once more, so the process is ended here, whatever happens. Arguments for
pytest come in the environment variable CNCSTEPPER_PYTEST, separated by newlines.
"""

import os
import sys
import traceback
from pathlib import Path

HERE = Path(__file__).resolve().parent
OPTIONS = ["-p", "no:cacheprovider", "-W", "ignore:Type PySide2:DeprecationWarning"]  # FreeCAD 1.0's own, 171 of them


def main() -> int:
    """Return pytest's exit status."""
    import FreeCAD
    import pytest

    sys.argv = ["pytest"]
    os.environ["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"  # FreeCAD's older packages may win over those with plugins
    print("FreeCAD", ".".join(FreeCAD.Version()[:3]), "Python", sys.version.split()[0], flush=True)
    extra = [argument for argument in os.environ.get("CNCSTEPPER_PYTEST", "").split("\n") if argument]
    return int(pytest.main([*OPTIONS, *(extra or [str(HERE)])]))


status = 1
try:
    status = main()
except BaseException:
    traceback.print_exc()
finally:
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)
