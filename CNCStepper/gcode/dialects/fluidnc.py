# SPDX-License-Identifier: LGPL-2.1-or-later
"""FluidNC: grbl 1.1 on other processors.

From its `GCode.cpp`: the codes of grbl, no canned cycles, no G43 but G43.1, no G59.1 to G59.3 ("G59.x are not
supported"), M1 ignored, M4 only where the spindle can reverse or is a laser; and `Channel.h`: lines of 255 characters.
M6 calls a macro of the machine's configuration, which may be none: it is neither read nor written. Expressions and
O-words (`Expression.cpp`) are read; the wire text has them expanded.
"""

from dataclasses import replace

from CNCStepper.canned_cycle_expansion import CYCLE_NAMES
from CNCStepper.gcode.dialects.definition import same_advice
from CNCStepper.gcode.dialects.grbl import GRBL

FLUIDNC = replace(
    GRBL,
    name="fluidnc",
    title="FluidNC",
    refused={
        **GRBL.refused,
        **same_advice("ABCUVW", "FluidNC moves X, Y and Z only"),
        **same_advice(("G64", "G61.1"), "FluidNC follows the exact path always: leave the word out or write G61"),
        **same_advice((*CYCLE_NAMES, "G98", "G99"), "FluidNC has no canned cycles: write the holes as plain moves"),
        **same_advice(("G59.1", "G59.2", "G59.3"), "FluidNC has G54 to G59"),
        "M6": "M6 depends on the machine's configuration: pause with M0, or split at tool changes",
    },
    line_limit=255,
    expressions=True,
    o_words=True,
    largest_tool=99_999_999,
)
