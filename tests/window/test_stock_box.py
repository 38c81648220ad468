# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stock of a job is seen in the 3D view, follows the job's values, and is there again in an opened document."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest

from CNCStepper.workbench import api
from window_helpers.hand import Hand


def box(job: Any) -> tuple[float, ...]:
    """Return the bounds of what the job draws, x0 y0 z0 x1 y1 z1."""
    import pivy.coin as coin

    look = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(100, 100))
    look.apply(job.ViewObject.RootNode)
    bounds = look.getBoundingBox()
    return tuple(value for corner in (bounds.getMin(), bounds.getMax()) for value in corner.getValue())


def new_job() -> Any:
    job = api.new_job(FreeCAD.newDocument("Stock"), stock_size_mm=(80, 60, 10), work_origin_mm=(5, 0, 2))
    job.Document.recompute()
    return job


def test_the_stock_is_drawn_round_the_work_zero(hand: Hand) -> None:
    job = hand.main(new_job)
    assert hand.main(box, job) == pytest.approx((-35, -30, -8, 45, 30, 2))
    hand.main(lambda: api.edit(job, stock_origin="top-left-front", stock_size_mm=(40, 30, 5)))
    assert hand.main(box, job) == pytest.approx((3, -2, -3, 45, 30, 2))  # the cross reaches 2 mm beyond the corner
    hand.main(lambda: setattr(job, "StockSize", (0, 30, 5)))
    assert hand.main(lambda: job.ViewObject.RootNode is not None)


def test_an_opened_document_shows_it_again(hand: Hand, tmp_path: Path) -> None:
    job = hand.main(new_job)
    file = str(tmp_path / "chapa ç.FCStd")
    hand.main(job.Document.saveAs, file)
    hand.main(FreeCAD.closeDocument, job.Document.Name)
    opened = hand.main(FreeCAD.openDocument, file)
    (job,) = hand.main(lambda: [each for each in opened.Objects if each.Name.startswith("CNCStepper_Job")])
    assert hand.main(box, job) == pytest.approx((-35, -30, -8, 45, 30, 2))
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    hand.shot("stock")
