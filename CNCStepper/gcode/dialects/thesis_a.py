# SPDX-License-Identifier: LGPL-2.1-or-later
"""The language of the PC control unit for stepper tables (thesis A, UFSM 2006).

G90 and G91 are themselves the words for straight feed moves, absolute and incremental; the centre words I and
J are absolute coordinates; coordinates alone after an arc are refused. The language has no word for feed: the
speed is a setting of that machine, so an F word is accepted as an addition, and 900 mm/min stands until one
comes. The tool starts at the work zero. Its arcs are quarter by quarter in the XY plane (A3), so that a full circle is
written as two arcs and a helix as lines; it has no words for spindle, tools or pauses, and its programs just end.
"""

from CNCStepper.gcode.dialects.codes import Code
from CNCStepper.gcode.dialects.definition import ArcRule, Dialect, Writing, changed, rs274_codes, same_advice
from CNCStepper.toolpath import LINE, RAPID

_RULE = ArcRule(slack=0.005, gap=0.5, relative=0.001)

THESIS_A = Dialect(
    name="thesis-a",
    compensates_backlash=True,
    title="thesis A",
    codes=rs274_codes(
        "G0 M2 M30",
        changed("G2", takes="IJK"),
        changed("G3", takes="IJK"),
        Code("G90", "motion", "motion", axes="may", sets={"distance": "absolute"}, motion=LINE),
        Code("G91", "motion", "motion", axes="may", sets={"distance": "incremental"}, motion=LINE),
    ),
    letters="FIJKNXYZ",
    arc_rules={"mm": _RULE, "inch": _RULE},
    refused={
        **same_advice(("G1",), "write G90 (absolute) or G91 (incremental): they are the words for straight cuts"),
        **same_advice(("R",), "give the arc's centre with I and J"),
        **same_advice(("G20", "G21"), "this language is in millimetres"),
    },
    writing=Writing(
        footer=(),
        units={"mm": ""},
        decimals={"mm": 3},
        tool_change=("split",),
        work_systems=(),
        helices=False,
        full_circles=False,
        short=True,
        keeps_distance=True,
    ),
    repeats=frozenset((RAPID, LINE)),
    arc_centres="absolute",
    default_feed_mm_min=900.0,
    feed_is_setting=True,
    starts_at_work_zero=True,
)
