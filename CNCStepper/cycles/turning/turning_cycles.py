# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cycles of a lathe by the names that job files use, and what an operation must have before it is cut."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from CNCStepper.cycles.turning.axis_drilling import drill_axis
from CNCStepper.cycles.turning.grooves import groove, part
from CNCStepper.cycles.turning.left_hand import OUTWARDS, from_the_chuck
from CNCStepper.cycles.turning.profile_path import finish
from CNCStepper.cycles.turning.turn_face import face
from CNCStepper.cycles.turning.turn_rough import rough
from CNCStepper.cycles.turning.turn_taper import taper
from CNCStepper.cycles.turning.turn_thread import thread, thread_warnings
from CNCStepper.cycles.turning.turning_moves import TurningMoves
from CNCStepper.cycles.turning.turning_operation import BY_EDGE, TurningOperation, TurnThread
from CNCStepper.cycles.turning.turning_setup import TurningAnswer, TurningSetup
from CNCStepper.errors import CycleError, Text
from CNCStepper.machine.tools.turning_tool import TurningTool

CUT: dict[str, Callable[[Any, TurningSetup, TurningMoves], dict[str, float]]] = {
    "turn_bore": rough,
    "turn_drill": drill_axis,
    "turn_face": face,
    "turn_finish": finish,
    "turn_groove": groove,
    "turn_part": part,
    "turn_rough": rough,
    "turn_taper": taper,
    "turn_thread": thread,
}


IN_A_HOLE = ("turn_groove", "turn_thread")  # cycles that an inside tool cuts besides


def cut(number: int, operation: TurningOperation, setup: TurningSetup, moves: TurningMoves) -> TurningAnswer:
    """Append the moves of one operation and return what it wants; raises CycleError before the first move."""
    _require_tool(operation, setup.tool, setup)
    turned, turning = setup, moves
    if operation.cycle in BY_EDGE and setup.tool.hand == "left":
        turned = from_the_chuck(setup)
        turning = moves.mirrored(turned)
    figures = CUT[operation.cycle](operation, turned, turning)
    fillets = figures.get("corners_with_fillet", 0.0)
    what = "the nose leaves a fillet of {nose:g} mm in {count:g} inner corners"
    warnings: tuple[str, ...] = (Text(what, nose=setup.tool.nose_mm, count=fillets),) if fillets else ()
    if isinstance(operation, TurnThread):
        warnings = thread_warnings(operation, setup)
    return TurningAnswer(
        number,
        operation.cycle,
        setup.tool.number,
        setup.profile,
        getattr(operation, "stock_to_leave_mm", 0.0),
        setup.tool.is_inside,
        {**figures, "feed_mm_rev": setup.feed_mm_rev, "rpm": setup.rpm},
        warnings,
    )


def _require_tool(operation: TurningOperation, tool: TurningTool, setup: TurningSetup) -> None:
    """Raise CycleError for feeds and depths that the tool does not take, or a tool of another kind."""
    if tool.feed_max_mm_rev and setup.feed_mm_rev > tool.feed_max_mm_rev:
        what, value = "the feed per revolution is above the tool's", f"{setup.feed_mm_rev:g} mm"
        raise CycleError("feed-high", what, value=value, limit=f"{tool.feed_max_mm_rev:g} mm", advice="lower the feed")
    if tool.feed_min_mm_rev and setup.feed_mm_rev < tool.feed_min_mm_rev:
        what, value = "the feed per revolution is below the tool's", f"{setup.feed_mm_rev:g} mm"
        raise CycleError("feed-low", what, value=value, limit=f"{tool.feed_min_mm_rev:g} mm", advice="raise the feed")
    ap_mm = getattr(operation, "ap_mm", 0.0)
    if tool.ap_max_mm and ap_mm > tool.ap_max_mm:
        what, limit = "the depth of cut is above the tool's", f"{tool.ap_max_mm:g} mm"
        raise CycleError("ap-high", what, value=f"{ap_mm:g} mm", limit=limit, advice="lower ap_mm")
    if operation.cycle in BY_EDGE:
        _require_turning_tool(operation, tool, setup)
    elif operation.cycle in IN_A_HOLE:
        _require_hole(tool, setup)


def _require_turning_tool(operation: TurningOperation, tool: TurningTool, setup: TurningSetup) -> None:
    wrong_hand = tool.hand == "left" and (tool.is_inside or operation.cycle not in OUTWARDS)
    if tool.kind not in ("turning", "boring") or wrong_hand:
        what = "a profile is cut by an insert, in a bore and on a cone by a right-hand one"
        limit = "a right-hand insert" if wrong_hand else "a turning or boring tool"
        raise CycleError("profile-tool", what, value=tool.kind_words, limit=limit, advice="use another tool")
    if operation.cycle == "turn_bore" and not tool.is_inside:
        what, limit = "boring takes a tool for the inside", "a boring bar"
        raise CycleError("bore-tool", what, value=tool.kind_words, limit=limit, advice="use a boring bar")
    _require_hole(tool, setup)


def _require_hole(tool: TurningTool, setup: TurningSetup) -> None:
    """Raise CycleError for a tool for the inside where there is no hole, or one too narrow for it."""
    if tool.is_inside and setup.bore_mm <= 0:
        what = "there is no hole into which the boring bar gets"
        limit = f"{tool.smallest_bore_mm:g} mm" if tool.smallest_bore_mm else "above 0 mm"
        raise CycleError("bore-missing", what, value="0 mm", limit=limit, advice="drill first, or turn a tube")
    if tool.is_inside and tool.smallest_bore_mm > setup.bore_mm:
        what, value = "the hole is too narrow for the boring bar", f"{setup.bore_mm:g} mm"
        raise CycleError("bore-narrow", what, value=value, limit=f"{tool.smallest_bore_mm:g} mm", advice="drill wider")
