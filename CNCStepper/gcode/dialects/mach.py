# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mach3 and Mach4: RS274/NGC as the manual "Using Mach3Mill", chapter 10, has it.

Lines of 256 characters; the radii at both ends of an arc may differ by 0.002 mm or 0.0002 inch; G43 H from the tool
table; G90.1 and G91.1; canned cycles with G98 and G99. What P means after G4 is a setting of the machine ("G04 Dwell
in ms"): `mach` is in seconds, `mach:dwell=ms` in milliseconds. G28.1 homes the machine there, so it is not read; nor
are macros (M codes above 30).
"""

from CNCStepper.canned_cycle_expansion import CYCLE_NAMES
from CNCStepper.gcode.dialects.codes import RS274
from CNCStepper.gcode.dialects.definition import ArcRule, Dialect, Writing, rs274_codes, same_advice

MACH = Dialect(
    name="mach",
    compensates_backlash=True,
    title="Mach3/4",
    codes=rs274_codes(
        "G0 G1 G4 G10 G17 G18 G19 G20 G21 G28 G30 G40 G43 G49 G53 G54 G55 G56 G57 G58 G59 G61 G64 G80 "
        "G90 G91 G90.1 G91.1 G92 G92.1 G92.2 G92.3 G93 G94 G98 G99 M0 M1 M2 M3 M4 M5 M6 M7 M8 M9 M30 "
        + " ".join(CYCLE_NAMES),
        RS274["G2"],
        RS274["G3"],
    ),
    letters="FHIJKLNPQRSTXYZ",
    arc_rules={"mm": ArcRule(0.002, 0.002, 1.0), "inch": ArcRule(0.0002, 0.0002, 1.0)},
    refused={
        **same_advice(("G28.1", "G30.1"), "G28.1 homes a Mach machine: home it before the program"),
        **same_advice(("G43.1",), "use G43 with the tool's number in H"),
        **same_advice(("G59.1", "G59.2", "G59.3"), "write with G54 to G59"),
        **same_advice(("G38.2", "G38.3", "G38.4", "G38.5"), "Mach probes with G31"),
        **same_advice("ABCUVW", "machines with more than three axes are not written for Mach yet"),
    },
    writing=Writing(
        header=("{units} G17 G90 G91.1", "G40 G49 G80 G94"),
        tool_change=("m6", "pause", "split"),
        canned=("G81",),  # what G73 and G83 do between pecks, and the P of G82, depends on settings
        decimals={"mm": 4, "inch": 5},
    ),
    settings={"dwell": {"s": {}, "ms": {"dwell_unit_s": 0.001}}},
    line_limit=256,
    expressions=True,
    largest_line_number=99_999,
    largest_tool=254,
    work_systems=6,
    suspend_g92=True,
)
