# SPDX-License-Identifier: LGPL-2.1-or-later
"""The grbl parser, part one: a line becomes a block of words, each legal by itself.

Part two, `checks.py`, holds the block against the machine's state. Nothing changes until both have
passed. Written from grbl's documentation; the order of the tests is the firmware's, because it decides
which error a line with two faults gets.
"""

from __future__ import annotations

from CNCStepper.virtual.grbl.alarms_and_errors import refused
from CNCStepper.virtual.grbl.firmware import GRBL, Firmware
from CNCStepper.virtual.grbl.gcode.block import CYCLES, FIRST_SYSTEM, LAST_SYSTEM, AxisCommand, Block, Modal
from CNCStepper.virtual.grbl.gcode.words import read_words

GROUP_OF_G = {
    **dict.fromkeys((4, 10, 28, 30, 53, 92), "action"),
    **dict.fromkeys((0, 1, 2, 3, 38, 80), "motion"),
    **dict.fromkeys((17, 18, 19), "plane"),
    **dict.fromkeys((90, 91), "distance"),
    **dict.fromkeys((93, 94), "feed_mode"),
    **dict.fromkeys((20, 21), "units"),
    **dict.fromkeys((43, 49), "tool_length"),
    **dict.fromkeys((54, 55, 56, 57, 58, 59), "system"),
    40: "cutter",
    61: "path",
}
ONLY_FORMS = {28: (0, 10), 30: (0, 10), 92: (0, 10), 38: (20, 30, 40, 50), 43: (10,), 61: (0,), 90: (0,), 91: (0, 10)}
GROUP_OF_M = {**dict.fromkeys((0, 1, 2, 30), "flow"), **dict.fromkeys((3, 4, 5), "spindle"), 8: "coolant", 9: "coolant"}
NOT_NEGATIVE = "FNPTS"
VALUE_LETTERS = "FIJKLNPRSTXYZ"
CHANGE_TOOL, MIST = 6, 7
SWITCH_ON, SWITCH_OFF = (62, 64), (63, 65)  # in time with a move, which is not known here, or at once: at rest both
CYCLE_GROUPS = {**dict.fromkeys(CYCLES, "motion"), 98: "retract", 99: "retract"}  # where the firmware has cycles


def read_block(line: str, modal: Modal, firmware: Firmware = GRBL) -> Block:
    """Return the block of a line without blanks and comments, in capitals; `$J=` makes it a jog.

    Raises MachineRefusal with the firmware's code for the first word that is wrong.
    """
    jog = line.startswith("$")
    block = Block.after(modal, jog)
    for letter, value in read_words(line, len("$J=") if jog else 0):
        if letter == "G":
            _take_g(block, *_split(value), firmware)
        elif letter == "M":
            _take_m(block, *_split(value), firmware)
        else:
            _take_value(block, letter, value, firmware)
    block.unused = set(block.words)
    return block


def _split(value: float) -> tuple[int, int]:
    """Return a code's whole number and its hundredths, rounded."""
    number = int(value)
    return number, round(100 * (value - number))


def _take_g(block: Block, number: int, hundredths: int, firmware: Firmware) -> None:
    group = GROUP_OF_G.get(number) or (CYCLE_GROUPS.get(number) if firmware.cycles else None)
    if group is None:
        raise refused(20)
    if number == LAST_SYSTEM and hundredths in range(10, 10 * (FIRST_SYSTEM + firmware.systems - LAST_SYSTEM), 10):
        number, hundredths = LAST_SYSTEM + hundredths // 10, 0
    _claim_axes(block, number, hundredths)
    if number in ONLY_FORMS:
        if hundredths not in ONLY_FORMS[number]:
            raise refused(20)
    elif hundredths:
        raise refused(23)
    group = "centres" if (number, hundredths) == (91, 10) else group
    _enter_group(block, "G " + group)
    _set_g(block, group, number, hundredths)


def _claim_axes(block: Block, number: int, hundredths: int) -> None:
    """Note which command takes the axis words; two in one block are error 24."""
    if number in (10, 28, 30, 92):
        wanted = AxisCommand.NONE if hundredths else AxisCommand.ACTION
    elif number in (0, 1, 2, 3, 38, *CYCLES):
        wanted = AxisCommand.MOTION
    else:
        wanted = AxisCommand.TOOL_LENGTH if number in (43, 49) else AxisCommand.NONE
    if wanted is AxisCommand.NONE:
        return
    if block.axis_command is not AxisCommand.NONE:
        raise refused(24)
    block.axis_command = wanted


def _set_g(block: Block, group: str, number: int, hundredths: int) -> None:
    if group == "action":
        block.action = 10 * number + hundredths // 10
    elif group == "motion":
        block.modal.motion = 10 * number + hundredths // 10 if number == 38 else number
    elif group not in ("centres", "cutter", "path"):  # G91.1, G40 and G61 only say what is so anyway
        setattr(block.modal, group, number)


def _take_m(block: Block, number: int, hundredths: int, firmware: Firmware) -> None:
    if hundredths:
        raise refused(23)
    group = _group_of_m(number, firmware)
    if group is None:
        raise refused(20)
    _enter_group(block, "M " + group)
    if group == "spindle":
        block.modal.spindle = number
    elif group == "tool":
        block.changes_tool = True
    elif group == "output":
        block.switches = number in SWITCH_ON
    elif group == "coolant":
        block.modal.flood = number == 8 or (block.modal.flood and number == MIST)
        block.modal.mist = number == MIST or (block.modal.mist and number == 8)
    elif number != 1:  # the optional stop is read and ignored
        block.flow = number


def _group_of_m(number: int, firmware: Firmware) -> str | None:
    if number == CHANGE_TOOL and firmware.tool_state:
        return "tool"
    if number == MIST and firmware.mist:
        return "coolant"
    if number in (*SWITCH_ON, *SWITCH_OFF) and firmware.digital_outputs:
        return "output"
    return GROUP_OF_M.get(number)


def _enter_group(block: Block, group: str) -> None:
    if group in block.groups:
        raise refused(21)
    block.groups.add(group)


def _take_value(block: Block, letter: str, value: float, firmware: Firmware) -> None:
    if letter not in VALUE_LETTERS and not (letter == "Q" and firmware.cycles):
        raise refused(20)
    if letter == "T" and value > firmware.largest_tool:
        raise refused(38)
    if letter in block.words:
        raise refused(25)
    if value < 0 and letter in NOT_NEGATIVE:
        raise refused(4)
    block.words[letter] = value
