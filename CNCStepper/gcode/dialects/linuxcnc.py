# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC as its stand-alone interpreter `rs274` accepts it."""

from math import sqrt

from CNCStepper.canned_cycle_expansion import CYCLE_NAMES
from CNCStepper.gcode.dialects.codes import CYCLES, MORE_REPEATS, RS274
from CNCStepper.gcode.dialects.definition import ArcRule, Dialect, Writing, same_advice
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID

_SLACK_MM, _SLACK_INCH = 0.02 * sqrt(2), 0.002 * sqrt(2)  # as measured on rs274 2.9; they differ by unit
_SMALLEST_MM, _SMALLEST_INCH = 0.00127, 0.00005

LINUXCNC = Dialect(
    name="linuxcnc",
    compensates_backlash=True,
    title="LinuxCNC",
    codes=RS274,
    letters="ABCDEFHIJKLNPQRSTXYZ@^$",
    arc_rules={
        "mm": ArcRule(_SLACK_MM, 100 * _SLACK_MM, 0.001, _SMALLEST_MM, radius_slack=_SMALLEST_MM),
        "inch": ArcRule(_SLACK_INCH, 100 * _SLACK_INCH, 0.001, _SMALLEST_INCH, radius_slack=_SMALLEST_INCH),
    },
    refused={
        **same_advice("UVW", "the stand-alone interpreter moves X Y Z A B C only"),
        **same_advice((f"M{number}" for number in range(100, 200)), "set up a program of that name on the machine"),
    },
    repeats=frozenset((RAPID, LINE, ARC_CW, ARC_CCW)) | CYCLES | MORE_REPEATS,
    writing=Writing(
        header=("{units} G17 G90 G91.1", "G40 G49 G80 G94"),
        tool_change=("m6", "pause", "split"),
        canned=CYCLE_NAMES,
        work_systems=("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"),
    ),
    line_limit=253,  # as measured on rs274 2.9; its documents say 256
    reads_files=True,
    expressions=True,
    o_words=True,
    line_number_first=True,
    strict_comments=True,
    strict_percent_markers=True,
    needs_end=True,
    stops_at_end=True,
    feed_mode_clears_feed=True,
    suspend_g92=True,
    centre_repeats_arc=True,
    tool_offsets_sideways=True,
    most_m_codes=4,
    conflicts={"G4": ("G2", "G3")},
    cancel_yields=True,
    cancel_takes_no_axes=True,
)
