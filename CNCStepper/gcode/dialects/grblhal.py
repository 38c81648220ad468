# SPDX-License-Identifier: LGPL-2.1-or-later
"""grblHAL: grbl 1.1 with canned cycles, several turns of an arc, nine work systems and M6.

From its README ("Supported G-Codes": G73 G81 to G83, G98 G99, G59.1 to G59.3, "multi turn arcs from build 20220718")
and `errors.h`; lines of 256 characters. M6 depends on driver and build: it stops the machine in the state Tool until
the sender acknowledges with 0xA3. G43 needs a tool table that most builds lack, so G43.1 is used. G91.1 only, error:33
as in grbl. How far G73 and G83 go back is a setting, so that only G81 and G82 are written as blocks. Expressions and
O-words ("NGC" options of the build) are read; the wire text has them expanded.
"""

from dataclasses import replace

from CNCStepper.canned_cycle_expansion import CYCLE_NAMES
from CNCStepper.gcode.dialects.codes import RS274
from CNCStepper.gcode.dialects.definition import same_advice
from CNCStepper.gcode.dialects.grbl import GRBL

_MORE = (*CYCLE_NAMES, "G98", "G99", "G59.1", "G59.2", "G59.3")
assert GRBL.writing is not None  # it is ours

GRBLHAL = replace(
    GRBL,
    name="grblhal",
    title="grblHAL",
    codes={**GRBL.codes, **{name: RS274[name] for name in (*_MORE, "G2", "G3", "M6")}},
    letters=GRBL.letters + "Q",
    refused={
        **{name: advice for name, advice in GRBL.refused.items() if name not in (*_MORE, "M6")},
        **same_advice(("G90.1",), "grblHAL takes arc centres from the start point only (G91.1)"),
    },
    writing=replace(
        GRBL.writing,
        canned=("G81", "G82"),
        tool_change=("pause", "split", "m6"),
        work_systems=(*GRBL.writing.work_systems, "G59.1", "G59.2", "G59.3"),
    ),
    line_limit=256,
    expressions=True,
    o_words=True,
    work_systems=9,
    largest_tool=2**31 - 1,
    tool_word_changes=False,
)
