# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool table: reading LinuxCNC's file of it, and the codes that use or change it (T, M6, M61, G43, G49, G10 L1).

A length lies along Z nearly always, but an entry has an offset for each of the nine axes.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects.codes import ALL_AXES, Code
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.state import stand_alone_position
from CNCStepper.gcode.interpreter.state.parameters import length_scale
from CNCStepper.machine.tools.linuxcnc_tool_table import line_words
from CNCStepper.state import ZERO9, ToolEntry

LARGEST_ORIENTATION = 9
USE_LENGTH = "USE_TOOL_LENGTH_OFFSET({} {} {}, {} {} {}, {} {} {})"


def read_tool_table(text: str, unit_mm: float = 1.0, file: str = "") -> dict[int, ToolEntry]:
    """Return the entries of a LinuxCNC tool table by tool number; `unit_mm` is the machine's own unit of length.

    Raises ProgramError at a line that names no tool or a tool twice.
    """
    tools: dict[int, ToolEntry] = {}
    for number, line in enumerate(text.splitlines(), start=1):
        items = dict(line_words(line)[0])
        if not items:
            continue
        if "T" not in items or int(float(items["T"])) in tools:
            what = "a line of a tool table names one tool, and no other line names it"
            raise ProgramError(
                "tool-table",
                what,
                value=items.get("T", ""),
                place=Place(file, number, 1),
                advice="write T and a number of its own in each line",
            )
        tools[int(float(items["T"]))] = _entry(items, unit_mm)
    return tools


def _entry(items: dict[str, str], unit_mm: float) -> ToolEntry:
    values = {letter: float(value) for letter, value in items.items()}
    offset = [values.get(letter, 0.0) * length_scale(axis, unit_mm) for axis, letter in enumerate(ALL_AXES)]
    return ToolEntry(
        pocket=int(values.get("P", 0)),
        offset_mm=tuple(offset),
        diameter_mm=values.get("D", 0.0) * unit_mm,
        front_deg=values.get("I", 0.0),
        back_deg=values.get("J", 0.0),
        orientation=int(values.get("Q", 0)),
    )


def entry_of(block: Block, tool: int, value: str) -> ToolEntry:
    """Return a tool's entry; raises ProgramError, which blames the word `value`, when the table has none."""
    if tool not in block.model.tools:
        what = Text("tool {tool} is not in the tool table", tool=tool)
        raise ProgramError("tool-length", what, value=value, advice="give the tool with the start state")
    return block.model.tools[tool]


def tool(block: Block, code: Code) -> None:
    """T: choose a tool, which some dialects load at once."""
    tool = _tool_number(block)
    if block.model.bare and tool:
        entry_of(block, tool, "T")
    block.model.selected_tool = tool
    if block.dialect.tool_word_changes:
        _load(block, tool)
    block.event("tool_select", tool)
    block.call(f"SELECT_TOOL({tool})")


def _tool_number(block: Block) -> int:
    """Return the tool of a T word; of a turret the one of its first two digits, whose offset has the same number."""
    largest = block.dialect.largest_tool
    if not block.dialect.turret:
        return block.whole("T", 0, largest, "tool-number")
    tool, offset = divmod(block.whole("T", 0, 100 * largest + largest, "tool-number"), 100)
    if tool != offset or not tool:
        what = "T holds two digits of the tool and two of its offset, which must be the same here"
        advice = Text("write T{number}, and keep the offset of the tool there", number=f"{tool or offset:02d}" * 2)
        raise ProgramError("tool-number", what, value="T", advice=advice)
    return tool


def tool_change(block: Block, code: Code) -> None:
    """M6: load the chosen tool; the spindle is stopped."""
    block.uncompensated("the tool may not be changed", code.name)
    tool = block.model.selected_tool
    block.model.change(spindle="off")
    _load(block, tool)
    block.event("tool_change", tool)
    for call in ("START_CHANGE()", "STOP_SPINDLE_TURNING(0)", f"CHANGE_TOOL({_place_in_table(block, tool)})"):
        block.call(call)


def tool_is(block: Block, code: Code) -> None:
    """M61: sets the number of the tool in the spindle; LinuxCNC's stand-alone interpreter continues with its length."""
    block.must_have("Q", code.name)
    tool = round(block.not_negative("Q"))
    if tool:
        entry_of(block, tool, "Q")
    loaded = block.model.loaded
    _load(block, tool)
    if block.model.bare:
        block.model.loaded = loaded
    block.event("tool_change", tool)
    block.call(f"CHANGE_TOOL_NUMBER({_place_in_table(block, tool)})")


def _load(block: Block, tool: int) -> None:
    block.model.change(tool=tool)
    block.model.loaded = block.model.tools.get(tool, ToolEntry())
    block.asks_position = True


def _place_in_table(block: Block, tool: int) -> int:
    """Return the line of a tool in the table, from 1; 0 for no tool."""
    return [0, *block.model.tools].index(tool) if tool in block.model.tools else tool


def tool_length(block: Block, code: Code) -> None:
    """G43, G43.1, G43.2, G49: the offset of the tool that is in force from now on."""
    block.uncompensated("the tool offset may not be changed", code.name)
    model = block.model
    offset = {"G43": _table_offset, "G43.1": _given_offset, "G43.2": _more_offset, "G49": _no_offset}[code.name](block)
    stand_alone_position.offset_changes(model, offset)
    model.tool_offset = offset
    model.change_offset()
    block.point(USE_LENGTH, offset)


def _no_offset(block: Block) -> tuple[float, ...]:
    return ZERO9


def _table_offset(block: Block) -> tuple[float, ...]:
    model = block.model
    if "H" not in block.plan.slots and model.bare:
        return model.loaded.offset_mm
    tool = block.whole("H", 0, block.dialect.largest_tool) if "H" in block.plan.slots else model.state.tool
    if not tool and block.dialect.tool_offsets_sideways:
        return model.loaded.offset_mm  # LinuxCNC's tool 0 is the one in the spindle
    return entry_of(block, tool, "G43").offset_mm if tool else ZERO9


def _given_offset(block: Block) -> tuple[float, ...]:
    words = block.axis_words()
    if not block.dialect.tool_offsets_sideways:
        for axis in (0, 1):
            if axis in words:
                letter = ALL_AXES[axis]
                raise ProgramError(
                    "unused-word",
                    "a tool length lies along Z only",
                    value=letter,
                    advice=Text("drop {letter}", letter=letter),
                )
    return tuple(words.get(axis, old) for axis, old in enumerate(block.model.tool_offset))


def _more_offset(block: Block) -> tuple[float, ...]:
    """G43.2: adds the offset of the tool H to the one in force."""
    block.must_have("H", "G43.2")
    if block.axis_words():
        what = "G43.2 takes H, and a line with it takes no axis words"
        raise ProgramError("axis-conflict", what, value="G43.2", advice="write them on two lines")
    tool = block.whole("H", 0, block.dialect.largest_tool)
    more = entry_of(block, tool, "H").offset_mm if tool else ZERO9
    return tuple(old + added for old, added in zip(block.model.tool_offset, more, strict=True))


def set_tool(block: Block, kind: int) -> None:
    """G10 L1: an entry of the table; L10, L11: the one with which the position has the given coordinates."""
    if kind == 0:
        raise ProgramError("not-supported", "the tool table cannot be read again", value="L", advice="drop the line")
    block.must_have("P", "G10")
    number = block.whole("P", 1, block.dialect.largest_tool)
    entry = entry_of(block, number, "P")
    if not (block.axis_words() or block.plan.has("RQIJ")):
        raise ProgramError(
            "missing-word", Text("G10 L{kind} changes nothing", kind=kind), value="G10", advice="add what it is to set"
        )
    entry = replace(entry, offset_mm=_new_offset(block, entry, kind), **_measures(block))
    model = block.model
    model.tools = {**model.tools, number: entry}
    _emit_entry(block, _place_in_table(block, number), number, entry)
    if number == model.state.tool or (model.bare and not model.state.tool and _place_in_table(block, number) == 1):
        model.loaded = entry
        _emit_entry(block, 0, number, entry)


def _measures(block: Block) -> dict[str, Any]:
    """Return the fields that R, I, J and Q set."""
    slots = block.plan.slots
    fields: dict[str, Any] = {}
    if "R" in slots:
        fields["diameter_mm"] = 2.0 * block.value("R") * block.model.scale
    for letter, field in (("I", "front_deg"), ("J", "back_deg")):
        if letter in slots:
            fields[field] = block.value(letter)
    if "Q" in slots:
        fields["orientation"] = block.whole("Q", 0, LARGEST_ORIENTATION)
    return fields


def _new_offset(block: Block, entry: ToolEntry, kind: int) -> tuple[float, ...]:
    words = block.axis_words()
    offset = list(entry.offset_mm)
    if kind == 1:
        return tuple(words.get(axis, old) for axis, old in enumerate(offset))
    for axis in words:
        block.known(axis)
    without = block.model.copy()
    if kind == 11:  # measured in G59.3, without G92
        without.g92 = ZERO9
        without.use_system("G59.3")
    without.tool_offset = ZERO9
    without.change_offset()
    here = (*without.work(without.position), *without.further_work())
    wanted = [here[axis] - words[axis] if axis in words else offset[axis] for axis in range(9)]
    turn = without.turn or 1.0
    if {0, 1} & set(words):
        old = complex(*offset[:2]) / turn  # along the turned axes
        flat = complex(wanted[0] if 0 in words else old.real, wanted[1] if 1 in words else old.imag) * turn
        wanted[:2] = flat.real, flat.imag
    return tuple(wanted)


def _emit_entry(block: Block, place: int, number: int, entry: ToolEntry) -> None:
    """Emit an entry in the machine's own unit."""
    unit = block.model.unit_mm
    offset = " ".join(f"{value / length_scale(axis, unit):.4f}" for axis, value in enumerate(entry.offset_mm))
    angles = f"{entry.front_deg:.4f}, {entry.back_deg:.4f}, {entry.orientation}"
    block.call(f"SET_TOOL_TABLE_ENTRY({place}, {number}, {offset}, {angles})")


TOOL_ACTS: dict[str, Callable[[Block, Code], None]] = {
    act.__name__: act for act in (tool, tool_change, tool_is, tool_length)
}
