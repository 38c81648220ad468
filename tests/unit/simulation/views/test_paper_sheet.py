# SPDX-License-Identifier: LGPL-2.1-or-later
"""The printed sheet: nothing runs off the paper, and every kind of program has its picture."""

from __future__ import annotations

from pathlib import Path

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.views import paper_sheet as sheets
from CNCStepper.simulation.views.paper_sheet import Sheet
from CNCStepper.simulation.views.path_lines import LATHE, drawn_path

LONG = "peça com um nome muito comprido que ninguém mais sabe o que quer dizer, lado esquerdo, segunda fixação.nc"
PLATE = "G21 G90\nG0 X0 Y0\nG1 X80 F1000\nY30\nG3 X60 Y50 I-20 J0\nG1 X0\nY0\nM2\n"
TALL = "G21 G90\nG0 X0 Y0\nG1 Y300 F100\nX5\nM2\n"
LATHED = "G21 G90 G18\nG0 X12 Z2\nG1 Z-30 F100\nX14\nG0 Z2\nM2\n"


def first_page(text: str, title: str = "part.nc", facts: tuple = (("File", "part.nc"),), stock=None) -> Figure:
    """Return the first page, drawn."""
    figure = next(sheets._pages(Sheet(title, facts, text, interpret(text, None, "linuxcnc"), stock)))
    FigureCanvasAgg(figure).draw()
    return figure


def words(figure: Figure) -> list[str]:
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


@pytest.mark.slow
@pytest.mark.parametrize("text", [PLATE, TALL, LATHED])
@pytest.mark.parametrize("title", ["part.nc", LONG, "W" * 100])
def test_nothing_runs_off_the_paper_or_over_another(text: str, title: str) -> None:
    facts = (("File", f"/home/oficina/{title}"), ("Material", LONG), ("Process", "milling"))
    figure = first_page(text, title, facts, Stock((100, 70, 20)))
    paper = figure.bbox
    boxes = [one.get_window_extent() for one in [*figure.texts, *figure.legends]] + [figure.axes[0].get_tightbbox()]
    for number, box in enumerate(boxes):
        assert paper.x0 <= box.x0 and box.x1 <= paper.x1 and paper.y0 <= box.y0 and box.y1 <= paper.y1
        assert not any(box.overlaps(other) for other in boxes[:number])


def test_the_picture_stands_below_the_facts_and_is_to_scale() -> None:
    figure = first_page(PLATE)
    axes = figure.axes[0]
    box = axes.get_window_extent()
    lowest = min(
        text.get_window_extent().y0
        for text in figure.texts
        if text.get_text() == "part.nc" and text.get_position()[1] > 0.5
    )
    assert 0 < lowest - box.y1 < figure.dpi
    per_mm = (
        box.width / (axes.get_xlim()[1] - axes.get_xlim()[0]),
        box.height / (axes.get_ylim()[1] - axes.get_ylim()[0]),
    )
    assert per_mm[0] == pytest.approx(per_mm[1])


def test_a_narrow_picture_is_widened_for_its_numbers() -> None:
    box = first_page(TALL).axes[0].get_window_extent()
    assert box.width == pytest.approx(box.height / 4, rel=1e-6)


def test_a_table_without_z_and_a_lathe_without_y_are_drawn() -> None:
    flat = first_page(PLATE)
    assert {"feed", "arc"} <= set(words(flat)) and flat.axes[0].get_xlabel() == "X (mm)"
    lathe = first_page(LATHED, stock=Stock((20, 20, 40)))
    assert (lathe.axes[0].get_xlabel(), lathe.axes[0].get_ylabel()) == ("Z (mm)", "X (mm)")
    assert {"feed", "rapid", "stock", "work zero"} <= set(words(lathe)) and "plunge" not in words(lathe)
    assert len(drawn_path(interpret(LATHED, None, "linuxcnc"), LATHE).feeds) == 1


@pytest.mark.parametrize("text", ["M2\n", "(only words)\nM2\n", "G21 G90\nG0 Z5\nM2\n"])
def test_a_program_that_draws_nothing_has_no_empty_picture(text: str, tmp_path: Path) -> None:
    figure = first_page(text)
    assert not figure.axes and not figure.legends
    toolpath = interpret(text, None, "linuxcnc")
    for name in ("sheet.pdf", "sheet.html"):
        sheets.save_sheet(tmp_path / name, Sheet("part.nc", (), text, toolpath))
        assert (tmp_path / name).stat().st_size > 500
