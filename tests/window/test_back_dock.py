# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back along the cut from the dock, under a real hand: as it runs, forward, to the entry, resumed, refused, jogged."""

from __future__ import annotations

from typing import Any

from test_dock import LONGEST_MS, D, connected, dock, own_sessions, pocket, says, work_mm, zeroed  # noqa: F401

from window_helpers.hand import Hand

PLACE_S = 60.0  # a process is started and a program read


def begun(hand: Hand, dock: Any) -> None:  # noqa: F811
    """Send a pocket to the virtual machine and wait until it is well under way."""
    pocket(hand)
    connected(hand, "1× speed")
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Work zero" in hand.text(f"{D}FlowTitle"), 180, "the proof")
    zeroed(hand)
    hand.click(f"{D}Start")
    says(hand, "Running", 60)
    hand.wait(lambda: hand.find(f"{D}Progress").value() > 100 and dock.link.status.wpos_mm[2] < 0, 180, "the cut")


def told(hand: Hand, words: str) -> None:
    hand.wait(lambda: words in hand.text(f"{D}BackState"), PLACE_S, f"the sentence {words}")


def test_back_while_it_cuts_forward_and_on(hand: Hand, dock: Any) -> None:  # noqa: F811
    begun(hand, dock)
    assert not hand.main(hand.find(f"{D}Forward").isEnabled)
    with hand.watchdog() as watch:
        hand.click(f"{D}Back")
        says(hand, "Held")
        says(hand, "On its cut", PLACE_S)
        told(hand, "5.000 mm behind the end of the cut")
        hand.fill(f"{D}BackLength", "2")
        hand.click(f"{D}Forward")
        told(hand, "3.000 mm behind")
    print(watch)
    assert watch.max_cpu_ms < LONGEST_MS, watch
    hand.shot("dock-back")
    hand.click(f"{D}BackToEntry")
    told(hand, "The tool moves along the cut")
    hand.shot("dock-back-moving")
    hand.wait(lambda: hand.find(f"{D}BackToEntry").isEnabled(), PLACE_S)
    hand.fill(f"{D}BackLength", "9999")
    hand.click(f"{D}Forward")
    hand.wait(
        lambda: not hand.find(f"{D}Forward").isEnabled() and hand.find(f"{D}Back").isEnabled(), PLACE_S, "the end"
    )
    told(hand, "at the end of the cut")
    hand.click(f"{D}Resume")
    says(hand, "Running", PLACE_S)
    hand.click(f"{D}Stop")
    hand.wait(lambda: "Stopped" in hand.text(f"{D}FlowTitle"), PLACE_S)
    assert not hand.exists(f"{D}Back")


def test_a_hold_finds_the_place_and_a_line_that_is_not_cut_is_refused_in_words(hand: Hand, dock: Any) -> None:  # noqa: F811
    begun(hand, dock)
    hand.click(f"{D}Hold")
    says(hand, "Held")
    told(hand, "The tool is on line")
    hand.shot("dock-back-held")
    hand.fill(f"{D}BackLine", "99999")
    hand.click(f"{D}BackToLine")
    told(hand, "No move of line 99999 lies on the way back")
    assert "Refused: No move of line 99999" in hand.text(f"{D}Messages")
    hand.shot("dock-back-refused")
    hand.click(f"{D}Aside")
    says(hand, "On its cut", PLACE_S)
    hand.wait(lambda: hand.find(f"{D}JogZPlus").isEnabled(), PLACE_S, "a machine that can be jogged")
    stood_mm = work_mm(hand, "Z")
    hand.click(f"{D}JogZPlus")
    hand.wait(lambda: work_mm(hand, "Z") > stood_mm + 0.9 and not hand.find(f"{D}Hold").isEnabled(), PLACE_S, "the jog")
    hand.click(f"{D}Resume")
    says(hand, "Running", PLACE_S)
    told(hand, "exactly the path")
