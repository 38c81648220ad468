# SPDX-License-Identifier: LGPL-2.1-or-later
"""A service and its jobs at a virtual board of each firmware, and what is compared there before a send."""

from __future__ import annotations

import pytest

from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl.firmware import FIRMWARES, FLUIDNC, GRBL, GRBLHAL
from CNCStepper.virtual.grbl.settings import INCHES
from helpers.control.service_bench import Visit

LINES = ("G17G21G90G94", "G1X-3F1500", "G1X-1Y-2")
EXPECTED = expected_settings(load_machine("table-a"))


def at_zero(visit: Visit):
    visit.ask("set_zero", axes="XYZ")
    yield lambda: visit.service.status().position_known is True


def warnings(visit: Visit) -> list[str]:
    return [text for kind, text in visit.told if kind == "warning" and "restarted" not in text]


@pytest.mark.parametrize("firmware", FIRMWARES.values(), ids=lambda firmware: firmware.name)
def test_job_is_compared_and_cut_without_a_word_of_warning(tmp_path, firmware):
    visit = Visit(tmp_path, firmware=firmware)
    start = dict.fromkeys(("G54", "G92", "G28"), (0.0, 0.0, 0.0))

    def person():
        yield from at_zero(visit)
        visit.job(*LINES, expected=EXPECTED, work_offsets_mm=start, work_system="G54")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].done and not warnings(visit) and not visit.refused
    assert visit.table.x_mm() == pytest.approx(-1.0, abs=0.02)


@pytest.mark.parametrize("firmware", [GRBL, GRBLHAL], ids=lambda firmware: firmware.name)
def test_reports_in_inches_are_understood_everywhere(tmp_path, firmware):
    visit = Visit(tmp_path, firmware=firmware, settings={INCHES: 1.0})
    seen = []

    def person():
        yield from at_zero(visit)
        visit.job(*LINES, expected=EXPECTED, work_offsets_mm={"G54": (0.0, 0.0, 0.0)}, work_system="G54")
        yield visit.ended()
        visit.ask("jog", x_mm=-10.0, y_mm=0.0)
        yield visit.at("jogging")
        yield visit.at("idle")
        seen.append(visit.service.status().wpos_mm)

    visit.receive(person)
    assert visit.outcomes[0].done
    assert seen[0] == pytest.approx((-11.0, -2.0, 0.0), abs=0.02)


@pytest.mark.parametrize(
    ("settings", "words"),
    [({30: 1000.0}, "$30 is 1000, wanted 24000"), ({32: 1.0}, "$32 is 1, wanted 0"), ({100: 81.0}, "$100 is 81")],
)
@pytest.mark.parametrize("firmware", [GRBL, FLUIDNC], ids=lambda firmware: firmware.name)
def test_other_settings_are_shown_and_refuse(tmp_path, firmware, settings, words):
    visit = Visit(tmp_path, firmware=firmware, settings=settings)

    def person():
        visit.job(*LINES, expected=EXPECTED)
        yield visit.ended()

    visit.receive(person)
    error = visit.outcomes[0].error
    assert error.code == "settings-differ" and words in str(error)
    assert any(words in text for text in warnings(visit))


def test_all_differences_are_shown_where_one_refuses(tmp_path):
    visit = Visit(tmp_path, settings={30: 1000.0})

    def person():
        visit.job("G1X-3F1500", expected=EXPECTED, work_offsets_mm={"G54": (1.0, 0.0, 0.0)}, work_system="G55")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].error.code == "settings-differ"
    assert [text.split(" ")[0] for text in warnings(visit)] == ["$30", "G55", "G54"]


@pytest.mark.parametrize(
    ("wanted", "system", "words"),
    [
        ({"G54": (0.0, 0.0, -5.0)}, "G54", "G54 is"),
        ({"G28": (-9.0, 0.0, 0.0)}, "G54", "G28 is"),
        ({"G92": (0.0, 1.0, 0.0)}, "G54", "G92 is"),
        ({}, "G55", "G55 is not the work system in force"),
    ],
)
def test_another_start_state_is_shown_and_refuses(tmp_path, wanted, system, words):
    visit = Visit(tmp_path, firmware=GRBLHAL)

    def person():
        visit.job(*LINES, work_offsets_mm=wanted, work_system=system)
        yield visit.ended()

    visit.receive(person)
    error = visit.outcomes[0].error
    assert error.code == "start-differs" and words in str(error)


def test_positions_are_not_told_before_their_units_are_known(tmp_path):
    visit = Visit(tmp_path, settings={INCHES: 1.0})
    board = visit.table.board
    board.receive(b"G1X-10F1500\n")
    for _ in range(20):
        board.advance(0.01)
    board.take_output()
    seen = []

    def person():
        seen.append(visit.service.status())
        yield lambda: visit.service.status().mpos_mm is not None
        seen.append(visit.service.status())

    visit.receive(person)
    assert seen[0].machine_state == "Run" and seen[0].mpos_mm is None and seen[0].feed_mm_min is None
    assert seen[1].machine_state == "Idle" and seen[1].mpos_mm[0] == pytest.approx(-10.0, abs=0.02)
