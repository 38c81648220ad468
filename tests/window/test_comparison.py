# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two programs are compared by clicks: a job's own against a file, two files, a lathe's; picture, figures, refusal."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.document.job_files import open_job
from window_helpers import screen_places as places
from window_helpers.hand import Hand

C = "CNCStepper_Comparison"
JOBS = Path(__file__).parents[2] / "examples" / "jobs"
COMPARED_S = 240  # the first comparison may compile kernels


def widget(name: str) -> Any:
    return FreeCADGui.getMainWindow().findChild(QtGui.QWidget, name)


def new_job() -> Any:
    document = FreeCAD.newDocument("Compare")
    job = api.new_job(document, machine="table-a", stock_size_mm=(100, 70, 20), work_origin_mm=(50, 35, 0))
    cutter = api.add_tool(job, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=10000)
    api.add_elliptical_pocket(job, tool=cutter, radius_x_mm=30, radius_y_mm=22, depth_mm=2, stepdown_mm=2)
    document.recompute()
    return job


def new_shaft() -> Any:
    document = FreeCAD.newDocument("Shaft")
    job, _ = open_job(document, JOBS / "lathe-cylinder.toml")
    document.recompute()
    return job


def _menu_text() -> str:
    return str(FreeCADGui.Command.get("CNCStepper_Compare").getAction()[0].text().replace("&", "").rstrip("…"))


@pytest.fixture
def window(hand: Hand) -> Iterator[Any]:
    hand.menu("CNCStepper", hand.main(_menu_text))
    hand.wait(lambda: widget(C) and widget(C).isVisible(), what="the window")
    hand.settle()
    yield widget(C)
    hand.main(lambda: (widget(C).close(), widget(C).deleteLater()))
    hand.settle()


@pytest.fixture
def job(hand: Hand) -> Any:
    return hand.main(new_job)


@pytest.fixture
def shaft(hand: Hand, job: Any) -> Any:
    """A lathe's job beside the mill's."""
    return hand.main(new_shaft, limit_s=COMPARED_S)


def choose_file(hand: Hand, which: str, path: Path) -> None:
    hand.click(f"{C}_{which}_file")
    hand.wait(lambda: _dialogs(), what="the file dialog")
    hand.main(lambda: _dialogs()[0].findChild(QtGui.QLineEdit).setText(str(path)))
    hand.key("Return")
    hand.wait(lambda: not _dialogs(), what="the dialog to close")


def _dialogs() -> list[Any]:
    windows = QtGui.QApplication.topLevelWidgets()
    return [one for one in windows if isinstance(one, QtGui.QFileDialog) and one.isVisible()]


def compare(hand: Hand, window: Any) -> Any:
    before = window.answer
    hand.click(f"{C}_compare")
    hand.wait(lambda: window.answer is not before or window.note.isVisible(), COMPARED_S, "the comparison")
    hand.settle()
    return window.answer


@pytest.mark.window("plain", "portuguese")
def test_a_jobs_program_is_compared_with_a_file(hand: Hand, job: Any, window: Any, tmp_path: Path) -> None:
    text = hand.main(program_file.load, job)
    changed = tmp_path / "changed.nc"
    changed.write_text(text.replace("Z-2.000", "Z-1.500"), encoding="utf-8")
    place = next(at for at, line in enumerate(text.splitlines(), start=1) if "Z-2.000" in line and "(" not in line)
    assert hand.main(lambda: (window.sources[0].currentData(), window.button.isEnabled())) == (job, False)
    choose_file(hand, "second", changed)
    answer = compare(hand, window)
    assert not answer["same"], hand.text(f"{C}_words")
    assert answer["report"]["first_difference"]["path"] == [place, place]
    assert answer["report"]["part"]["deepest_mm"] == pytest.approx(0.2, abs=1e-4)  # the roughing reaches Z-1.8
    assert hand.main(window.figures.rowCount) == len(answer["rows"])
    assert hand.main(lambda: len(window.picture.scene().items())) == 1
    hand.shot("comparison")
    assert hand.main(places.narrower_than_their_text, window) == []
    picture = tmp_path / "both.png"
    hand.click(f"{C}_save")
    hand.wait(lambda: widget(f"{C}_save_file") and widget(f"{C}_save_file").isVisible(), what="the file dialog")
    hand.main(widget(f"{C}_save_file").findChild(QtGui.QLineEdit).setText, str(picture))
    hand.key("Return")
    hand.wait(picture.exists, 5, "the picture")


@pytest.mark.window("plain", "portuguese")
def test_a_lathes_program_is_compared_by_its_diameters_and_with_no_mills(
    hand: Hand, job: Any, shaft: Any, window: Any, tmp_path: Path
) -> None:
    text = hand.main(program_file.load, shaft)
    thinner = tmp_path / "thinner.nc"
    thinner.write_text(text.replace("X-7.5000", "X-7.5500"), encoding="utf-8")  # from the start at X32.5
    hand.choose(f"{C}_first", hand.main(lambda: window.sources[0].itemText(window.sources[0].findData(shaft))))
    choose_file(hand, "second", thinner)
    answer = compare(hand, window)
    assert answer is not None, hand.text(f"{C}_error")
    (ring,) = answer["report"]["part"]["rings"]
    assert ring["diameters_mm"] == pytest.approx([49.9, 50], abs=1e-6) and not ring["first"]
    name, *values = answer["rows"][-1]
    assert values == ["ø50.000", "ø49.900"] and "diameter at Z-" in name
    shown = hand.main(lambda: [window.figures.item(window.figures.rowCount() - 1, at).text() for at in (1, 2)])
    assert [each.replace(",", ".") for each in shown] == values
    assert "ø49" in hand.text(f"{C}_words")
    words = hand.main(window._question)["words"]
    assert (words["second"], words["rapid"]) in (
        ("only in {name}", "rapid moves"),
        ("só em {name}", "movimentos rápidos"),
    )
    hand.shot("comparison-lathe")
    assert hand.main(places.narrower_than_their_text, window) == []
    hand.choose(f"{C}_second", hand.main(lambda: window.sources[1].itemText(window.sources[1].findData(job))))
    assert compare(hand, window) is answer
    assert hand.main(lambda: job.Label) in hand.text(f"{C}_error")
    hand.shot("comparison-refused")


def test_two_files_are_the_same_and_a_bad_one_is_refused(hand: Hand, window: Any, tmp_path: Path) -> None:
    text = "G21 G90 F300\nM3 S1000\nG0 X0 Y0 Z5\nG1 Z-1\nG1 X40\nG0 Z5\nM2\n"
    for name, content in (("a.nc", text), ("b.nc", text.replace("G1 X40", "(on)\nX30\nX40")), ("bad.nc", "G1 X\n")):
        (tmp_path / name).write_text(content)
    choose_file(hand, "first", tmp_path / "a.nc")
    choose_file(hand, "second", tmp_path / "b.nc")
    answer = compare(hand, window)
    assert answer["same"] and answer["sentences"] == ["the motion is the same"]
    hand.fill(f"{C}_tolerance", "0.5")
    choose_file(hand, "second", tmp_path / "bad.nc")
    assert compare(hand, window) is answer
    assert "bad.nc" in hand.text(f"{C}_error")
    choose_file(hand, "first", tmp_path / "bad.nc")
    for which, name in (("first", "a.nc"), ("second", "b.nc")):
        hand.choose(f"{C}_{which}", name)
    assert compare(hand, window)["same"]
    hand.item(f"{C}_figures", hand.main(lambda: window.figures.item(1, 0).text()))
    assert hand.main(window.figures.currentRow) == 1
