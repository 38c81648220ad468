# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that the controller reads the lines of a job as the proof did: they are sent unchanged.

G90 X40 Y0 F300      a cut at F300 in the language of thesis A, a rapid to grbl that has just begun
"""

from __future__ import annotations

from CNCStepper.control.protocol.grbl.firmware import FIRMWARES, Firmware
from CNCStepper.errors import MachineRefusal, Text


def check_dialect(dialect: str, firmware: Firmware) -> None:
    """Refuse a program that was read in another language than a controller's; raises MachineRefusal.

    dialect: "" is that of a job that nobody has read; its lines are the controller's own.
    """
    if dialect and dialect not in firmware.dialects:
        what = Text(
            "the program was read as {dialect}: to {firmware} its lines may mean other moves, or nothing",
            dialect=dialect,
            firmware=firmware.name,
        )
        raise _refusal(dialect, what, firmware)


def check_sendable(dialect: str, controller: str) -> None:
    """Refuse what the controller of a machine profile does not read, or no controller to which lines are sent.

    controller: as the profile names it; "" where there is none. Raises MachineRefusal.
    """
    named = next((firmware for firmware in FIRMWARES if firmware.key == controller), None)
    if named:
        check_dialect(dialect, named)
    elif not any(dialect in firmware.dialects for firmware in FIRMWARES):
        what = Text(
            "the program was read as {dialect}, which no controller understands that lines are sent to", dialect=dialect
        )
        raise _refusal(dialect, what, FIRMWARES[0])


def _refusal(dialect: str, what: str, firmware: Firmware) -> MachineRefusal:
    own = firmware.dialects[0]
    return MachineRefusal(
        "dialect-differs",
        what,
        value=dialect,
        limit=" or ".join(firmware.dialects),
        advice=Text(
            "write it in the controller's own: cncstepper convert PROGRAM --dialect {dialect} --to {own} -o NEW",
            dialect=dialect,
            own=own,
        ),
    )
