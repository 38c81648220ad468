# SPDX-License-Identifier: LGPL-2.1-or-later
"""M70 to M73: the modes of a level of subroutine calls are kept, and brought back by the blocks that set them.

LinuxCNC writes such blocks as text and executes them; so does this module, with its rounding of F and S:

    G21 | F123.5 S78 G94 G17 G49 G54 G90 M3 | M8 | M48        only what differs from the modes in force

The modes that no row of the table shows, as words: how corners are followed, where cycles retract to, overrides.
"""

from __future__ import annotations

from collections.abc import Callable, Set

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects.codes import NO_MOTION, UNIT_CODES, Code
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.state.interpreter_state import Model, Modes
from CNCStepper.gcode.syntax.line_grammar import Grammar
from CNCStepper.gcode.syntax.words import words_of

FEED_MODES = {"inverse_time": "G93", "per_minute": "G94", "per_turn": "G95"}
PATHS = {"CANON_EXACT_PATH": "G61", "CANON_EXACT_STOP": "G61.1"}  # by the name of their canonical call
SPINDLE = {"cw": "M3", "ccw": "M4", "off": "M5"}


def modes_of(model: Model, on_return: bool = False) -> Modes:
    """Return the modes in force."""
    compensation = model.compensation
    side = "G40" if compensation is None else "G41" if compensation.left else "G42"
    first = (model.state, model.feed_number, model.plane_code, side, model.diameter)
    return Modes(*first, model.to_initial, model.path_calls, model.overrides, any(model.tool_offset), on_return)


def keep_modes(block: Block, code: Code) -> None:
    """M70, M73: keep the modes of this level; after M73 they come back when the subroutine ends."""
    model = block.model
    level = model.parameters.level
    model.saved = {**model.saved, level: modes_of(model, on_return=code.name == "M73" and level > 0)}


def forget_modes(block: Block, code: Code) -> None:
    """M71: discard the modes stored on this level."""
    block.model.saved = {level: modes for level, modes in block.model.saved.items() if level != _level(block)}


def restore_modes(block: Block, code: Code) -> None:
    """M72: restore the modes stored on this level; raises ProgramError where there are none."""
    if _level(block) not in block.model.saved:
        what = "no modes are kept here"
        raise ProgramError("no-modes", what, value=code.name, advice="write M70 before, in the same subroutine")
    restore(block, block.model.saved[_level(block)])


def leave_level(block: Block, level: int) -> None:
    """End a subroutine that ran at `level`: after M73 the modes come back; what was kept there is forgotten."""
    modes = block.model.saved.get(level)
    block.model.saved = {kept: modes for kept, modes in block.model.saved.items() if kept < level}
    if modes and modes.on_return:
        restore(block, modes)


def restore(block: Block, modes: Modes) -> None:
    """Execute the blocks that bring the modes back."""
    grammar = Grammar(block.dialect)
    now = modes_of(block.model)
    if now.state.units != modes.state.units:
        _execute(block, grammar, UNIT_CODES[modes.state.units])
        now = modes_of(block.model)
    for line in _lines(now, modes):
        _execute(block, grammar, line)


def _execute(block: Block, grammar: Grammar, line: str) -> None:
    words = words_of(line)
    plan = grammar.plan(words, NO_MOTION)
    values = [float(word.number) for word in words if word.letter not in "GM"]
    outer = block.plan, block.values
    block.execute(plan, values)
    block.plan, block.values = outer


def _lines(now: Modes, then: Modes) -> list[str]:
    """Return the blocks that turn the modes `now` into those of `then`."""
    first = [f"F{then.feed_number:.1f}"] * (now.feed_number != then.feed_number)
    first += [new for old, new in zip(_words(now), _words(then), strict=True) if old != new]
    first += [SPINDLE[then.state.spindle]] * (now.state.spindle != then.state.spindle)
    more = [new for old, new in zip(_switches(now), _switches(then), strict=True) if new and old != new]
    return [line for line in (" ".join(first), *more) if line]


def _words(modes: Modes) -> list[str]:
    state = modes.state
    return [
        f"S{state.surface_m_min or state.spindle_rpm:.0f}",
        modes.plane,
        modes.side,
        "G91" if state.distance == "incremental" else "G90",
        FEED_MODES[state.feed_mode],
        state.work_system,
        "G43" if modes.has_length else "G49",
        "G98" if modes.to_initial else "G99",
        path_words(modes),
        "G96" if state.surface_m_min else "G97",
        "G90.1" if state.arc_centres == "absolute" else "G91.1",
        "G7" if modes.diameter else "G8",
    ]


def path_words(modes: Modes) -> str:
    """Return the words that select the path mode: "G61", "G64 P0.01 Q0"."""
    for call, word in PATHS.items():
        if call in modes.path_calls[0]:
            return word
    tolerance, naive = (call.rpartition(" ")[2].rpartition("(")[2].strip(")") for call in modes.path_calls)
    return f"G64 P{tolerance} Q{naive}"


def _switches(modes: Modes) -> list[str]:
    """Return the M codes of coolant and overrides, "" where there are none."""
    state, on = modes.state, modes.overrides
    feed_and_speed = {(True, True): "M48", (True, False): "M50", (False, True): "M51", (False, False): "M49"}
    return [
        "M7" if state.mist else "" if state.flood else "M9",
        "M8" if state.flood else "",
        feed_and_speed["feed" in on, "speed" in on],
        "M52" if "adaptive" in on else "",
        "M53" if "hold" in on else "",
    ]


MODE_ACTS: dict[str, Callable[[Block, Code], None]] = {
    act.__name__: act for act in (keep_modes, forget_modes, restore_modes)
}


def _level(block: Block) -> int:
    return block.model.parameters.level


PATH_MODES, RETRACT_MODES = frozenset(("G61", "G61.1", "G64")), frozenset(("G98", "G99"))
OVERRIDES = frozenset(("M48", "M49", "M50", "M51"))
OVERRIDE_WORDS = {  # by whether feed and spindle may be overridden; a program begins with both
    (True, True): "M48",
    (True, False): "M51 P0",
    (False, True): "M50 P0",
    (False, False): "M49",
}


def modal_words(model: Model, said: Set[str]) -> tuple[str, ...]:
    """Return the words of those modes in force that a program names; `said`: the names of its words."""
    modes = modes_of(model)
    path = (path_words(modes),) if said & PATH_MODES else ()
    retract = ("G98" if model.to_initial else "G99",) if said & RETRACT_MODES else ()
    allowed = "feed" in modes.overrides, "speed" in modes.overrides
    return *path, *retract, *((OVERRIDE_WORDS[allowed],) if said & OVERRIDES else ())
