# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD sees of the workbench at its start."""

from __future__ import annotations

import ctypes
import os
from pathlib import Path

import FreeCAD
import pytest

import CNCStepper
from CNCStepper.errors import MissingPackage
from CNCStepper.workbench import packages

ROOT = Path(CNCStepper.__file__).parents[1]


def test_freecad_s_own_numpy_wins() -> None:
    import numpy
    import shapely

    venv = str(ROOT / ".venv")
    assert not numpy.__file__.startswith(venv)
    assert any(shapely.__file__.startswith(str(folder)) for folder in packages.folders())


def test_the_addon_manager_reads_package_xml() -> None:
    metadata = FreeCAD.Metadata(str(ROOT / "package.xml"))
    assert (metadata.Name, metadata.Version) == ("CNCStepper", CNCStepper.__version__)
    workbench = metadata.Content["workbench"][0]
    assert workbench.Classname == "CNCStepperWorkbench"
    assert workbench.supportsCurrentFreeCAD()


def test_a_missing_package_is_named_with_the_way_to_get_it() -> None:
    with pytest.raises(MissingPackage, match=r"lacks nonesuch.*CNCSTEPPER_PACKAGES"):
        packages.require("numpy", "nonesuch")


def test_the_locale_is_the_one_asked_for() -> None:
    """With a decimal comma the C library really writes one while these tests run."""
    text = ctypes.create_string_buffer(8)
    ctypes.CDLL(None).snprintf(text, 8, b"%.1f", ctypes.c_double(1.5))
    wanted = b"1,5" if os.environ["LC_ALL"].startswith("pt_BR") else b"1.5"
    assert text.value == wanted
