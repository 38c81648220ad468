# SPDX-License-Identifier: LGPL-2.1-or-later
"""grbl 1.1: the language as its documentation and its parser have it."""

from CNCStepper.canned_cycle_expansion import CYCLE_NAMES
from CNCStepper.gcode.dialects.definition import ArcRule, Dialect, Writing, changed, rs274_codes, same_advice
from CNCStepper.toolpath import RAPID

_RULE = ArcRule(slack=0.005, gap=0.5, relative=0.001, smallest_angle_rad=1e-6)  # error:33; mm whatever the unit
_RULE_INCH = ArcRule(slack=0.005 / 25.4, gap=0.5 / 25.4, relative=0.001, smallest_angle_rad=1e-6)

GRBL = Dialect(
    name="grbl",
    title="grbl 1.1",
    codes=rs274_codes(
        "G0 G1 G4 G17 G18 G19 G20 G21 G28 G28.1 G30 G30.1 G40 G43.1 G49 G53 G54 G55 G56 G57 G58 G59 G61 G80 "
        "G90 G91 G91.1 G92 G92.1 G93 G94 M0 M1 M2 M3 M4 M5 M7 M8 M9 M30",
        changed("G2", takes="IJKR"),
        changed("G3", takes="IJKR"),
        changed("G10", takes="LP", needs="LP", axes="must"),
        changed("G43.1", axes="must"),
    ),
    letters="FIJKLNPRSTXYZ",
    arc_rules={"mm": _RULE, "inch": _RULE_INCH},
    refused={
        **same_advice("ABCUVW", "grbl moves X, Y and Z only"),
        **same_advice(("M6",), "change the tool at an M0 pause, or split the program at tool changes"),
        **same_advice(("G64", "G61.1"), "grbl follows the exact path always: leave the word out or write G61"),
        **same_advice(("G90.1",), "give I, J and K from the start point of the arc (G91.1)"),
        **same_advice(("G43",), "use G43.1 with the length in Z"),
        **same_advice(("G92.2", "G92.3"), "use G92.1"),
        **same_advice((*CYCLE_NAMES, "G98", "G99"), "grbl has no canned cycles: write the holes as plain moves"),
        **same_advice(("G59.1", "G59.2", "G59.3"), "grbl has G54 to G59"),
    },
    errors={
        "unknown-code": "error:20",
        "refused-code": "error:20",
        "modal-conflict": "error:21",
        "no-feed": "error:22",
        "axis-conflict": "error:24",
        "repeated-word": "error:25",
        "missing-axis": "error:26",
        "line-number": "error:27",
        "missing-word": "error:28",
        "work-system": "error:29",
        "machine-move": "error:30",
        "axis-unused": "error:31",
        "arc-plane": "error:32",
        "arc-ends": "error:33",
        "arc-radius": "error:34",
        "arc-words": "error:35",
        "unused-word": "error:36",
        "tool-number": "error:38",
        "line-too-long": "error:11",
    },
    writing=Writing(
        header=("{units} G17 G90 G91.1", "G40 G49 G94"),  # after G80 a G43.1 or G92 would be refused
        largest_radius_mm=2000.0,
    ),
    line_limit=80,
    largest_line_number=9_999_999,
    skips_deleted=True,
    largest_tool=255,
    work_systems=6,
    tool_word_changes=True,
    feed_in_new_units=True,
    first_motion=RAPID,
    arc_needs_plane_axis=True,
    machine_moves_incremental=True,
    machine_word_alone=True,
    axes_need_motion=True,
)
