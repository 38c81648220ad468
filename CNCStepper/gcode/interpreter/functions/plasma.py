# SPDX-License-Identifier: LGPL-2.1-or-later
"""QtPlasmaC's words: its tools (M3 $n), materials (M190, comments), the share of the feed and the torch's release.

    M3 $0 S1        torch; $1 scribe, $2 spotting; M5 $n stops it, M5 $-1 all     State.spindle, spindle_number
    M67 E3 Q60      60 % of the feed in force from the next move on, 0 all of it   State.feed_mm_min
    M62 P3          the torch is off, the motion continues; M63 P3 releases it     State.spindle
    M190 P7         material 7; M66 P3 L3 Q1 waits until it is taken               event "material"

The height control and the pierce are QtPlasmaC's own: no program moves Z or waits. Where the text has the material, the
table has its pierce delay behind M3.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects.codes import SPINDLE, Code
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.functions.outputs import OVERRIDE_CALLS, analog_output, output, wait_input
from CNCStepper.gcode.interpreter.functions.spindle import START, STOP, check_spindle
from CNCStepper.gcode.interpreter.state.interpreter_state import Plasma
from CNCStepper.gcode.syntax.material_comments import MaterialComment, read_material_comment
from CNCStepper.gcode.syntax.words import Comment
from CNCStepper.machine.qtplasmac_materials import LARGEST_NUMBER

ALL_TOOLS = -1
TORCH_OUTPUT, VELOCITY_OUTPUT = 3, 3  # of P in M62 to M65, of E in M67 and M68
MATERIAL_INPUT = 3
CHANGED_BY_QTPLASMAC = {  # parameters that let QtPlasmaC run other moves than the text has
    "holes": "QtPlasmaC changes feed and end of small holes itself: that is not in this reading",
    "pierce-only": "QtPlasmaC pierces only and cuts nothing: that is not in this reading",
    "keep-z-motion": "QtPlasmaC keeps the program's own moves of Z: they are not in this reading",
    "tube-cut": "QtPlasmaC cuts a tube, with the program's own moves of Z: they are not in this reading",
    "tube_cut": "QtPlasmaC cuts a tube, with the program's own moves of Z: they are not in this reading",
}


def plasma_of(block: Block) -> Plasma:
    """Return what QtPlasmaC's words have set so far."""
    assert block.model.plasma is not None  # of this dialect's models
    return block.model.plasma


def plasma_tool(block: Block, code: Code) -> None:
    """M3 $n: start the torch (0), the scribe (1) or the torch for a spot (2); M5 $n stops it, $-1 whichever runs."""
    check_spindle(block)
    number = int(block.value(SPINDLE)) if SPINDLE in block.plan.slots else 0
    plasma, state = plasma_of(block), block.model.state
    if code.name == "M5":
        if number in (ALL_TOOLS, plasma.tool):
            block.model.plasma = replace(plasma, tool=None)
            block.model.change(spindle="off")
        block.call(STOP)
        return
    if number == ALL_TOOLS:
        raise ProgramError("spindle-number", "M3 starts one tool", value=SPINDLE, limit="0 to 2", advice="name it")
    if plasma.tool is not None and plasma.tool != number:
        what = Text("the tool ${tool} still runs", tool=plasma.tool)
        raise ProgramError(
            "spindle-number", what, value=code.name, advice=Text("write M5 ${tool} before", tool=plasma.tool)
        )
    block.model.plasma = replace(plasma, tool=number)
    block.model.change(spindle="off" if plasma.cut_off else "cw", spindle_number=number, spindle_rpm=state.spindle_rpm)
    block.call(START["cw"])
    if number == 0 and plasma.pierce_s:
        block.event("dwell", plasma.pierce_s)


def plasma_output(block: Block, code: Code) -> None:
    """M62 to M65: P3 takes the torch off, or releases it; the other outputs stay outputs."""
    block.must_have("P", code.name)
    if round(block.value("P")) != TORCH_OUTPUT:
        output(block, code)
        return
    block.uncompensated("the torch cannot be switched off", code.name)
    plasma = replace(plasma_of(block), cut_off=code.name in ("M62", "M64"))
    block.model.plasma = plasma
    if plasma.tool is not None:
        block.model.change(spindle="off" if plasma.cut_off else "cw")


def velocity(block: Block, code: Code) -> None:
    """M67, M68 of E3: Q percent of the feed; up to 0 and from 100 all of it. Other outputs stay outputs."""
    block.must_have("E", code.name)
    if round(block.not_negative("E")) != VELOCITY_OUTPUT:
        analog_output(block, code)
        return
    block.uncompensated("the velocity may not be reduced", code.name)
    percent = block.value("Q") if "Q" in block.plan.slots else 0.0
    block.model.plasma = replace(plasma_of(block), share=percent / 100 if 0 < percent < 100 else 1.0)
    block.model.change(feed_mm_min=block.model.feed_number * block.model.scale * block.model.feed_share)


def adaptive_feed(block: Block, code: Code) -> None:
    """M52: lets QtPlasmaC reduce the velocity, and go back along the cut; P0 forbids it."""
    off = "P" in block.plan.slots and block.value("P") == 0
    block.model.overrides = block.model.overrides - {"adaptive"} if off else block.model.overrides | {"adaptive"}
    block.call(("DISABLE_" if off else "ENABLE_") + OVERRIDE_CALLS["adaptive"])


def material(block: Block, code: Code) -> None:
    """M190: take the material with the number P, or with P-1 the one that the operator has chosen."""
    number = block.whole("P", -1, LARGEST_NUMBER)
    known = plasma_of(block).materials.get(number)
    _use(block, known, known.text("mm") if known else f"M190 P{number}")


def material_wait(block: Block, code: Code) -> None:
    """M66 P3 L3: wait until the material is taken; other inputs stay inputs."""
    slots = block.plan.slots
    is_material = "P" in slots and block.value("P") == MATERIAL_INPUT and "L" in slots and block.value("L") == 3
    if not is_material:
        wait_input(block, code)
    elif "Q" not in slots or block.value("Q") <= 0:
        raise ProgramError("missing-word", "M66 with L waits: it needs Q above 0", value="L", advice="add Q")


PLASMA_ACTS: dict[str, Callable[[Block, Code], None]] = {
    act.__name__: act for act in (plasma_tool, plasma_output, velocity, adaptive_feed, material, material_wait)
}


# comments and parameters


def take_comments(block: Block, comments: tuple[Comment, ...]) -> tuple[Comment, ...]:
    """Take the materials that comments speak of; return the other comments. Raises ProgramError with its column."""
    others = []
    for comment in comments:
        try:
            found = None if comment.to_end else read_material_comment(comment.text, block.model.state.units)
        except ProgramError as error:
            raise error.at(Place(column=comment.column)) from None
        if found is None:
            others.append(comment)
        else:
            _keep(block, found)
    return tuple(others)


def _keep(block: Block, found: MaterialComment) -> None:
    """Use a temporary material; keep another by its number until M190 names it, and what goes into QtPlasmaC's file."""
    if found.option == 0:
        _use(block, found, found.text("mm"))
        return
    plasma = plasma_of(block)
    block.model.plasma = replace(plasma, materials={**plasma.materials, found.number: replace(found, option=None)})
    if found.option is not None:
        block.event("material", 0.0, found.text("mm"))


def _use(block: Block, known: MaterialComment | None, text: str) -> None:
    kerf_mm = known.values.get("kw", 0.0) if known else 0.0
    feed_mm_min, pierce_s = (known.feed_mm_min, known.values["pd"]) if known else (0.0, 0.0)
    plasma = replace(plasma_of(block), cut_feed_mm_min=feed_mm_min, kerf_mm=kerf_mm, pierce_s=pierce_s)
    block.model.plasma = plasma
    block.event("material", feed_mm_min, text)


def note_settings(block: Block, assignments: Iterable[tuple[int | str, float]]) -> None:
    """Warn of parameters that let QtPlasmaC run other moves than the text has."""
    for name, value in assignments:
        if value and name in CHANGED_BY_QTPLASMAC:
            block.event("warning", text=CHANGED_BY_QTPLASMAC[str(name)])
