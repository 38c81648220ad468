# SPDX-License-Identifier: LGPL-2.1-or-later
"""The differences between grbl 1.1h, grblHAL and FluidNC, from their own sources.

Only the differences that a sender sees are here: greeting, `$I`, `$$`, `$G`, receive buffer, line length, a few
refusals, and grblHAL's M6, drilling cycles and work systems. All three plan and move as grbl does.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

AVR_PLANNING_S = 0.0005  # at 16 MHz, fitted to recordings of it
FAST_PLANNING_S = 0.00005  # a 32-bit processor of some 200 MHz; assumed, not measured
HELP = "[HLP:$$ $# $G $I $N $x=val $Nx=line $J=line $SLP $C $X $H ~ ! ? ctrl-x]"


@dataclass(frozen=True)
class Firmware:
    """One firmware; `build` is its answer to `$I`: {0} the text that `$I=` stored, {1} the planner's blocks.

    line_characters: without the line end, and without blanks unless blanks_count. modes: further words of `$G`, before
    the spindle's, {0} the modal words. shown_settings: numbers that `$$` lists, all where it is empty. read_only:
    settings stand in a file and cannot be written. named: settings by name, as the line reader leaves it: capitals, no
    `/`. message: what stands before its messages. systems: how many work systems, from G54 on. cycles: it has G73, G81
    to G83, G98 and G99. tool_state: M6 leads to the state Tool, see `tool_change`. mist: it has M7. digital_outputs:
    how many M62 to M65 switch, from P0 on.
    """

    name: str
    banner: str
    build: tuple[str, ...]
    receive_bytes: int = 128
    line_characters: int = 79
    blanks_count: bool = False
    largest_tool: int = 255
    shortest_pulse_us: int = 3
    modes: str = ""
    speed_dot: str = ""
    tool_length_axes: int = 1
    shown_settings: frozenset[int] = frozenset()
    read_only: bool = False
    named: Mapping[str, str] = field(default_factory=dict)
    message: str = ""
    systems: int = 6
    cycles: bool = False
    tool_state: bool = False
    mist: bool = False
    digital_outputs: int = 0
    planning_s: float = AVR_PLANNING_S


GRBL = Firmware("grbl", "Grbl 1.1h ['$' for help]", ("[VER:1.1h.20190830:{0}]", "[OPT:V,{1},128]"))
GRBLHAL = Firmware(
    "grblhal",
    "GrblHAL 1.1f ['$' or '$HELP' for help]",
    (
        "[VER:1.1f.20250225:{0}]",
        "[OPT:VNMSL,{1},1024,3,0]",
        "[AXS:3:XYZ]",
        "[NEWOPT:ENUMS,RT+,TC,SED]",
        "[FIRMWARE:grblHAL]",
        "[NVS STORAGE:*FLASH]",
        "[DRIVER:virtual]",
        "[DRIVER VERSION:250129]",
    ),
    receive_bytes=1023,
    line_characters=255,
    largest_tool=2**32 - 2,
    shortest_pulse_us=2,
    modes=" G49 G{0.retract} G50",
    speed_dot=".",
    tool_length_axes=3,
    systems=9,
    cycles=True,
    tool_state=True,
    mist=True,  # the M of its options
    planning_s=FAST_PLANNING_S,
)
FLUIDNC = Firmware(
    "fluidnc",
    "Grbl 3.7 [FluidNC v3.7.8 (wifi) '$' for help]",
    ("[VER:3.7 FluidNC v3.7.8:{0}]", "[OPT:PHS]", "[MSG:Machine: virtual]"),
    line_characters=254,
    blanks_count=True,
    largest_tool=99_999_999,
    shown_settings=frozenset({20, 21, 22, 23, 30, 32, *(n + axis for n in (100, 110, 120, 130) for axis in range(3))}),
    read_only=True,
    named={"$REPORT_INCHES": "$/report_inches=false"},
    message="INFO: ",
    planning_s=FAST_PLANNING_S,
)
FIRMWARES = {firmware.name: firmware for firmware in (GRBL, GRBLHAL, FLUIDNC)}
