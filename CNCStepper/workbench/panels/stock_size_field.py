# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field of the stock's size: three lengths, of a cylinder its diameter and height."""

from __future__ import annotations

from CNCStepper.workbench.document.stock_of_job import CYLINDER
from CNCStepper.workbench.panels.fields import VectorField
from CNCStepper.workbench.services.translation import tr


class StockSizeField(VectorField):
    """The width along Y is not asked of a cylinder; it is kept for the next box."""

    def refresh(self) -> None:
        """Show what the form that is chosen needs."""
        round_one = self.obj.StockForm == CYLINDER
        self.editors[1].setVisible(not round_one)
        self.label.setText(tr("Diameter and height") if round_one else tr(self.entry.label))
        super().refresh()
