# SPDX-License-Identifier: LGPL-2.1-or-later
"""The CNC mini-lathe (USP 2006), source B: records that end with "#", X radial and Z axial, feeds in mm/s.

    N10 G00 X-10. # N20 Z-50. # N30 X5000 Z50. #        a number without a point is in 1/10000: X5000 is 0.5 mm
    N40 G01 X-10. F1. # N50 Z-50. # M02 # ?             F in mm/s; "?" ends a text that is sent

An absent X or Z is no move. In absolute mode the published listing would then drive to 0, the chuck's centre: the axis
stays, and a warning is given. F lasts as long as one run of G01; a new G01 needs it. A motion stays in force until the
next G or M. The published table has G20 as radius and G70 as mm (both as switched on), the listing the opposite of
both: `mini-lathe:g20=diameter` and `g70=inch` are its readings. Inches are 25.4 mm. Zeros are set by hand before a
program, so that the tool starts at the work zero. `thread_start=index`: the lathe waits for its encoder before each run
of G01.
"""

from CNCStepper.gcode.dialects.codes import RS274
from CNCStepper.gcode.dialects.definition import ArcRule, Dialect, Writing, changed, rs274_codes, same_advice
from CNCStepper.toolpath import LINE, RAPID

_WRITING = Writing(
    header=("G20", "{units}", "G90"),
    footer=("M2",),
    closes="?",
    units={"mm": "G70", "inch": "G71"},
    decimals={"mm": 4, "inch": 4},
    tool_change=("split",),
    work_systems=(),
    comment="; {}",
    block_end=" #",
    code_digits=2,
    number_step=10,
    whole_ends=True,
    lifts=False,
    pointed=True,
)
_G20_IS_DIAMETER = {
    "codes": {"G20": RS274["G7"], "G21": RS274["G8"]},
    "writing": {"header": ("G21", "{units}", "G90")},
}
_G70_IS_INCH = {
    "codes": {"G70": RS274["G20"], "G71": RS274["G21"]},
    "writing": {"units": {"mm": "G71", "inch": "G70"}},
}

_THREADS = (
    "the feed does not follow the spindle: write thread passes as G01 at F = pitch * rpm / 60, for a lathe that begins "
    "each run of G01 at the encoder's index (mini-lathe:thread_start=index)"
)

MINI_LATHE = Dialect(
    name="mini-lathe",
    title="mini-lathe B",
    codes={
        **rs274_codes("G0 G90 G91 M2", changed("G1", needs="F")),
        "G20": RS274["G8"],
        "G21": RS274["G7"],
        "G70": RS274["G21"],
        "G71": RS274["G20"],
    },
    letters="FNXZ",
    arc_rules={"mm": ArcRule(0.0, 0.0, 0.0), "inch": ArcRule(0.0, 0.0, 0.0)},
    refused={
        **same_advice(("G2", "G3"), "this lathe moves in straight lines: write the arc as lines"),
        **same_advice(("Y",), "the axes are X (radial) and Z (axial)"),
        **same_advice(("S", "M3", "M4", "M5"), "the spindle's speed is set by hand"),
        **same_advice(("G33", "G76"), _THREADS),
        **same_advice(("T", "M6"), "the tool is changed by hand: write one program a tool"),
    },
    writing=_WRITING,
    settings={
        "g20": {"radius": {}, "diameter": _G20_IS_DIAMETER},
        "g70": {"mm": {}, "inch": _G70_IS_INCH},
        "thread_start": {"none": {}, "index": {"waits_for_index": True}},
    },
    front=("records", "dotless", "feed_per_second"),
    line_limit=0,
    skips_deleted=True,
    stops_at_end=True,
    repeats=frozenset((RAPID, LINE)),
    distance="incremental",
    starts_at_work_zero=True,
    z_sign=-1.0,
    feed_unit_mm_min=60.0,
)
