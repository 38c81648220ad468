# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties of a wire line before it is sent: whether it may be sent, and how to wait for it."""

from __future__ import annotations

import re

from CNCStepper.control.protocol.grbl.firmware import Firmware
from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.syntax.words import code_pattern, packed_wire
from CNCStepper.machine.pulse_letters import COMMAND as LETTERS

ARCS = ("G2", "G3")  # a line of no more than that is refused
# Bytes that act at once wherever they stand: ! ? ~, controls, all above 0x7e.
_ACTING = re.compile(r"[^ \"->@-}]")
_MOVE = re.compile(r"(?:N\d+)?(?:G0?[0-3](?![\d.]))?[XYZIJKRF\d.+-]*")
_STORING = re.compile(code_pattern("G", r"10(?:\.0*)?|28\.10*|30\.10*"))
_PAUSE = re.compile(code_pattern("M", "0|6"))
_TOOL_CHANGE = re.compile(code_pattern("M", "6"))
_ONLY_PAUSE = re.compile(r"(?:N\d+)?M0+")
_DWELL = re.compile(code_pattern("G", "4"))
_SECONDS = re.compile(r"P(\d*\.?\d*)")


def is_plain(text: str) -> bool:
    """Return whether a line passes `check_line`."""
    return _ACTING.search(text) is None


def check_line(text: str, place: Place | None = None) -> None:
    """Refuse a line that is not plain ASCII or holds a byte that acts at once.

    Raises ProgramError naming `place` and the column.
    """
    if found := _ACTING.search(text):
        where = Place(place.file, place.line, found.start() + 1) if place else None
        raise ProgramError(
            "acting-byte",
            Text("the character {found} would act as a command of its own or is not ASCII", found=ascii(found[0])),
            advice="remove it; only plain ASCII without ? ! ~ may be sent",
            place=where,
        )


def check_length(text: str, firmware: Firmware, window_bytes: int, place: Place | None = None) -> None:
    """Refuse a line that is longer than the firmware can read, or than its receive buffer with the line end.

    Raises ProgramError naming `place`.
    """
    length = len(text) if firmware.blanks_count else len(text) - text.count(" ")
    if length > firmware.line_characters or len(text) >= window_bytes:
        raise ProgramError(
            "line-too-long",
            Text("the line is longer than {firmware} can read", firmware=firmware.name),
            value=Text("{length} characters, {text} with spaces", length=length, text=len(text)),
            limit=Text(
                "{line_characters} characters, {window_bytes} with spaces",
                line_characters=firmware.line_characters,
                window_bytes=window_bytes - 1,
            ),
            advice="shorten or split that line",
            place=place,
        )


def is_move(text: str) -> bool:
    """Return whether a line is certainly a plain move, which is not waited for; fast, because nearly all lines are."""
    return _MOVE.fullmatch(text) is not None


def stores(text: str) -> bool:
    """Return whether a line writes the controller's permanent memory, and so must be sent alone."""
    plain = packed_wire(text)
    if plain.startswith("$"):
        return "=" in plain and not plain.startswith(("$J=", LETTERS))
    return bool(_STORING.search(plain))


def needs_idle(text: str) -> bool:
    """Return whether a line is a `$` command, which grbl takes only while it is idle; pulse letters are moves."""
    plain = packed_wire(text)
    return plain.startswith("$") and not plain.startswith(LETTERS)


def pauses(text: str) -> bool:
    """Return whether a line holds M0, or M6, at which grblHAL waits for a new tool."""
    return bool(_PAUSE.search(packed_wire(text)))


def changes_tool(text: str) -> bool:
    """Return whether a line holds M6."""
    return "6" in text and bool(_TOOL_CHANGE.search(packed_wire(text)))


def only_pauses(text: str) -> bool:
    """Return whether a line is an M0 and nothing else, so that a sender can make the pause itself."""
    return bool(_ONLY_PAUSE.fullmatch(packed_wire(text)))


def dwell_s(text: str) -> float:
    """Return how long a G4 line keeps its answer back, in s; 0 for any other line."""
    seconds = _SECONDS.search(packed_wire(text))
    return float(seconds[1]) if seconds and seconds[1].strip(".") and is_dwell(text) else 0.0


def is_dwell(text: str) -> bool:
    """Return whether a line holds G4."""
    return bool(_DWELL.search(packed_wire(text)))
