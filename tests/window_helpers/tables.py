# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tabs, and the cells and buttons of the tables of tools, materials and charts, by real clicks and keys."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from window_helpers.file_dialogs import choose_file
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


def click_tab(hand: Hand, tabs: Any, number: int) -> None:
    """Click a tab of a QTabWidget."""
    middle = hand.main(lambda: tabs.tabBar().tabRect(number).center())
    hand.click(hand.main(tabs.tabBar), at=(middle.x(), middle.y()))
    hand.wait(lambda: tabs.currentIndex() == number, what="the tab")
    hand.settle()


def click_cell(hand: Hand, view: Any, row: int, column: int) -> None:
    """Click a cell of a table."""

    def middle() -> tuple[int, int]:
        view.scrollTo(view.model().index(row, column))
        rect = view.visualRect(view.model().index(row, column))
        return rect.center().x(), rect.center().y()

    hand.click(hand.main(view.viewport), at=hand.main(middle))
    hand.wait(lambda: (view.currentIndex().row(), view.currentIndex().column()) == (row, column), 5, "the cell")


def rows_by_buttons(hand: Hand, page: Any, folder: Path) -> None:
    """Add, copy and delete rows, write the first row, search, and read what was written: a row more than before."""
    name, file = page.name, folder / f"{page.name}{page.draft.library.ENDINGS[0]}"
    count = len(page.draft.table)

    def press(button: str, rows: int) -> None:
        hand.click(f"{name}_{button}")
        hand.wait(lambda: len(page.draft.table) == rows, 5, f"{rows} rows after {button}")

    for button in ("add", "duplicate"):
        click_cell(hand, page.table, 0, 0)
        press(button, count + 1)
        press("delete", count)
    click_cell(hand, page.table, 0, 0)
    hand.click(f"{name}_export")
    choose_file(hand, f"{name}_file", file)
    hand.wait(file.is_file, 5, "the file")
    hand.fill(f"{name}_search", "no such row")
    hand.wait(lambda: page.model.rowCount() == 0, 5, "nothing to be found")
    hand.click(f"{name}_import")
    choose_file(hand, f"{name}_file", file)
    hand.wait(lambda: page.model.rowCount() == count + 1, 5, "the row of the file")
