# SPDX-License-Identifier: LGPL-2.1-or-later
"""package.xml is what FreeCAD's Addon Manager reads: complete, and in step with the rest of the project."""

from __future__ import annotations

import datetime
import re
import sys
import tomllib
from pathlib import Path
from xml.etree import ElementTree

import CNCStepper
from CNCStepper import dependencies
from helpers.imports import FREECAD, QT, imported, modules, package_of

ROOT = Path(__file__).parents[2]
MESSAGES = ROOT / "CNCStepper" / "workbench" / "services" / "messages.py"
NAMESPACE = "{https://wiki.freecad.org/Package_Metadata}"


def package() -> ElementTree.Element:
    return ElementTree.parse(ROOT / "package.xml").getroot()


def workbench() -> ElementTree.Element:
    found = package().find(f"{NAMESPACE}content/{NAMESPACE}workbench")
    assert found is not None
    return found


def text(element: ElementTree.Element, name: str) -> str:
    found = element.find(NAMESPACE + name)
    assert found is not None, f"<{name}> is missing"
    return (found.text or "").strip()


def depends(kind: str) -> list[ElementTree.Element]:
    return [depend for depend in package().iter(f"{NAMESPACE}depend") if depend.get("type") == kind]


def test_the_required_elements_are_there() -> None:
    root = package()
    assert root.tag == f"{NAMESPACE}package"
    assert root.get("format") == "1"
    assert text(root, "name") == "CNCStepper"
    assert len(text(root, "description")) > 20
    assert datetime.date.fromisoformat(text(root, "date"))
    assert [person.get("email") for person in root.iter(f"{NAMESPACE}maintainer")]
    urls = {url.get("type"): url for url in root.iter(f"{NAMESPACE}url")}
    assert {"repository", "readme"} <= set(urls)
    assert urls["repository"].get("branch") == "main"
    report_at = re.search(r'^REPORT_AT = "(.+)"$', MESSAGES.read_text("utf-8"), re.MULTILINE)
    assert report_at and urls["bugtracker"].text == report_at[1]


def test_the_version_is_the_package_s() -> None:
    assert text(package(), "version") == CNCStepper.__version__


def test_files_that_it_names_exist() -> None:
    license_element = package().find(f"{NAMESPACE}license")
    assert license_element is not None
    assert license_element.text == "LGPL-2.1-or-later"
    assert "Version 2.1, February 1999" in (ROOT / str(license_element.get("file"))).read_text("utf-8")
    for element in (package(), workbench()):
        ElementTree.parse(ROOT / text(element, "icon"))


def test_the_workbench_is_the_one_that_initgui_adds() -> None:
    assert text(workbench(), "subdirectory") == "./"
    assert f"class {text(workbench(), 'classname')}(" in (ROOT / "InitGui.py").read_text("utf-8")


def test_what_it_needs_stands_directly_in_the_package() -> None:
    """The Addon Academy's rule: what stands in a content item counts for that item alone."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    needs = {NAMESPACE + name for name in ("freecadmin", "freecadmax", "pythonmin", "depend")}
    everywhere = [element for element in package().iter() if element.tag in needs]
    assert len(everywhere) == len([element for element in package() if element.tag in needs])
    assert text(package(), "freecadmin") == "0.20.2"
    assert f">={text(package(), 'pythonmin')}" == project["requires-python"]


def test_the_workbenches_of_freecad_are_those_that_are_imported() -> None:
    """Path is called path in FreeCAD 0.20 and cam later; 0.20 takes an unknown name for a Python package."""
    found = {
        name.partition(".")[0]
        for module, path in modules().items()
        for name, _ in imported(path.read_text("utf-8"), package_of(module, path))
    }
    used = {name.lower() for name in found & FREECAD} - {"freecad", "freecadgui", "path"}
    assert {depend.text for depend in depends("internal")} == used == {"part", "mesh"}


def test_the_packages_are_those_of_pyproject() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    wanted = {re.split(r"[<>=~ ]", requirement)[0] for requirement in project["dependencies"]}
    assert {depend.get("type") for depend in package().iter(f"{NAMESPACE}depend")} == {"internal", "python"}
    optional = {depend.text for depend in depends("python") if depend.get("optional") == "true"}
    assert {depend.text for depend in depends("python")} == wanted | {"numba", "cadquery"}
    required = {depend.text for depend in depends("python")} - optional
    assert required == {"numpy", "ezdxf", "matplotlib", "pillow"}, "the Addon Manager lists no others in every version"


def test_the_packages_are_those_of_the_one_list() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    wanted = [re.split(r"[<>=~ ]", requirement)[0] for requirement in project["dependencies"]]
    fast = [re.split(r"[<>=~ ]", requirement)[0] for requirement in project["optional-dependencies"]["fast"]]
    assert dependencies.pip_names(dependencies.REQUIRED) == wanted
    assert dependencies.pip_names([dependencies.FAST]) == fast
    assert all(need.purposes for need in dependencies.NEEDS)


def test_every_package_that_is_imported_stands_in_the_one_list() -> None:
    """CadQuery is called in a process of its own, by one module there; FreeCAD brings its own and Qt."""
    of_cadquery = {(name, "CNCStepper.drawing.solids.occ_edges") for name in ("OCP", "cadquery")}
    allowed = (
        {need.module for need in dependencies.NEEDS} | set(sys.stdlib_module_names) | {"CNCStepper", "pydantic_core"}
    )
    found = {
        (name.partition(".")[0], module)
        for module, path in modules().items()
        for name, _ in imported(path.read_text("utf-8"), package_of(module, path))
    }
    strange = {(name, module) for name, module in found - of_cadquery if name not in allowed | QT | FREECAD}
    assert not strange, sorted(strange)
