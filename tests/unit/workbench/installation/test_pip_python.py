# SPDX-License-Identifier: LGPL-2.1-or-later
"""pip runs in a Python of FreeCAD's version."""

from __future__ import annotations

import sys

import pytest

from CNCStepper.control.processes.bootstrap import python_version
from CNCStepper.control.processes.python_finder import find_python
from CNCStepper.errors import MissingPackage
from CNCStepper.workbench.installation.pip_python import container, find_pip_python


def test_a_python_of_the_version_with_pip_is_found() -> None:
    assert find_pip_python(python_version()) == sys.executable


def test_one_without_pip_does_where_none_has_it(monkeypatch: pytest.MonkeyPatch) -> None:
    def only_bare(needs: tuple[str, ...], version: str) -> str:
        if needs:
            raise MissingPackage("python-missing", "no Python has pip")
        return f"/usr/bin/python{version}"

    monkeypatch.setattr("CNCStepper.workbench.installation.pip_python.find_python", only_bare)
    assert find_pip_python("3.13") == "/usr/bin/python3.13"


def test_where_there_is_none_the_version_is_named() -> None:
    find_python.cache_clear()
    with pytest.raises(MissingPackage, match=r"no Python 9\.9 .*\[pip-python\]") as refused:
        find_pip_python("9.9")
    assert "CNCSTEPPER_PYTHON" in refused.value.advice


@pytest.mark.parametrize(
    ("variables", "name"),
    [({"APPIMAGE": "/home/ana/FreeCAD.AppImage"}, "AppImage"), ({"SNAP_REVISION": "12"}, "Snap"), ({}, "")],
)
def test_the_container_is_known_by_its_variable(variables: dict[str, str], name: str) -> None:
    assert container(variables) == name
