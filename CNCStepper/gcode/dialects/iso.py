# SPDX-License-Identifier: LGPL-2.1-or-later
"""ISO 6983-1 as machining centres of the ROMI kind take it: "%", N words in steps of ten, two digits in each code.

    %
    N10 G71 G17 G90          header: units, plane; then origin and tool
    N20 G54
    ...
    N140 M02                 the end, and "%" again

Units are the standard's own: G70 inch, G71 mm (G20 and G21 are read too). A program may be named after "%" or by ":" or
"O" and a number. Controls differ in what P means after G04, so a dwell is written as X in seconds; X and F are read, P
is refused. Sample and order of the header: part C of the source systems ("header with units, plane, origin, tool; then
the blocks; M02 at the end").
"""

from CNCStepper.gcode.dialects.codes import RS274
from CNCStepper.gcode.dialects.definition import ArcRule, Dialect, Writing, changed, rs274_codes, same_advice

_SLACK_MM, _SLACK_INCH = 0.005, 0.0002

ISO = Dialect(
    name="iso",
    compensates_backlash=True,
    title="ISO 6983",
    codes={
        **rs274_codes(
            "G0 G1 G4 G17 G18 G19 G20 G21 G40 G43 G49 G53 G54 G55 G56 G57 G58 G59 G80 G90 G91 G93 G94 G98 G99 "
            "G73 G81 G83 M0 M1 M2 M3 M4 M5 M6 M7 M8 M9 M30",
            changed("G2", takes="IJKR"),
            changed("G3", takes="IJKR"),
        ),
        "G70": RS274["G20"],
        "G71": RS274["G21"],
    },
    letters="FHIJKLNPQRSTXYZ",
    arc_rules={"mm": ArcRule(_SLACK_MM, 0.5, 0.001), "inch": ArcRule(_SLACK_INCH, 0.02, 0.001)},
    refused={
        **same_advice(("G90.1", "G91.1"), "I, J and K are given from the start point of the arc"),
        **same_advice(("G92", "G92.1", "G28", "G30", "G10"), "its effect depends on the machine: leave it out"),
        **same_advice(("G61", "G64"), "ISO 6983 has no such word: leave it out"),
        **same_advice(("G43.1",), "use G43 with the tool's number in H"),
        **same_advice(("G59.1", "G59.2", "G59.3"), "write with G54 to G59"),
        **same_advice("ABCUVW", "machines with more than three axes are not written in this dialect"),
    },
    writing=Writing(
        header=("{units} G17 G90", "G40 G49 G80 G94"),
        opens="%",
        closes="%",
        units={"mm": "G71", "inch": "G70"},
        tool_change=("m6", "pause", "split"),
        canned=("G81",),  # the others differ from control to control
        code_digits=2,
        number_step=10,
    ),
    front=("program_name", "dwell_by_axis"),
    dwell_letter="X",
    line_limit=256,
    largest_line_number=9999,
    line_number_first=True,
    work_systems=6,
    stops_at_end=True,
)
