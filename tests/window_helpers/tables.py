# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells of the tables of tools, materials and charts, typed into by real keys."""

from __future__ import annotations

from typing import Any

from window_helpers.hand import Hand


def cell(page: Any, row: int, key: str) -> Any:
    keys = [column.key for column in page.draft.library.columns]
    return page.model.index(row, keys.index(key))


def put(hand: Hand, page: Any, row: int, key: str, text: str) -> None:
    """Type into a cell as a person does, with F2."""

    def begin() -> None:
        page.table.setCurrentIndex(cell(page, row, key))
        page.table.scrollTo(cell(page, row, key))
        page.table.setFocus()

    hand.main(begin)
    hand.key("F2")
    hand.settle()
    hand.type(text)
    hand.key("Return")
    hand.wait(lambda: page.draft.table[row].texts[key] == text, 5, f"{text} in {key}")
