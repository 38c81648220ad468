# SPDX-License-Identifier: LGPL-2.1-or-later
"""The codes for the machine's inputs and outputs (M62 to M68) and for its overrides (M48 to M53)."""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects.codes import Code
from CNCStepper.gcode.interpreter.block import Block

DIGITAL = {
    "M62": "SET_MOTION_OUTPUT_BIT({})",
    "M63": "CLEAR_MOTION_OUTPUT_BIT({})",
    "M64": "SET_AUX_OUTPUT_BIT({})",
    "M65": "CLEAR_AUX_OUTPUT_BIT({})",
}
ANALOG = {"M67": "SET_MOTION_OUTPUT_VALUE", "M68": "SET_AUX_OUTPUT_VALUE"}
NO_WORD = -1.0  # what LinuxCNC puts out where Q is missing
INPUT_RESULT = 5399
OVERRIDES = {
    "M48": ("feed", "speed"),
    "M49": ("feed", "speed"),
    "M50": ("feed",),
    "M51": ("speed",),
    "M52": ("adaptive",),
    "M53": ("hold",),
}
OVERRIDE_CALLS = {
    "feed": "FEED_OVERRIDE()",
    "speed": "SPEED_OVERRIDE(0)",
    "adaptive": "ADAPTIVE_FEED()",
    "hold": "FEED_HOLD()",
}


def output(block: Block, code: Code) -> None:
    """M62 to M65: switch the digital output P."""
    block.must_have("P", code.name)
    block.uncompensated("no output may be set", code.name)
    number = round(block.value("P"))
    block.event("output", float(code.name in ("M62", "M64")), f"{code.name} P{number}")
    block.call(DIGITAL[code.name].format(number))


def analog_output(block: Block, code: Code) -> None:
    """M67, M68: give the analogue output E the value Q."""
    block.must_have("E", code.name)
    block.uncompensated("no output may be set", code.name)
    number = round(block.not_negative("E"))
    value = block.value("Q") if "Q" in block.plan.slots else NO_WORD
    block.event("output", value, f"{code.name} E{number} Q{value:g}")
    block.call(f"{ANALOG[code.name]}({number},{value:f})")


def wait_input(block: Block, code: Code) -> None:
    """M66: wait for an input; what it answers is not known before the program runs."""
    slots = block.plan.slots
    if ("P" in slots) == ("E" in slots):
        what = "M66 takes either P, a digital input, or E, an analogue one"
        raise ProgramError("input-words", what, value="M66", advice="write one of them")
    number = round(block.not_negative("P" if "P" in slots else "E"))
    way = block.whole("L", -(2**31), 2**31) if "L" in slots else 0
    seconds = block.value("Q") if "Q" in slots else NO_WORD
    if "L" in slots and way > 0 and seconds <= 0:
        raise ProgramError("missing-word", "M66 with L waits: it needs Q above 0", value="L", advice="add Q")
    if "E" in slots and way:
        raise ProgramError("bad-value", "an analogue input is only read, with L0", value="L", advice="drop L")
    block.uncompensated("no input may be read", code.name)
    block.event("input", max(0.0, seconds), f"M66 {'P' if 'P' in slots else 'E'}{number}")
    block.model.parameters.set(INPUT_RESULT, 0.0 if block.model.bare else float("nan"))


def override(block: Block, code: Code) -> None:
    """M48, M49: both overrides on or off; M50 to M53: one of them, off with P0."""
    off = code.name == "M49" or ("P" in block.plan.slots and block.value("P") == 0)
    block.uncompensated("overrides may not be switched", code.name)
    kinds = OVERRIDES[code.name]
    block.model.overrides = block.model.overrides - {*kinds} if off else block.model.overrides | {*kinds}
    block.event("override", float(not off), code.name)
    for kind in kinds:
        block.call(("DISABLE_" if off else "ENABLE_") + OVERRIDE_CALLS[kind])


OUTPUT_ACTS: dict[str, Callable[[Block, Code], None]] = {
    act.__name__: act for act in (output, analog_output, wait_input, override)
}
