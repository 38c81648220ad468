# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrow keys of the dock's console."""

from __future__ import annotations

from CNCStepper.workbench.dock.model.command_history import KEPT, History


def typed(*lines: str) -> History:
    history = History()
    for line in lines:
        history.add(line)
    return history


def test_lines_come_back_the_newest_first_and_what_was_begun_last() -> None:
    history = typed("$$", "$#", "G0 X1")
    assert [history.older("G1"), history.older("G0 X1"), history.older("$#")] == ["G0 X1", "$#", "$$"]
    assert history.older("$$") == "$$"
    assert [history.newer("$$"), history.newer("$#"), history.newer("G0 X1")] == ["$#", "G0 X1", "G1"]
    assert history.newer("G1") == "G1"


def test_where_nothing_was_typed_what_is_begun_stays() -> None:
    assert History().older("G1") == "G1" and History().newer("G1") == "G1"


def test_a_line_that_is_sent_again_is_kept_once_and_old_ones_go() -> None:
    history = typed("$$", "$#", "$#")
    assert [history.older(""), history.older("$#")] == ["$#", "$$"]
    history = typed(*map(str, range(KEPT + 5)))
    for _ in range(KEPT + 5):
        first = history.older("")
    assert first == "5"
