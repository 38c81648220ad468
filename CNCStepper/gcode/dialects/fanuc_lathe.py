# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lathes with a Fanuc control, G code system A: X is a diameter, G98 and G99 are feeds a minute and a turn.

    %
    G21 G18                  G20 inch, G21 mm
    G40 G97 G98
    T0101                    tool 1 with the turret's offset 1; there is no M6
    G50 S2000                the highest speed of the spindle
    G96 S120 M3              m/min at X
    G99                      F is mm a turn
    G71 U2. R0.5             cycles in two blocks, as gcode/lathe/two_block_cycles.py has them
    G71 P10 Q20 U0.4 W0.1 F0.2
    N10 G0 X20. ... N20 G1 X50.
    G32 Z-32. F2.5           a thread pass: F is the lead along the axis that moves farther
    M30
    %

G90, G92 and G94 are cycles in system A and not read; X and Z are absolute, U and W are from where the tool is. A number
without a point is in steps of the last digit, unless the control has pocket calculator input
(`fanuc-lathe:point=free`): it is refused. `fanuc-lathe:x=radius` is a control whose parameter takes X as radius. I and
K are radii from the begin of an arc whatever X is. A dwell is X and seconds. G41 and G42 take the nose radius of the
tool's offset.
"""

from CNCStepper.gcode.dialects.codes import LEAD_BY_FEED, RS274, SPEED_LIMIT, TWO_BLOCK_CYCLES
from CNCStepper.gcode.dialects.definition import ArcRule, Dialect, Writing, changed, rs274_codes, same_advice

_FRONT = ("program_name", "pointed", "dwell_by_axis")

FANUC_LATHE = Dialect(
    name="fanuc-lathe",
    title="Fanuc lathe (system A)",
    codes={
        **rs274_codes(
            "G0 G1 G4 G18 G20 G21 G40 G54 G55 G56 G57 G58 G59 G97 M0 M1 M2 M3 M4 M5 M7 M8 M9 M30",
            changed("G2", takes="IKR"),
            changed("G3", takes="IKR"),
            changed("G41", takes=""),
            changed("G42", takes=""),
            changed("G96", takes=""),
            SPEED_LIMIT,
            LEAD_BY_FEED,
            *TWO_BLOCK_CYCLES,
        ),
        "G98": RS274["G94"],
        "G99": RS274["G95"],
    },
    letters="FIKNPQRSTUWXZ",
    arc_rules={"mm": ArcRule(0.005, 0.5, 0.001), "inch": ArcRule(0.0002, 0.02, 0.001)},
    refused={
        **same_advice("Y", "a lathe moves X and Z"),
        **same_advice(("G17", "G19"), "a lathe's arcs are in the plane ZX (G18)"),
        **same_advice(("G90", "G92", "G94"), "in system A this is a cycle: write its moves"),
        **same_advice(("G91",), "system A has no G91: X and Z are absolute"),
        **same_advice(("G95", "G93"), "system A has G98 (feed a minute) and G99 (a turn)"),
        **same_advice(("G33",), "write G32 with the lead in F"),
        **same_advice(("G74", "G75"), "write the cycle's moves"),
        **same_advice(("G7", "G8"), "whether X is a diameter is a setting of the control"),
        **same_advice(("G28", "G30", "G53", "G10"), "its effect depends on the machine: leave it out"),
        **same_advice(("G43", "G49"), "the offset comes with T: T0101"),
        **same_advice(("M6",), "T0101 turns the turret"),
    },
    writing=Writing(
        header=("{units} G18", "G40 G97 G98"),
        footer=("M5", "M9", "M30"),
        opens="%",
        closes="%",
        tool_change=("m6", "pause", "split"),
        code_digits=2,
        helices=False,
        lifts=False,
        pointed=True,
    ),
    settings={
        "x": {"diameter": {}, "radius": {"diameter": False}},
        "point": {"needed": {}, "free": {"front": tuple(step for step in _FRONT if step != "pointed")}},
    },
    front=_FRONT,
    dwell_letter="X",
    line_limit=256,
    largest_line_number=9999,
    line_number_first=True,
    largest_tool=99,
    work_systems=6,
    tool_word_changes=True,
    stops_at_end=True,
    compensates_backlash=True,
    is_lathe=True,
    diameter=True,
    feed_mode="per_turn",
    lead_word="F",
    two_block_cycles=True,
    axis_increments=True,
    turret=True,
)
