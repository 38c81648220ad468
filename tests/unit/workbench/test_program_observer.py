# SPDX-License-Identifier: LGPL-2.1-or-later
"""An object's program is watched while somebody shows it, and no longer."""

from __future__ import annotations

import sys
from types import SimpleNamespace

import pytest

from CNCStepper.workbench.services.program_observer import ProgramObserver


@pytest.fixture
def observers(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """Who FreeCAD tells of its documents."""
    found: list[object] = []
    freecad = SimpleNamespace(addDocumentObserver=found.append, removeDocumentObserver=found.remove)
    monkeypatch.setitem(sys.modules, "FreeCAD", freecad)
    return found


def test_it_hears_of_its_own_object_alone_and_of_every_document(observers: list[object]) -> None:
    heard: list[str] = []
    mine, other = object(), object()
    watch = ProgramObserver(mine, lambda: heard.append("changed"), lambda: heard.append("deleted"), heard.append)
    assert observers == [watch]
    watch.slotChangedObject(other, "Program")
    watch.slotChangedObject(mine, "Label")
    watch.slotDeletedObject(other)
    assert heard == []
    watch.slotChangedObject(mine, "Program")
    watch.slotDeletedObject(mine)
    watch.slotDeletedObject(mine)
    watch.slotDeletedDocument(SimpleNamespace(Name="Part"))
    assert heard == ["changed", "deleted", "Part"]


def test_it_may_watch_nothing_and_another_one_later(observers: list[object]) -> None:
    heard: list[str] = []
    watch = ProgramObserver(None, lambda: heard.append("changed"), lambda: heard.append("deleted"), heard.append)
    watch.slotDeletedObject(None)
    watch.obj = mine = object()
    watch.slotChangedObject(mine, "Program")
    assert heard == ["changed"]


def test_it_ends_once(observers: list[object]) -> None:
    watch = ProgramObserver(None, list, list, lambda name: None)
    watch.end()
    watch.end()
    assert observers == []
