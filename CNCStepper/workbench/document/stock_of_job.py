# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stock of a job object, as the core's own and as a job file says it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from CNCStepper.errors import JobError

if TYPE_CHECKING:
    from CNCStepper.simulation.stock import Stock

CYLINDER = "cylinder"
FORMS = ("box", "sheet", CYLINDER)


def size_mm(job: Any) -> tuple[float, float, float]:
    """Return the size of the box around the stock; a cylinder's diameter stands where a box has its length."""
    length, width, height = job.StockSize
    return length, length if job.StockForm == CYLINDER else width, height


def stock_of(job: Any) -> Stock:
    """Return the stock in work coordinates; raises JobError for one without a size."""
    from CNCStepper.simulation.stock import Cylinder, Stock

    kind = Cylinder if job.StockForm == CYLINDER else Stock
    return kind(size_mm(job), job.StockOrigin)


def stock_content(job: Any) -> dict[str, Any]:
    """Return the `[stock]` table of a job file; raises JobError for a margin that none can be."""
    edge_mm = float(job.EdgeMargin)
    if edge_mm < 0:
        raise JobError("stock-edge", "edge_mm must not be below zero", advice="write 0 where the edge does not matter")
    return {
        "form": job.StockForm,
        "size_mm": size_mm(job),
        "origin": job.StockOrigin,
        "edge_mm": edge_mm or None,
    }
