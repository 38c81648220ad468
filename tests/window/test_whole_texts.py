# SPDX-License-Identifier: LGPL-2.1-or-later
"""No text of a panel, dialog or dock is cut, at 1280 × 720 with letters of 100 to 200 %.

Letters grow in place, and with them window, docks and dialogs, as on a screen with that many more pixels. All pixels
that the product itself counts stay as they are: a text that no longer fits in them is found so.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from functools import partial
from itertools import combinations
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui
from test_cycle_panels import unfold
from test_dock import D, dock, own_sessions  # noqa: F401
from test_editor import no_editor_stays  # noqa: F401
from test_lathe import every_operation
from test_simulation_view import job, no_restart  # noqa: F401
from test_simulation_view import opened as simulation_of
from test_typing import draw

from CNCStepper.workbench import api, editor, first_run, panels, restart
from CNCStepper.workbench.assistant import open_assistant
from CNCStepper.workbench.comparison import open_comparison
from CNCStepper.workbench.dock.views.cut_dialog import CutChoice, CutDialog
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.first_run.tour import begin_tour
from CNCStepper.workbench.help.window import open_help
from CNCStepper.workbench.installation import open_installation
from CNCStepper.workbench.letters import open_letters
from CNCStepper.workbench.libraries import open_libraries
from CNCStepper.workbench.machines import open_machines
from CNCStepper.workbench.panels.shape_gallery import open_gallery
from CNCStepper.workbench.part_records import open_part_records
from CNCStepper.workbench.preferences.job_preferences import JobPreferences
from CNCStepper.workbench.services.button_row import ButtonRow
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.templates.panel import open_template_panel
from CNCStepper.workbench.templates.save_dialog import ask_to_save
from window_helpers import screen_places as places
from window_helpers.hand import Hand
from window_helpers.task_panels import PANEL

SMALL_SCREEN = (1280, 690)  # pixels: 1280 × 720 with the window's frame
FRAME_PX = 2  # of a theme that is put on while FreeCAD runs
# A style sheet of FreeCAD 1.1 gives the letters of its windows a size of their own: they do not grow with Qt's.
SCALES = (1.0, 1.25, 1.5, 2.0) if FreeCAD.Version()[1] == "20" else (1.0,)
SIGN = Path(__file__).parents[2] / "examples" / "drawings" / "sign.svg"
STYLE_SHEETS = Path(FreeCAD.getResourceDir()) / "Gui" / "Stylesheets"
DARK = STYLE_SHEETS / "Dark-blue.qss"  # FreeCAD 1.1 has none of its kind that Qt reads as it is
PLAIN_DARK = "QWidget { background-color: #232932; color: #e0e0e0; }"
TABBED = {"CNCStepper_Machines", "CNCStepper_Library"}


def drawn_objects(document: Any) -> list[Any]:
    """Make what is drawn, placed and nested in a document."""
    shape, text = api.add_shape(document, "flange"), api.add_text(document, "Sign")
    slices = api.add_slices(document, document.addObject("Part::Box", "Block"))
    document.recompute()
    return [shape, text, slices, api.add_nest(document, [shape])]


def every_object() -> list[Any]:
    """Make an object for each panel."""
    milled = draw()
    turned = every_operation()
    tool, profile = turned.Tools[0], turned.Operations[1].OutList[1:2]
    return [*milled.values(), *drawn_objects(milled["job"].Document), turned, tool, *turned.Operations, *profile]


def every_panel(hand: Hand) -> Iterator[str]:
    """Open the panel of each kind of object with all its groups, one after the other, and give its name."""
    for obj in hand.main(every_object, limit_s=120):
        hand.main(panels.edit, obj)
        hand.wait(lambda: hand.exists(f"{PANEL}ok"), 20, "the panel")
        hand.main(unfold)
        hand.settle()
        yield hand.main(proxy_type, obj)
        hand.main(FreeCADGui.Control.closeDialog)
        hand.settle()


def preferences() -> Any:
    page = JobPreferences()
    page.loadSettings()
    page.form.show()
    FreeCAD.__cncstepper_page__ = page
    return page.form


def cut_question() -> Any:
    """Show how a G-code file is cut, on a table for two processes."""
    dialog = CutDialog("peça.nc", ["plasma", "oxyfuel"], CutChoice("plasma", "mild-steel", 6.0, size_mm=(300.0, 200.0)))
    dialog.show()
    return dialog


def name_of_a_template() -> Any:
    ask_to_save(draw()["job"])
    return places.find("CNCStepper_JobTemplate")


WINDOWS: tuple[Callable[[], Any], ...] = (
    open_help,
    cut_question,
    name_of_a_template,
    first_run.open_card,
    begin_tour,
    open_machines,
    open_libraries,
    open_assistant,
    open_comparison,
    open_letters,
    open_part_records,
    open_installation,
    preferences,
)


def every_dialog(hand: Hand) -> Iterator[tuple[str, Any]]:
    """Open each dialog, page by page, and give its name and widget."""
    for opened in WINDOWS:
        window = hand.main(opened)
        hand.wait(window.isVisible, 20, opened.__name__)
        hand.settle()
        for number in range(hand.main(pages_of, window)):
            hand.main(show_page, window, number)
            hand.settle()
            yield f"{hand.main(window.objectName)} {number + 1}", window
        hand.main(lambda window=window: (window.close(), window.deleteLater()))
        hand.settle()


def pages_of(window: Any) -> int:
    steps = window.findChild(QtGui.QListWidget, "CNCStepper_Assistant_steps")
    if steps is not None:
        return int(steps.count())
    return int(window.tabs.count()) if window.objectName() in TABBED else 1


def show_page(window: Any, number: int) -> None:
    steps = window.findChild(QtGui.QListWidget, "CNCStepper_Assistant_steps")
    if steps is not None:
        steps.setCurrentRow(number)
    elif window.objectName() in TABBED:
        window.tabs.setCurrentIndex(number)


def left_dock() -> Any:
    """Return the dock in which FreeCAD shows the tree and the panels."""
    docks = FreeCADGui.getMainWindow().findChildren(QtGui.QDockWidget)
    return next(each for each in docks if each.isVisible() and each.objectName() in ("Combo View", "Model", "Tasks"))


def grown(font: Any, scale: float) -> Any:
    found = QtGui.QFont(font)
    found.setPointSizeF(font.pointSizeF() * scale)
    return found


# The longer texts in the wider theme; CNCSTEPPER_ALL_LOOKS adds the others, which take a minute more.
LOOKS = [("pt-BR", "dark")]
if "CNCSTEPPER_ALL_LOOKS" in os.environ:
    LOOKS += [("English", ""), ("English", "dark"), ("pt-BR", "")]


@pytest.fixture(params=LOOKS, ids="-".join)
def looks(request: Any, hand: Hand) -> Iterator[None]:
    """The window in a language and a theme; afterwards it is in English, in the theme of before."""
    language, theme = request.param
    application = QtGui.QApplication.instance()
    before = hand.main(application.styleSheet)
    hand.main(FreeCADGui.setLocale, language)
    if theme:
        hand.main(application.setStyleSheet, DARK.read_text("utf-8") if DARK.exists() else PLAIN_DARK)
    yield
    hand.main(FreeCADGui.setLocale, "English")
    if theme:
        hand.main(application.setStyleSheet, before)


@pytest.fixture
def sizes(hand: Hand) -> Iterator[Callable[[float], None]]:
    """What lets letters, window and docks grow; afterwards the window fills the screen again."""
    window, application = FreeCADGui.getMainWindow(), QtGui.QApplication.instance()
    font = hand.main(lambda: QtGui.QFont(application.font()))
    hand.main(lambda: (window.showNormal(), window.resize(*SMALL_SCREEN)))
    hand.wait(lambda: window.width() <= SMALL_SCREEN[0], 10, "the small window")
    left = hand.main(left_dock)
    width, height = hand.main(left.width), hand.main(lambda: window.fontMetrics().height())

    def grow(scale: float) -> None:
        application.setFont(grown(font, scale))
        window.resize(*(round(scale * side) for side in SMALL_SCREEN))
        assert window.fontMetrics().height() >= round(0.9 * scale * height)
        window.resizeDocks([left], [round(scale * width)], QtCore.Qt.Orientation.Horizontal)

    yield grow
    hand.main(lambda: (grow(1.0), window.showMaximized()))
    hand.wait(lambda: window.width() > SMALL_SCREEN[0], 10, "the large window")


def cut_in_panel() -> list[str]:
    """Return what the open panel cuts."""
    heads = (each for each in places.all_widgets() if each.objectName().startswith(f"{PANEL}group_"))
    return cut_beside_buttons(places.area_around(next(each for each in heads if each.isVisible())))


def cut_beside_buttons(area: Any) -> list[str]:
    """Return what a panel's area cuts; as wide as FreeCAD's own OK and Cancel in its dark theme it may be."""
    buttons = places.widgets_around(places.find(f"{PANEL}ok"))[2]
    own_px = buttons.minimumSizeHint().width() + 2 * buttons.x() + FRAME_PX
    return places.cut_texts(area, max(0, own_px - area.viewport().width()))


def cut_at(hand: Hand, scale: float, cut: Callable[[], list[str]]) -> list[str]:
    """Return what is cut when letters have grown, once FreeCAD has laid all out anew."""
    hand.is_soon(lambda: not cut())
    return [f"at {scale:.0%}: {one}" for one in hand.main(cut)]


def test_no_panel_cuts_a_text(hand: Hand, looks: None, sizes: Callable[[float], None]) -> None:
    found = []
    for name in every_panel(hand):
        for scale in SCALES:
            hand.main(sizes, scale)
            hand.settle()
            found += [f"{name} {one}" for one in cut_at(hand, scale, cut_in_panel)]
        hand.main(sizes, 1.0)
    assert not found, "\n".join(found)


def lines_of_buttons(width_px: int) -> list[list[str]]:
    """Return the texts on a row of three buttons, line by line, when the row is so wide; none covers another."""
    row = ButtonRow(None)
    buttons = [row.add(QtGui.QPushButton(text)) for text in ("Add", "Take the selection", "Delete")]
    row.resize(width_px, row.heightForWidth(width_px))
    row.show()
    assert places.narrower_than_their_text(row) == []
    assert all(row.rect().contains(button.geometry()) for button in buttons)
    assert not any(one.geometry().intersects(two.geometry()) for one, two in combinations(buttons, 2))
    tops = sorted({button.y() for button in buttons})
    lines = [[button.text() for button in buttons if button.y() == top] for top in tops]
    row.deleteLater()
    return lines


def test_buttons_take_as_many_lines_as_they_need(hand: Hand) -> None:
    assert hand.main(lines_of_buttons, 600) == [["Add", "Take the selection", "Delete"]]
    assert hand.main(lines_of_buttons, 260) == [["Add", "Take the selection"], ["Delete"]]
    assert hand.main(lines_of_buttons, 150) == [["Add"], ["Take the selection"], ["Delete"]]


def test_no_dialog_cuts_a_text(hand: Hand, looks: None, sizes: Callable[[float], None]) -> None:
    found = []
    for name, window in every_dialog(hand):
        size = hand.main(window.size)
        for scale in SCALES:
            hand.main(sizes, scale)
            hand.main(window.resize, size * scale)
            hand.settle()
            found += [f"{name} {one}" for one in cut_at(hand, scale, partial(places.cut_texts, window))]
        hand.main(sizes, 1.0)
        hand.main(window.resize, size)
    assert not found, "\n".join(found)


def shown_area() -> Any:
    """Return the area in which FreeCAD shows a task that has no OK of ours."""
    names = ("CNCStepper_Simulation_panel", "CNCStepper_Restart_panel", f"{PANEL}Shapes", f"{PANEL}Template")
    return places.area_around(next(each for each in places.all_widgets() if each.objectName() in names))


def cut_at_sizes(hand: Hand, name: str, sizes: Callable[[float], None], cut: Callable[[], list[str]]) -> list[str]:
    """Return what is cut at each size of the letters, by the name of what cuts it."""
    found = []
    for scale in SCALES:
        hand.main(sizes, scale)
        hand.settle()
        found += [f"{name} {one}" for one in cut_at(hand, scale, cut)]
    hand.main(sizes, 1.0)
    hand.settle()
    return found


def test_simulation_and_restart_cut_no_text(
    hand: Hand,
    looks: None,
    sizes: Callable[[float], None],
    job: Any,  # noqa: F811
) -> None:
    simulation_of(hand, job)
    found = cut_at_sizes(hand, "simulation", sizes, lambda: places.cut_texts(shown_area()))
    hand.main(FreeCADGui.Control.closeDialog)
    hand.main(restart.open_restart, job, no_restart)
    hand.wait(lambda: places.find("CNCStepper_Restart_places").rows, 60, "the places")
    found += cut_at_sizes(hand, "restart", sizes, lambda: places.cut_texts(shown_area()))
    hand.main(FreeCADGui.Control.closeDialog)
    assert not found, "\n".join(found)


def test_gallery_and_template_cut_no_text(hand: Hand, looks: None, sizes: Callable[[float], None]) -> None:
    document = hand.main(FreeCAD.newDocument, "Shop")
    hand.main(open_gallery, print)
    hand.settle()
    found = cut_at_sizes(hand, "gallery", sizes, lambda: cut_beside_buttons(shown_area()))
    hand.main(FreeCADGui.Control.closeDialog)
    drawing = hand.main(api.import_drawing, document, SIGN)
    hand.main(open_template_panel, drawing)
    hand.wait(lambda: places.find(f"{PANEL}rules").topLevelItemCount(), 60, "the rules")
    found += cut_at_sizes(hand, "template", sizes, lambda: cut_beside_buttons(shown_area()))
    hand.main(FreeCADGui.Control.closeDialog)
    assert not found, "\n".join(found)


def test_the_dock_cuts_no_text(
    hand: Hand,
    looks: None,
    sizes: Callable[[float], None],
    dock: Any,  # noqa: F811
    job: Any,  # noqa: F811
) -> None:
    cut = partial(places.cut_texts, dock)
    found = cut_at_sizes(hand, "not connected", sizes, cut)
    hand.choose(f"{D}Speed", hand.main(lambda: tr("{0}× speed").format(10)))
    hand.click(f"{D}Connect")
    hand.wait(lambda: hand.find(f"{D}State").text() == tr("Idle"), 60, "the controller")
    found += cut_at_sizes(hand, "connected", sizes, cut)
    hand.main(FreeCADGui.Selection.addSelection, job)
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}ZeroAll") and tr("Work zero") in hand.text(f"{D}FlowTitle"), 60, "the work zero")
    found += cut_at_sizes(hand, "work zero", sizes, cut)
    assert not found, "\n".join(found)


def test_the_editor_cuts_no_text(hand: Hand, looks: None, sizes: Callable[[float], None], tmp_path: Path) -> None:
    path = tmp_path / "peça.nc"
    path.write_text("G21 G90\nT1 M3 S9000\nG0 X0 Y0 Z5\nG1 Z-1 F200\nG1 X40 Y\nM2\n", encoding="utf-8")
    panel = hand.main(editor.open_file, path).panel
    hand.wait(lambda: panel.reader.mark > 0 and hand.exists("CNCStepper_Editor_refusals"), 60, "the refusal")
    found = cut_at_sizes(hand, "editor", sizes, partial(places.cut_texts, panel))
    assert not found, "\n".join(found)
