# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packages come by a click, without another start of FreeCAD; a folder with small wheels is the index here."""

from __future__ import annotations

import importlib
import os
import sys
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import FreeCADGui
import pytest
from test_language import PORTUGUESE, STARTED_IN, shown_texts

from CNCStepper import dependencies
from CNCStepper.control.processes.bootstrap import python_version
from CNCStepper.control.processes.python_finder import find_python
from CNCStepper.errors import MissingPackage
from CNCStepper.workbench import packages
from CNCStepper.workbench.installation.dialog import Installer
from helpers.wheels import write_wheel
from window_helpers import screen_places as places
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand
from window_helpers.interface import LONGEST_MS

I = "CNCStepper_Install"  # noqa: E741
WAITS_MS = 100.0  # for a lock or a file, 5 ms measured: others use the disk too
NEEDS = [
    dependencies.Need("cncstepper_probe", "cncstepper_probe", (dependencies.PROGRAM, dependencies.MACHINE)),
    dependencies.Need("cncstepper_spare", "cncstepper_spare", (dependencies.NESTING,)),
]
INSTALLED_S = 60.0


@pytest.fixture
def wheels(tmp_path: Path) -> Path:
    folder = tmp_path / "wheels"
    folder.mkdir()
    write_wheel(folder, "cncstepper_probe", "1.0", ["cncstepper_base"])
    write_wheel(folder, "cncstepper_base", "3.0")
    write_wheel(folder, "cncstepper_spare", "2.0")
    return folder


@pytest.fixture
def target(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Where packages come to, which this FreeCAD takes some from; it is not there yet."""
    folder = tmp_path / "AdditionalPythonPackages" / "py399"
    monkeypatch.setenv("CNCSTEPPER_PACKAGES", os.pathsep.join([os.environ.get("CNCSTEPPER_PACKAGES", ""), str(folder)]))
    pins = {"cncstepper_probe": "1.0", "cncstepper_spare": "2.0"}
    monkeypatch.setattr(dependencies, "pins", lambda: pins)
    yield folder
    sys.path[:] = [entry for entry in sys.path if entry != str(folder)]
    for name in [name for name in sys.modules if name.startswith("cncstepper_")]:
        del sys.modules[name]
    packages._found.difference_update(need.module for need in NEEDS)


@pytest.fixture
def open_dialog(hand: Hand, target: Path) -> Iterator[Callable[[], Any]]:
    opened: list[Any] = []

    def show() -> Any:
        def make() -> Any:
            dialog = Installer(FreeCADGui.getMainWindow(), NEEDS, target)
            dialog.show()
            dialog.raise_()
            dialog.activateWindow()
            return dialog

        opened.append(hand.main(make))
        hand.wait(lambda: opened[-1].isVisible())
        return opened[-1]

    yield show
    for dialog in opened:
        hand.main(lambda dialog=dialog: (dialog.reject(), dialog.deleteLater()))


def choose(hand: Hand, entry: str, path: Path) -> None:
    """Choose a zip or a folder by the button, as a person does who types its path."""
    hand._click_place(hand._place(places.of_widget, f"{I}_files", None))
    hand.wait(lambda: places.popup_entry(entry))
    hand._click_place(hand.main(places.popup_entry, entry))
    choose_file(hand, f"{I}_file", path)
    hand.wait(lambda: places.find(f"{I}_status").text(), 10, "the installation to begin")


def ended(hand: Hand, dialog: Any) -> bool:
    """Wait for the end; return whether there was a pip.

    The FreeCADs of `make matrix` have none, and the dialog says so; tests/test_empty_home.py installs there with the
    zip's pip.
    """
    hand.wait(lambda: dialog.run is None, INSTALLED_S, "the installation")
    try:
        find_python(("pip",), python_version())
        return True
    except MissingPackage:
        assert "has no pip" in hand.main(lambda: dialog.details.toPlainText() and dialog.error.text())
        return False


def test_a_folder_is_installed_and_imported_at_once(hand: Hand, open_dialog: Any, wheels: Path, target: Path) -> None:
    dialog = open_dialog()
    assert str(target) in hand.text(f"{I}_place")
    hand.shot("install-asks", dialog)
    choose(hand, "From a folder…", wheels)
    with hand.watchdog() as watch:
        hand.wait(lambda: dialog.run is None, INSTALLED_S, "the installation")
    print(f"installing: {watch}".partition(" in\n")[0], flush=True)
    assert watch.max_cpu_ms < LONGEST_MS, watch
    assert watch.max_waited_ms < WAITS_MS, f"the window waits for pip: {watch}"
    if not ended(hand, dialog):
        return
    assert hand.text(f"{I}_status").startswith("Installed."), hand.main(dialog.details.toPlainText)
    assert hand.main(lambda: importlib.import_module("cncstepper_probe").VERSION) == "1.0"
    assert {path.name for path in target.parent.iterdir()} == {target.name}
    assert hand.main(dialog.list.count) == 0
    assert not hand.main(dialog.install_button.isEnabled)
    hand.shot("install-done", dialog)


def test_only_what_is_marked_comes_from_a_zip_and_the_rest_from_the_index(
    hand: Hand, open_dialog: Any, wheels: Path, target: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    archive = tmp_path / "packages.zip"
    with zipfile.ZipFile(archive, "w") as written:
        for wheel in wheels.glob("*.whl"):
            written.write(wheel, wheel.name)
    dialog = open_dialog()
    hand.click(hand.main(dialog.list.viewport), at=hand.main(mark_of, dialog.list, 1))
    hand.wait(lambda: dialog.chosen() == ["cncstepper_probe"], 5, "the mark to go")
    choose(hand, "From a zip…", archive)
    if not ended(hand, dialog):
        return
    assert not any(path.name.startswith("cncstepper_spare") for path in target.iterdir())
    assert [hand.main(lambda: dialog.list.item(0).text()).split()[0]] == ["cncstepper_spare"]
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    monkeypatch.setenv("PIP_FIND_LINKS", str(wheels))
    hand.click(f"{I}_install")
    hand.wait(lambda: dialog.run is None and dialog.list.count() == 0, INSTALLED_S, "the other one")
    assert hand.text(f"{I}_status").startswith("Installed.")


def mark_of(view: Any, row: int) -> tuple[int, int]:
    """Return the place of the mark before an entry of a list."""
    rect = view.visualRect(view.model().index(row, 0))
    return rect.left() + 10, rect.center().y()


def test_a_failure_says_what_to_do_in_portuguese(hand: Hand, open_dialog: Any, wheels: Path, target: Path) -> None:
    (wheels / "cncstepper_base-3.0-py3-none-any.whl").unlink()
    hand.main(FreeCADGui.setLocale, PORTUGUESE)
    try:
        dialog = open_dialog()
        choose(hand, "De uma pasta…", wheels)
        hand.wait(lambda: dialog.run is None, INSTALLED_S, "the installation")
        said = hand.text(f"{I}_error")
        assert ("não tem cncstepper_base" in said and "make installer PYTHONS=" in said) or "não tem o pip" in said
        hand.click(f"{I}_details_button")
        hand.wait(dialog.details.isVisible)
        hand.click(f"{I}_details")
        hand.key("Ctrl+A")
        assert hand.main(lambda: dialog.details.textCursor().hasSelection()), "what pip said can be copied"
        hand.shot("install-failed-portuguese", dialog)
        assert {"Instalar", "De arquivos", "Detalhes", "Fechar"} <= hand.main(lambda: shown_texts(dialog))
        assert not target.exists()
    finally:
        hand.main(FreeCADGui.setLocale, STARTED_IN)


def test_cancel_ends_it_and_leaves_nothing(hand: Hand, open_dialog: Any, target: Path, tmp_path: Path) -> None:
    endless = tmp_path / "packages.zip"
    os.mkfifo(endless)  # nobody writes into it: reading it waits for ever
    dialog = open_dialog()
    hand.main(dialog.install, endless)
    hand.wait(lambda: dialog.run is not None and dialog.run._process is not None, 20, "the process")
    hand.shot("install-runs", dialog)
    hand.click(f"{I}_close")
    hand.wait(lambda: dialog.run is None)
    assert hand.text(f"{I}_status").startswith("Cancelled")
    assert hand.main(dialog.install_button.isEnabled)
    hand.wait(lambda: not target.parent.exists() or not list(target.parent.iterdir()), 10, "the rest to go")
    hand.click(f"{I}_close")
    hand.wait(lambda: not dialog.isVisible())
