# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mach3 Turn: the language of `mach.py` for a lathe, as far as the index of "Using Mach3Turn", 1.84, is known.

X is a diameter or a radius by the machine's configuration, so that no word of the text says it: `mach-turn` is in
diameters, `mach-turn:x=radius` in radii; I and K are radii. T0101 takes tool 1 with its offset 1. G94 and G95 are feeds
a minute and a turn, G32 a thread pass with its lead in F. G76 (lead P, end X Z, first cut H, angle I, clearance C,
start R K, last cut B, spring passes Q, pull-out L), G77 and G78 are macros of the machine, which its owner can change:
they are refused by name, and written as their moves. G96 has no word for the highest speed of the spindle that is
known, so it is not written or read.
"""

from dataclasses import replace

from CNCStepper.gcode.dialects.codes import LEAD_BY_FEED, RS274
from CNCStepper.gcode.dialects.definition import Writing, rs274_codes, same_advice
from CNCStepper.gcode.dialects.mach import MACH

_THREAD_ADVICE = (
    "its lead is P and its first cut H, F has no meaning in it, and its passes are a macro of the machine (m1076): "
    "write each pass as G32 with the lead in F"
)

MACH_TURN = replace(
    MACH,
    name="mach-turn",
    title="Mach3 Turn",
    codes=rs274_codes(
        "G0 G1 G2 G3 G4 G18 G20 G21 G40 G52 G53 G54 G55 G56 G57 G58 G59 G61 G64 G80 G90 G91 G90.1 G91.1 "
        "G92 G92.1 G92.2 G92.3 G94 G95 G97 M0 M1 M2 M3 M4 M5 M7 M8 M9 M30",
        replace(RS274["G41"], takes=""),
        replace(RS274["G42"], takes=""),
        LEAD_BY_FEED,
    ),
    letters="FIKNPRSTXZ",
    refused={
        **same_advice("Y", "a lathe moves X and Z"),
        **same_advice(("G7", "G8"), "whether X is a diameter is a setting of the machine"),
        **same_advice(("G17", "G19"), "a lathe's arcs are in the plane ZX (G18)"),
        **same_advice(("G33",), "write G32 with the lead in F"),
        **same_advice(("G76",), _THREAD_ADVICE),
        **same_advice(("G77", "G78"), "its passes are a macro of the machine: write its moves as G0 and G1"),
        **same_advice(("G70", "G71", "G72"), "write the cycle's moves"),
        **same_advice(("G96",), "the highest speed of the spindle cannot be written: use G97 and a fixed speed"),
        **same_advice(("G43", "G49"), "the offset comes with T: T0101"),
        **same_advice(("M6",), "T0101 changes the tool"),
    },
    writing=Writing(
        header=("{units} G18 G90 G91.1", "G40 G80 G94 G97"),
        tool_change=("m6", "pause", "split"),
        decimals={"mm": 4, "inch": 5},
        helices=False,
        lifts=False,
    ),
    settings={**MACH.settings, "x": {"diameter": {}, "radius": {"diameter": False}}},
    largest_tool=99,
    tool_word_changes=True,
    is_lathe=True,
    diameter=True,
    lead_word="F",
    turret=True,
)
