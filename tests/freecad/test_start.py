# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD sees of the workbench at its start."""

from __future__ import annotations

import ctypes
import locale
import os
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import FreeCAD
import pytest

import CNCStepper
from CNCStepper.errors import MissingPackage
from CNCStepper.workbench import api, packages

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
    assert metadata.supportsCurrentFreeCAD()
    assert metadata.FreeCADMin == "0.20.2"
    assert {"part", "numpy"} <= {depend["package"] for depend in metadata.Depend}
    workbench = metadata.Content["workbench"][0]
    assert workbench.Classname == "CNCStepperWorkbench"
    assert workbench.supportsCurrentFreeCAD()


def test_the_addon_manager_may_install_what_package_xml_requires() -> None:
    """It refuses to install a workbench that requires others: those come by *Install packages…*."""
    listed = Path(FreeCAD.getHomePath()) / "Mod" / "AddonManager" / "ALLOWED_PYTHON_PACKAGES.txt"
    if not listed.exists():  # Debian keeps what is not compiled elsewhere
        listed = Path("/usr/share/freecad") / listed.relative_to(FreeCAD.getHomePath())
    allowed = {line.strip().lower() for line in listed.read_text("utf-8").splitlines()}
    depends = ElementTree.parse(ROOT / "package.xml").iter("{https://wiki.freecad.org/Package_Metadata}depend")
    python = [depend for depend in depends if depend.get("type") == "python"]
    required = {depend.text for depend in python if depend.get("optional") != "true"}
    assert required == {"numpy", "ezdxf", "matplotlib", "pillow"}
    assert required <= allowed


def test_packages_are_installed_beside_mod() -> None:
    folder = packages.own_folder()
    assert folder.parents[1] == Path(FreeCAD.getUserAppDataDir())
    assert folder.name == "py" + "".join(map(str, sys.version_info[:2]))


def test_a_missing_package_is_named_with_the_way_to_get_it() -> None:
    with pytest.raises(MissingPackage, match=r"lacks nonesuch.*CNCSTEPPER_PACKAGES"):
        packages.require("numpy", "nonesuch")


def c_number() -> bytes:
    """Return 1.5 as the C library writes it."""
    text = ctypes.create_string_buffer(8)
    ctypes.CDLL(None).snprintf(text, 8, b"%.1f", ctypes.c_double(1.5))
    return text.value


def test_a_program_is_the_same_where_numbers_have_a_comma(document: Any) -> None:
    """FreeCAD itself keeps the decimal point; here the C library really writes the comma of the run's locale."""
    job = api.new_job(document)
    api.add_tool(job)
    pocket = api.add_elliptical_pocket(job, radius_x_mm=40.5, depth_mm=2.5)
    document.recompute()
    with_point = api.program_text(job)
    assert c_number() == b"1.5"
    locale.setlocale(locale.LC_NUMERIC, "")
    try:
        assert c_number() == (b"1,5" if os.environ["LC_ALL"].startswith("pt_BR") else b"1.5")
        pocket.touch()
        document.recompute()
        assert api.program_text(job) == with_point
    finally:
        locale.setlocale(locale.LC_NUMERIC, "C")
