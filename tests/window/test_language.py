# SPDX-License-Identifier: LGPL-2.1-or-later
"""With FreeCAD in Portuguese of Brazil our commands, tips, panels, properties and dock are Portuguese as well.

FreeCAD is switched while it runs; CNCSTEPPER_WINDOW_LANGUAGE names a language to start in.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from window_helpers.hand import Hand

PORTUGUESE = "pt-BR"
STARTED_IN = os.environ.get("CNCSTEPPER_WINDOW_LANGUAGE", "English")
COMMANDS = {
    "CNCStepper_NewJob": "Novo trabalho",
    "CNCStepper_ImportTools": "Importar ferramentas…",
    "CNCStepper_ImportDrawing": "Importar desenho…",
    "CNCStepper_Text": "Texto",
    "CNCStepper_Shapes": "Formas…",
    "CNCStepper_Slices": "Fatiar um sólido…",
    "CNCStepper_Template": "Modelo…",
    "CNCStepper_Nest": "Aninhar em chapas…",
    "CNCStepper_Arrangement": "Dispor programas…",
    "CNCStepper_Freehand": "À mão livre",
    "CNCStepper_Face": "Facear",
    "CNCStepper_Pocket": "Bolsão",
    "CNCStepper_RectangularPocket": "Bolsão retangular",
    "CNCStepper_CircularPocket": "Bolsão circular",
    "CNCStepper_EllipticalPocket": "Bolsão elíptico",
    "CNCStepper_Contour": "Contorno",
    "CNCStepper_Drill": "Furar",
    "CNCStepper_Bore": "Mandrilar",
    "CNCStepper_Thread": "Rosquear",
    "CNCStepper_Engrave": "Gravar",
    "CNCStepper_SheetCut": "Corte de chapa",
    "CNCStepper_WireCut": "Corte com fio",
    "CNCStepper_Simulate": "Verificar e simular",
    "CNCStepper_Send": "Enviar",
    "CNCStepper_Controller": "Controlador",
    "CNCStepper_Machines": "Máquinas…",
    "CNCStepper_Letters": "Letras de pulso…",
}
ENGLISH = {
    "Depth",
    "Stepover",
    "Tool",
    "Stock",
    "Drawing",
    "Feed",
    "Hold",
    "Resume",
    "Port",
    "Connect",
    "Not connected",
}


@pytest.fixture(autouse=True)
def portuguese(hand: Hand) -> Iterator[None]:
    hand.main(FreeCADGui.setLocale, PORTUGUESE)
    hand.settle()
    yield
    hand.main(FreeCADGui.setLocale, STARTED_IN)
    hand.settle()


def action(command: str) -> Any:
    return FreeCADGui.Command.get(command).getAction()[0]


def shown_texts(widget: Any) -> set[str]:
    """Return what the visible labels, buttons and groups inside a widget say."""
    kinds = (QtGui.QLabel, QtGui.QAbstractButton)
    parts = [part for kind in kinds for part in widget.findChildren(kind) if part.isVisible()]
    groups = [part.title() for part in widget.findChildren(QtGui.QGroupBox) if part.isVisible()]
    return {part.text().strip(" :") for part in parts} | set(groups)


def cut_off() -> list[str]:
    """Return the task view's scroll areas that are narrower than what stands in them."""
    areas = FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea)
    shown = [area for area in areas if area.isVisible() and area.findChild(QtGui.QFormLayout)]
    assert shown
    return [str(area) for area in shown if area.widget().width() > area.viewport().width()]


def test_the_commands_are_portuguese(hand: Hand) -> None:
    texts = hand.main(lambda: {name: action(name).text().replace("&", "") for name in COMMANDS})
    assert texts == COMMANDS
    tip = hand.main(lambda: action("CNCStepper_Send").toolTip())
    assert "Verifica o programa do trabalho" in tip
    hand.main(FreeCAD.newDocument)
    hand.wait(lambda: "Crie antes um trabalho" in action("CNCStepper_Send").toolTip())


def test_the_panel_of_a_new_job_and_of_a_pocket_are_portuguese(hand: Hand) -> None:
    hand.command("CNCStepper_NewJob")
    hand.wait(lambda: FreeCADGui.Control.activeDialog())
    hand.settle()
    texts = hand.main(lambda: shown_texts(FreeCADGui.getMainWindow()))
    hand.shot("language-job")
    assert hand.main(cut_off) == []
    assert not texts & ENGLISH
    assert {"Bruto", "Máquina"} <= texts
    cancel = QtGui.QDialogButtonBox.StandardButton.Cancel
    hand.click(hand.main(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDialogButtonBox).button(cancel)))
    hand.wait(lambda: not FreeCADGui.Control.activeDialog())

    def job() -> None:
        from CNCStepper.workbench import api

        made = api.new_job(FreeCAD.ActiveDocument or FreeCAD.newDocument())
        api.add_tool(made)

    hand.main(job)
    hand.command("CNCStepper_EllipticalPocket")
    hand.wait(lambda: FreeCADGui.Control.activeDialog())
    hand.settle()
    texts = hand.main(lambda: shown_texts(FreeCADGui.getMainWindow()))
    hand.shot("language-pocket")
    assert hand.main(cut_off) == []
    assert not texts & ENGLISH
    assert {"Largura por passe", "Profundidade por passe"} <= texts


def test_the_property_editor_is_portuguese(hand: Hand) -> None:
    def tool() -> None:
        from CNCStepper.workbench import api

        document = FreeCAD.newDocument()
        made = api.add_tool(api.new_job(document))
        document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(made)

    hand.main(tool)
    hand.settle()

    def names() -> set[str]:
        found = set()
        for view in FreeCADGui.getMainWindow().findChildren(QtGui.QTreeView):
            model = view.model()
            if view.isVisible() and model is not None and model.columnCount() == 2:
                groups = [model.index(row, 0) for row in range(model.rowCount())]
                found |= {str(group.data()) for group in groups}
                found |= {
                    str(model.index(r, 0, group).data()) for group in groups for r in range(model.rowCount(group))
                }
        return found

    hand.wait(lambda: {"Ferramenta", "Diâmetro", "Rotação do fuso"} <= names(), 5, "Portuguese properties")
    hand.shot("language-properties")


def test_the_dock_is_portuguese(hand: Hand) -> None:
    hand.main(FreeCADGui.setLocale, STARTED_IN)
    hand.command("CNCStepper_Controller")
    hand.wait(lambda: hand.exists("CNCStepper_Dock_State"))
    hand.main(FreeCADGui.setLocale, PORTUGUESE)
    hand.command("CNCStepper_Controller")
    hand.wait(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock").isVisible())
    hand.settle()
    texts = hand.main(lambda: shown_texts(FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock")))
    hand.shot("language-dock")
    hand.main(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock").hide())
    assert not texts & ENGLISH
    assert "Desconectado" in texts


def test_drawing_speaks_portuguese(hand: Hand) -> None:
    hand.main(FreeCAD.newDocument)
    hand.command("CNCStepper_Freehand")
    assert "Desenhe uma linha" in hand.main(lambda: FreeCADGui.getMainWindow().statusBar().currentMessage())
    hand.key("Escape")
