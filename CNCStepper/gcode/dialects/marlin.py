# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marlin, as a controller of cutting machines.

From its G-code pages (marlinfw.org) and `gcode/parser.cpp`: a line holds one command, and coordinates alone are none;
comments begin with ";" ("(" is none); G4 waits P milliseconds or S seconds; M0 may be followed by a text for the
display; lines of 96 characters. G2 and G3 work in the XY plane (others are a build option), "the given X Y is not
error-checked" and P counts full circles BEFORE the arc, so that neither is relied on. Rapids move at the F in force.

What looks like RS274 and is not: ".1" of a code is ignored unless built in, so that G91.1 would be G91; G28 homes, G30
probes, G10 retracts, G61 returns to a stored place, M30 deletes a file, T selects an extruder. None of them is read
or written, and a program ends without an end word.
"""

from CNCStepper.gcode.dialects.definition import ArcRule, Dialect, Writing, changed, rs274_codes, same_advice

_RULE = ArcRule(slack=0.005, gap=0.5, relative=0.001, smallest_angle_rad=1e-6)  # ours: Marlin itself checks nothing
_RULE_INCH = ArcRule(slack=0.005 / 25.4, gap=0.5 / 25.4, relative=0.001, smallest_angle_rad=1e-6)

MARLIN = Dialect(
    name="marlin",
    title="Marlin",
    codes=rs274_codes(
        "G0 G1 G20 G21 G53 G54 G55 G56 G57 G58 G59 G59.1 G59.2 G59.3 G90 G91 M0 M1 M3 M4 M5 M7 M8 M9",
        changed("G2", takes="IJR"),
        changed("G3", takes="IJR"),
        changed("G4", takes="P"),
    ),
    letters="FIJNPRSXYZ",
    arc_rules={"mm": _RULE, "inch": _RULE_INCH},
    refused={
        **same_advice(("G28",), "G28 homes a Marlin machine: home it before the program"),
        **same_advice(("G91.1", "G90.1"), "Marlin would read G91 or G90: leave it out"),
        **same_advice(("G17", "G18", "G19"), "planes are an option of the build: leave it out, arcs are in XY"),
        **same_advice(("M2", "M30"), "Marlin has no end word (M30 deletes a file): leave it out"),
        **same_advice(("M6", "T"), "T selects an extruder: pause with M0 where the tool is to be changed"),
        **same_advice(("G61", "G64", "G40", "G49", "G80", "G94"), "leave it out: Marlin has only this mode"),
        **same_advice(("K",), "arcs are in XY"),
        **same_advice(("G10", "G11", "G30"), "Marlin means something else with it"),
    },
    writing=Writing(
        header=("{units}", "G90"),
        footer=("M5", "M9"),
        work_systems=("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"),
        comment="; {}",
        largest_radius_mm=2000.0,
        rapid_feed=True,
    ),
    front=("semicolons", "checksum", "texts", "dwell_in_seconds", "one_command"),
    line_limit=96,
    repeats=frozenset(),
    arc_needs_plane_axis=True,
    dwell_unit_s=0.001,
)
