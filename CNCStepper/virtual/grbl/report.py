# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports of the firmware: status, parameters, parser state, messages."""

from __future__ import annotations

from collections.abc import Iterable

from CNCStepper.units import inch_from_mm
from CNCStepper.virtual.grbl.board import Board
from CNCStepper.virtual.grbl.firmware import GRBL, Firmware
from CNCStepper.virtual.grbl.gcode.block import LAST_SYSTEM, PROBE_TOWARD, Modal, Parser, Z
from CNCStepper.virtual.grbl.gcode.words import f32
from CNCStepper.virtual.grbl.settings import INCHES, REPORTS_BUFFER, REPORTS_MPOS, Eeprom, Settings
from CNCStepper.virtual.grbl.states import BUSY


def fixed(value: float, decimals: int) -> str:
    """Return a number as the firmware prints it: halves up, in 32-bit steps, a minus even before zero."""
    scaled = f32(abs(value))
    for _ in range(decimals // 2):
        scaled = f32(scaled * 100)
    if decimals % 2:
        scaled = f32(scaled * 10)
    digits = str(int(f32(scaled + 0.5))).rjust(decimals + 1, "0")
    text = f"{digits[:-decimals]}.{digits[-decimals:]}" if decimals else digits
    return "-" + text if value < 0 else text


def coordinates(values_mm: Iterable[float], settings: Settings) -> str:
    """Return positions as the firmware prints them: three decimals, or four in inches."""
    if settings.on(INCHES):
        return ",".join(fixed(inch_from_mm(value), 4) for value in values_mm)
    return ",".join(fixed(value, 3) for value in values_mm)


def rate(value_mm_min: float, settings: Settings) -> str:
    """Return a speed as the firmware prints it: whole mm/min, or a decimal of an inch."""
    return fixed(inch_from_mm(value_mm_min), 1) if settings.on(INCHES) else fixed(value_mm_min, 0)


def work_offset(parser: Parser) -> list[float]:
    """Return machine minus work position, mm."""
    offset = [system + g92 for system, g92 in zip(parser.system_offset, parser.g92, strict=True)]
    offset[Z] += parser.tool_length
    return offset


def parser_state(parser: Parser, settings: Settings, firmware: Firmware = GRBL) -> str:
    """Return the answer to `$G`."""
    modal = parser.modal
    words = (
        _motion_word(modal),
        f"{_place_name(modal.system)} G{modal.plane} G{modal.units} G{modal.distance} G{modal.feed_mode}",
        *firmware.modes.format(modal).split(),
        f"M{modal.spindle} {_coolant_words(modal)} T{parser.tool}",
        f"F{rate(parser.feed, settings)} S{fixed(parser.rpm, 0)}{firmware.speed_dot}",
    )
    return f"[GC:{' '.join(words)}]"


def _place_name(place: int) -> str:
    return f"G{place}" if place <= LAST_SYSTEM else f"G{LAST_SYSTEM}.{place - LAST_SYSTEM}"


def _motion_word(modal: Modal) -> str:
    return f"G38.{modal.motion % 10}" if modal.motion >= PROBE_TOWARD else f"G{modal.motion}"


def _coolant_words(modal: Modal) -> str:
    return " ".join(word for word, on in (("M7", modal.mist), ("M8", modal.flood)) if on) or "M9"


def probe_result(position_mm: Iterable[float], found: bool, settings: Settings) -> str:
    """Return the `[PRB:]` line."""
    return f"[PRB:{coordinates(position_mm, settings)}:{int(found)}]"


def parameters(machine: Board) -> list[str]:
    """Return the answer to `$#`."""
    settings, parser = machine.memory.settings, machine.parser
    lines = [
        f"[{_place_name(place)}:{coordinates(values, settings)}]" for place, values in machine.memory.places.items()
    ]
    lines.append(f"[G92:{coordinates(parser.g92, settings)}]")
    lengths = [*[0.0] * (machine.firmware.tool_length_axes - 1), parser.tool_length]
    lines.append(f"[TLO:{coordinates(lengths, settings)}]")
    lines.append(probe_result(machine.axes.mm_of(machine.probe.contact_steps), machine.probe.found, settings))
    return lines


def build_info(memory: Eeprom, firmware: Firmware = GRBL) -> list[str]:
    """Return the answer to `$I`."""
    blocks = memory.settings.machine.planner.look_ahead_blocks
    return [line.format(memory.build_text, blocks) for line in firmware.build]


def status(machine: Board) -> str:
    """Return the answer to `?`."""
    fields = [machine.state_text(), _position(machine)]
    if machine.memory.settings.reports(REPORTS_BUFFER):
        fields.append(f"Bf:{machine.axes.free_blocks},{machine.ring.free}")
    speed_mm_min = machine.axes.rate_mm_min if machine.state in BUSY else 0.0
    fields.append(f"FS:{rate(speed_mm_min, machine.memory.settings)},{fixed(machine.spindle.rpm, 0)}")
    pins = machine.pins()
    if pins:
        fields.append(f"Pn:{pins}")
    fields += machine.own_fields()
    return f"<{'|'.join(fields + _occasional(machine))}>"


def _occasional(machine: Board) -> list[str]:
    busy, fields = machine.state in BUSY, []
    if machine.status.offset_is_due(busy):
        fields.append(f"WCO:{coordinates(work_offset(machine.parser), machine.memory.settings)}")
    if machine.status.overrides_are_due(busy):
        fields += _overrides(machine)
    return fields


def _position(machine: Board) -> str:
    settings, position = machine.memory.settings, machine.axes.position_mm
    if settings.reports(REPORTS_MPOS):
        return f"MPos:{coordinates(position, settings)}"
    offset = work_offset(machine.parser)
    return f"WPos:{coordinates((here - off for here, off in zip(position, offset, strict=True)), settings)}"


def _overrides(machine: Board) -> list[str]:
    overrides = machine.overrides
    outputs = {3: "S", 4: "C"}.get(machine.spindle.direction, "") + "F" * machine.flood + "M" * machine.mist
    return [f"Ov:{overrides.feed},{overrides.rapid},{overrides.spindle}", *([f"A:{outputs}"] if outputs else [])]
