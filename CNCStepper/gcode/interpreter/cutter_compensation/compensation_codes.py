# SPDX-License-Identifier: LGPL-2.1-or-later
"""The codes of cutter radius compensation: G40, G41, G42, G41.1, G42.1.

`compensated_path.py` makes the moves. All points are (first, second, normal) of the plane, in work mm, so that one
text serves XY and ZX.
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import Code
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.cutter_compensation.compensation_state import Compensation, Path3
from CNCStepper.gcode.interpreter.cutter_compensation.move_queue import end_queue_at, release
from CNCStepper.gcode.interpreter.functions.tools import entry_of
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.tolerances import WHOLE_NUMBER
from CNCStepper.toolpath import PLANE_AXES, PLANE_NAMES

PLANES = ("XY", "ZX")


def compensation_by_tool(block: Block, code: Code) -> None:
    """G41, G42: the radius of the tool D, or of the one in the spindle."""
    plane = _plane(block, code.name)
    entry = block.model.loaded
    if "D" in block.plan.slots:
        number = block.value("D")
        if abs(round(number) - number) >= WHOLE_NUMBER or number < 0:
            what: str = Text("D of {code} is the number of a tool", code=code.name)
            raise ProgramError("bad-value", what, value="D", limit="a whole number from 0", advice="correct D")
        entry = entry_of(block, round(number), "D") if round(number) else block.model.loaded
    diameter = entry.diameter_mm
    if diameter != diameter:
        if not block.model.bare:
            what = "the diameter of the tool is not known"
            raise ProgramError(
                "tool-diameter", what, value=code.name, advice="give the tool table with the start state"
            )
        diameter = 0.0
    if plane != "ZX" and entry.orientation not in (0, 9):
        raise ProgramError("plane", "a lathe tool is compensated in the plane ZX", value=code.name, advice="write G18")
    _begin(block, code, plane, diameter / 2, entry.orientation)


def compensation_by_word(block: Block, code: Code) -> None:
    """G41.1, G42.1: D is the diameter itself, L the orientation of a lathe tool."""
    plane = _plane(block, code.name)
    block.must_have("D", code.name)
    orientation = block.whole("L", 0, 9) if "L" in block.plan.slots else 0
    if "L" in block.plan.slots and plane != "ZX":
        raise ProgramError("plane", "a lathe tool is compensated in the plane ZX", value=code.name, advice="write G18")
    _begin(block, code, plane, block.value("D") * block.model.scale / 2, orientation)


def _plane(block: Block, name: str) -> str:
    plane = block.model.state.plane
    if plane not in PLANES or block.model.far_plane:
        what = "the tool is compensated in the planes XY and ZX only"
        raise ProgramError("plane", what, value=name, advice="write G17 or G18 before")
    if block.model.compensation:
        what = "the tool is compensated already"
        raise ProgramError("compensation", what, value=name, advice="write G40 before")
    return plane


def _begin(block: Block, code: Code, plane: str, radius: float, orientation: int) -> None:
    """A negative radius is the other side."""
    left = code.name.startswith("G41") == (radius >= 0)
    model = block.model
    block.call(f'COMMENT("interpreter: cutter radius compensation on {"left" if left else "right"}")')
    model.compensation = Compensation(left, abs(radius), orientation, plane)
    model.look()


def compensation_off(block: Block, code: Code) -> None:
    """G40: the text continues from its own tool position."""
    block.call('COMMENT("interpreter: cutter radius compensation off")')
    ours = block.model.compensation
    if ours and ours.entered and ours.radius:
        block.model.arc_allowed = False  # the move off the contour is a line
    end_compensation(block)


def end_compensation(block: Block) -> None:
    """Flush the queued moves; the text continues from its own tool position."""
    model = block.model
    ours = model.compensation
    if ours:
        flush(block)
        if ours.entered and ours.radius:
            stand_alone_position.continue_at(model, model.machine(ours.programmed_work))
        model.compensation = None
    model.look()


def take_centre_position(block: Block) -> None:
    """Take the position for the centre's, though moves are held: LinuxCNC does so after it has asked its machine."""
    ours = block.model.compensation
    if ours and ours.held:
        work = block.model.work(block.model.position)
        here, programmed = in_plane(block, work), list(ours.programmed_work)
        normal = PLANE_AXES[PLANE_NAMES.index(block.model.state.plane)][2]
        programmed[normal] = work[normal]
        block.model.compensation = ours._replace(
            current=here,
            programmed=(*ours.programmed[:2], here[2]),
            programmed_work=(programmed[0], programmed[1], programmed[2]),
        )


def flush(block: Block) -> None:
    """Make the moves that are held, with the ends that they have."""
    ours = block.model.compensation
    if ours and ours.held:
        end_queue_at(block, complex(*ours.current[:2]))
        release(block)


def active(block: Block) -> bool:
    """Whether moves are shifted sideways: a tool of no radius stays on its path."""
    return block.model.compensation is not None and block.model.compensation.radius > 0


def in_plane(block: Block, point: tuple[float, float, float]) -> Path3:
    """Return a point as (first, second, normal) of the plane."""
    first, second, normal = PLANE_AXES[PLANE_NAMES.index(block.model.state.plane)]
    return point[first], point[second], point[normal]


COMPENSATION_ACTS: dict[str, Callable[[Block, Code], None]] = {
    act.__name__: act for act in (compensation_by_tool, compensation_by_word, compensation_off)
}
