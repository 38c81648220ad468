# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long ways at bounded engagement may be: parallels counted exactly, and what is refused with which advice."""

from __future__ import annotations

import math
import re

import pytest

from CNCStepper.cycles.clearing.engagement.cut_length import LONGEST, Length, parallels_mm, require_short
from CNCStepper.cycles.clearing.pattern import Area
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import from_points
from CNCStepper.geometry.region import Region

TOOL_MM = 3.0
STEPOVER_MM = 1.5  # 60 degrees


def _channel(half_mm: float) -> Area:
    room = Region.of([from_points([(0, 0), (400, 0), (400, 2 * half_mm), (0, 2 * half_mm)], closed=True)])
    return Area(room, TOOL_MM, STEPOVER_MM, 0.01, True)


def _least(area: Area, half_mm: float, apart_mm: float = STEPOVER_MM) -> Length:
    """Return the least length of a way through a channel: all its material at a stepover's area a millimetre."""
    cut_mm = 400.0 * 2.0 * (TOOL_MM + half_mm) / apart_mm
    return Length(cut_mm, parallels_mm(area.room, apart_mm, 0.01), apart_mm)


def test_parallels_are_counted_until_the_room_is_empty():
    room = Region.of([from_points([(0, 0), (10, 0), (10, 4), (0, 4)], closed=True)])
    assert parallels_mm(room, 1.5, 0.01) == pytest.approx(28.0 + 16.0)


def test_channels_wider_than_the_tool_by_its_radius_on_each_side_can_be_cleared_at_60_degrees_and_others_not():
    wide, slim = _channel(3.3), _channel(2.7)
    require_short(wide, [_least(wide, 3.3)])
    with pytest.raises(CycleError) as refused:
        require_short(slim, [_least(slim, 2.7)])
    assert refused.value.code == "engagement-long"
    assert (refused.value.value, refused.value.limit) == ("1.89 times", f"at most {LONGEST} times")


def test_at_the_engagement_that_is_advised_the_same_channel_is_accepted():
    area = _channel(2.7)
    with pytest.raises(CycleError) as refused:
        require_short(area, [_least(area, 2.7)])
    told = re.search(r"engagement_max_deg of (\d+) or more", refused.value.advice)
    assert told
    apart_mm = TOOL_MM * (1.0 - math.cos(math.radians(int(told[1]))))
    assert STEPOVER_MM < apart_mm < TOOL_MM
    require_short(area, [_least(area, 2.7, apart_mm)])


def test_all_rooms_of_a_pocket_count_together_and_no_room_is_no_fault():
    area = _channel(2.0)
    require_short(area, [Length(170.0, 100.0, 1.5), Length(140.0, 100.0, 1.5)])
    require_short(area, [])
    with pytest.raises(CycleError):
        require_short(area, [Length(170.0, 100.0, 1.5), Length(160.0, 100.0, 1.5)])
