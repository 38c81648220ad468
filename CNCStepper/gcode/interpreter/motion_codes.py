# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which function executes each motion code: `MOTIONS` has all.

Each takes the block, the motion and the one that was modal before.
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.gcode.canned.canned_cycles import run_block
from CNCStepper.gcode.dialects.codes import CYCLES, MOTION_NAMES, PROBES, PROFILE_CYCLES, SPLINES
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.motion.lines_and_arcs import arc, straight
from CNCStepper.gcode.interpreter.motion.probing import probe
from CNCStepper.gcode.interpreter.motion.splines import bezier, control_point
from CNCStepper.gcode.lathe.profile_cycles import run_profile
from CNCStepper.gcode.lathe.threading import run_thread, tap, thread
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID

Motion = Callable[[Block, int, int], None]
MOTIONS: dict[int, Motion] = {
    RAPID: straight,
    LINE: straight,
    ARC_CW: arc,
    ARC_CCW: arc,
    **dict.fromkeys(CYCLES, run_block),
    **{MOTION_NAMES.index(name): probe for name in PROBES},
    **{MOTION_NAMES.index(name): bezier for name in SPLINES},
    **{MOTION_NAMES.index(name): run_profile for name in PROFILE_CYCLES},
    MOTION_NAMES.index("G5.2"): control_point,
    MOTION_NAMES.index("G33"): thread,
    MOTION_NAMES.index("G33.1"): tap,
    MOTION_NAMES.index("G76"): run_thread,
}
