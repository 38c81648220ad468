# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an order takes and costs: sheets, metres, pierces, hours of each row, by the rates of the machine's profile.

A sheet's hours, metres and costs are shared among its rows by the length of their lines, its pierces by the number of
their lines, its material by the same as its hours. The sums are those of the proven programs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from CNCStepper.job.batch.run_batch import BatchResult, MadeSheet
from CNCStepper.machine.profile import Rates

MM_IN_METRE = 1000.0
MM2_IN_SQUARE_METRE = 1e6
S_IN_HOUR = 3600.0


@dataclass
class Figures:
    """Sums of a row, a sheet or an order.

    cost: None where a machine has no rates, and where there are several currencies, as in "EUR, BRL".
    """

    parts: int = 0
    sheets: float = 0.0
    metres: float = 0.0
    pierces: float = 0.0
    hours: float = 0.0
    cost: float | None = 0.0
    currency: str = ""

    def add(self, other: Figures, share: float = 1.0, pierce_share: float = 1.0) -> None:
        """Add shares of other figures; parts are not shared."""
        self.sheets += share * other.sheets
        self.metres += share * other.metres
        self.pierces += pierce_share * other.pierces
        self.hours += share * other.hours
        currencies = dict.fromkeys(filter(None, [*self.currency.split(", "), *other.currency.split(", ")]))
        self.currency = ", ".join(currencies)
        is_sum = self.cost is not None and other.cost is not None and len(currencies) < 2
        self.cost = self.cost + share * other.cost if is_sum else None  # type: ignore[operator]


def figures_of(sheet: MadeSheet) -> Figures:
    """Return what one sheet takes and costs."""
    told = sheet.result
    rates = Rates.model_validate(told["rates"]) if told["rates"] else None
    figures = Figures(
        parts=sum(sheet.rows.values()),
        sheets=1.0,
        metres=told["length_mm"] / MM_IN_METRE,
        pierces=told["pierces"],
        hours=told["time_s"] / S_IN_HOUR,
        cost=None,
    )
    if rates is not None:
        square_metres = told["area_mm2"] / MM2_IN_SQUARE_METRE
        figures.currency = rates.currency
        figures.cost = (
            rates.per_hour * figures.hours
            + rates.per_metre * figures.metres
            + rates.per_pierce * figures.pierces
            + rates.per_sheet
            + rates.square_metre_of(told["material"]) * square_metres
        )
    return figures


def row_figures(result: BatchResult) -> list[Figures]:
    """Return the figures of each row, in their order; those of a refused row are 0."""
    rows = [Figures() for _ in result.rows]
    for sheet in result.sheets:
        if sheet.error is not None:
            continue
        whole = figures_of(sheet)
        lengths = _shares(sheet, [reads["length_mm"] for reads in _reads(result, sheet)])
        counts = _shares(sheet, [reads["chains"] for reads in _reads(result, sheet)])
        for number, length, count in zip(sheet.rows, lengths, counts, strict=True):
            rows[number].parts += sheet.rows[number]
            rows[number].add(whole, length, count)
    return rows


def _reads(result: BatchResult, sheet: MadeSheet) -> list[dict[str, float]]:
    return [result.reads[number] for number in sheet.rows]


def _shares(sheet: MadeSheet, each: Sequence[float]) -> list[float]:
    """Return the share of each row, of the value of one part and the number of parts."""
    values = [value * count for value, count in zip(each, sheet.rows.values(), strict=True)]
    total = sum(values)
    return [value / total if total else 1.0 / len(values) for value in values]  # points have no length


def total_figures(result: BatchResult) -> Figures:
    """Return the sums of all sheets that were made."""
    total = Figures()
    for sheet in result.sheets:
        if sheet.error is None:
            figures = figures_of(sheet)
            total.parts += figures.parts
            total.add(figures)
    return total
