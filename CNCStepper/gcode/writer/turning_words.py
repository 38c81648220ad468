# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a lathe's program: plane ZX, X as radius or diameter, feeds a turn.

LinuxCNC    G18, G7 (diameter) or G8 (radius), G95 while the spindle turns
mini-lathe  its own words for both; every coordinate from where the tool is after G91
fanuc-lathe X as the control is set, G99; mach-turn: the same with G95
others      G18, X as radius, feeds a minute
"""

from __future__ import annotations

from collections.abc import Sequence

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import RS274
from CNCStepper.gcode.writer.block_emitter import BlockEmitter
from CNCStepper.gcode.writer.write_options import WriteOptions
from CNCStepper.state import State
from CNCStepper.toolpath import ZX

MODES = {"diameter": RS274["G7"], "radius": RS274["G8"]}


def turned_words(words: Sequence[str], dialect: Dialect, options: WriteOptions) -> list[str]:
    """Return the words of a line of the header as a lathe's program has them."""
    words_of = {name: code for name, code in dialect.codes.items() if code in MODES.values()}
    own = [name for name, code in words_of.items() if code == MODES[options.x_is or "radius"]]
    instead = {"G17": "G18"} | dict.fromkeys(words_of, own[0] if own else "")
    if options.incremental:
        instead["G90"] = "G91"
    return [instead.get(word, word) for word in words]


def begin_turning(page: BlockEmitter, options: WriteOptions) -> None:
    """Leave out Y and bring the mode of X into force; raises ProgramError for diameters that a dialect lacks."""
    dialect = page.dialect
    page.without_y()
    if "G18" in dialect.codes:
        page.begin_in(ZX)
    word = {"diameter": "G7", "radius": "G8"}[options.x_is or "radius"]
    if dialect.codes.get(word) == RS274[word]:
        page.line(word)
    elif dialect.is_lathe:
        _require_own(dialect, options.x_is or "radius")
    elif options.x_is == "diameter" and MODES["diameter"] not in dialect.codes.values():
        what = Text("{dialect} has no word for X as a diameter", dialect=dialect.title)
        raise ProgramError("diameter", what, value="x_is = diameter", limit="radius", advice='write x_is = "radius"')
    if options.incremental and not dialect.starts_at_work_zero:
        what = Text("where the tool is when a program of {dialect} begins is not known", dialect=dialect.title)
        raise ProgramError("incremental", what, value="incremental", advice='write distance = "absolute"')
    page.x_factor = 2 if options.x_is == "diameter" else 1
    page.incremental = options.incremental
    if options.incremental:
        x, y, z = (page.grid.exact(1.0 / steps) if steps else 0.0 for steps in options.steps_per_mm)
        page.step_counts = (x, y, z)


def _require_own(dialect: Dialect, x_is: str) -> None:
    """Raise ProgramError where the control is set to the other meaning of X: no word of the text changes it."""
    own = "diameter" if dialect.diameter else "radius"
    if x_is != own:
        what = "{dialect} has no word for the meaning of X: the control is set to X as a {own}"
        name = dialect.name.partition(":")[0]
        advice = Text('write x_is = "{own}", or name the controller "{name}:x={x_is}"', own=own, name=name, x_is=x_is)
        raise ProgramError(
            "diameter", Text(what, own=own, dialect=dialect.title), value=f"x_is = {x_is}", limit=own, advice=advice
        )


def follow_feed_mode(page: BlockEmitter, state: State) -> None:
    """Write G95 or G99 before the first feed a turn, where the dialect has it; the header has feeds a minute."""
    per_turn = page.dialect.own_name("G95")
    if state.feed_mode == "per_turn" and state.spindle_rpm > 0 and per_turn:
        if not page.turn_rpm:
            page.line(per_turn)
        page.use_turn_feed(state.spindle_rpm)
