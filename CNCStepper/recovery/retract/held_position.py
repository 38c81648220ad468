# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where on its way a held program's tool is: by the reports, or by the leg on which it was held."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from CNCStepper.control.stream.path_retract import REST
from CNCStepper.job.start_state_file import start_from
from CNCStepper.recovery.retract.held_session import SessionContext, read_lines
from CNCStepper.recovery.retract.path import Place, RetractPath
from CNCStepper.recovery.retract.path_search import PositionReport, PossiblePlaces, find


def acknowledged(leg: Mapping[str, Any] | None, reports: Sequence[PositionReport]) -> int:
    """Return how many of the program's own lines the controller has acknowledged, in this leg or before."""
    now = reports[-1].acknowledged if reports else 0
    if leg is None:
        return now
    again = leg["then"] + now - _own(leg) if leg["kind"] == REST else 0
    return max(int(leg["reached"]), again)


def found_of(
    ground: SessionContext, way: RetractPath, told: Mapping[str, Any], reports: Sequence[PositionReport]
) -> tuple[PossiblePlaces, bool]:
    """Return where on the program's way the tool is, and whether it was jogged from there and is not surely back.

    way: of the motors, whose places are reported. Raises ProgramError where the machine does not stand on it.
    """
    leg = told["leg"]
    if leg is None:
        return find(way, reports, ground.controller), told["jogged"]
    if told["stands"]:
        end = Place(*leg["end"])
        return PossiblePlaces(end, end), told["jogged"]
    start = start_from(leg["certificate"]["start"]["state"])
    leg_way = RetractPath(read_lines(told["leg_lines"], start, ground.dialect).toolpath())
    on_leg = find(leg_way, reports, ground.controller)
    places = [_on_program(place, leg_way, way, leg) for place in on_leg]
    return PossiblePlaces(min(places), max(places)), any(_is_beside(place, leg_way, leg) for place in on_leg)


def _own(leg: Mapping[str, Any]) -> int:
    """Return how many lines of a leg are not the program's."""
    return int(leg["heads"]) + len(leg["parts"]) + (leg["kind"] == REST)


def _part(place: Place, leg_way: RetractPath, leg: Mapping[str, Any]) -> int:
    """Return the number of the line that moves along a place of a leg, from 0 behind its head."""
    return int(leg_way.lines[place.row]) - 1 - int(leg["heads"])


def _is_beside(place: Place, leg_way: RetractPath, leg: Mapping[str, Any]) -> bool:
    """Return whether a place of a leg is on its way back from where somebody jogged to."""
    part = _part(place, leg_way, leg)
    return part < len(leg["parts"]) and leg["parts"][part] is None


def _on_program(place: Place, leg_way: RetractPath, way: RetractPath, leg: Mapping[str, Any]) -> Place:
    """Return the place of the program that a place of a leg is, or leads to."""
    if _is_beside(place, leg_way, leg):
        return Place(*leg["begin"])
    part, line = _part(place, leg_way, leg), int(leg_way.lines[place.row])
    if part < len(leg["parts"]):
        row, begin, end = leg["parts"][part]
        return Place(int(row), begin + (end - begin) * place.share)
    rows = way.rows_of(int(leg["then"]) + line - _own(leg))
    return Place(rows[place.row - leg_way.rows_of(line)[0]], place.share)
