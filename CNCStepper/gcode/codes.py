# SPDX-License-Identifier: LGPL-2.1-or-later
"""The G and M codes of RS274/NGC as data: modal group, words, and what each code sets.

Most codes only set fields of the modal snapshot; those are complete here. A code that does more names an
`act`, a method of `execute.Execution`. `ORDER` is RS274's order of execution within one line.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

from CNCStepper.state import WORK_SYSTEMS
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID

NO_MOTION = 4  # G80: coordinates alone mean nothing
MOTION_NAMES = ("G0", "G1", "G2", "G3", "G80")
AXES = "XYZ"
ARC_WORDS = "IJKR"
ORDER = (
    "feed_mode",
    "feed",
    "speed",
    "tool",
    "tool_change",
    "spindle",
    "coolant",
    "dwell",
    "plane",
    "units",
    "compensation",
    "length",
    "work",
    "path",
    "distance",
    "arc_centres",
    "offsets",
    "motion",
    "stop",
)


@dataclass(frozen=True)
class Code:
    """One G or M code, or one of the words F, S and T, which act on their own.

    group: two codes of one modal group may not share a line. step: when it is executed, from `ORDER`.
    takes, needs: the letters it may use and those that must be there. axes: "" or how it uses X Y Z:
    "may", "must". sets: fields of `State`. motion: the kind of move that it selects.
    act: the method that does what `sets` cannot. calls: its canonical calls, as they are printed; a `silent` one
    is told only when it changed something.
    """

    name: str
    group: str
    step: str
    takes: str = ""
    needs: str = ""
    axes: str = ""
    sets: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))
    motion: int | None = None
    act: str = ""
    calls: tuple[str, ...] = ()
    silent: bool = False


def _comment(text: str) -> tuple[str, ...]:
    return (f'COMMENT("interpreter: {text}")',)


def _motion() -> list[Code]:
    return [
        Code("G0", "motion", "motion", axes="may", motion=RAPID),
        Code("G1", "motion", "motion", axes="may", motion=LINE),
        Code("G2", "motion", "motion", takes="IJKRP", axes="may", motion=ARC_CW),
        Code("G3", "motion", "motion", takes="IJKRP", axes="may", motion=ARC_CCW),
        Code("G80", "motion", "motion", motion=NO_MOTION, calls=_comment("motion mode set to none")),
    ]


def _modal() -> list[Code]:
    def modal(name: str, step: str, calls: tuple[str, ...] = (), act: str = "", **sets: Any) -> Code:
        return Code(name, step, step, sets=sets, calls=calls, act=act, silent=step in ("distance", "arc_centres"))

    distance = "distance mode changed to "
    return [
        modal("G17", "plane", ("SELECT_PLANE(CANON_PLANE_XY)",), plane="XY"),
        modal("G18", "plane", ("SELECT_PLANE(CANON_PLANE_XZ)",), plane="ZX"),
        modal("G19", "plane", ("SELECT_PLANE(CANON_PLANE_YZ)",), plane="YZ"),
        modal("G20", "units", ("USE_LENGTH_UNITS(CANON_UNITS_INCHES)",), units="inch"),
        modal("G21", "units", ("USE_LENGTH_UNITS(CANON_UNITS_MM)",), units="mm"),
        modal("G40", "compensation", _comment("cutter radius compensation off")),
        modal("G61", "path", ("SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)",), path_mode="exact_path"),
        modal("G61.1", "path", ("SET_MOTION_CONTROL_MODE(CANON_EXACT_STOP)",), path_mode="exact_stop"),
        Code("G64", "path", "path", takes="PQ", sets={"path_mode": "blend"}, act="blend"),
        modal("G90", "distance", _comment(distance + "absolute"), distance="absolute"),
        modal("G91", "distance", _comment(distance + "incremental"), distance="incremental"),
        modal("G90.1", "arc_centres", _comment("IJK distance mode changed to absolute"), arc_centres="absolute"),
        modal("G91.1", "arc_centres", _comment("IJK distance mode changed to incremental"), arc_centres="incremental"),
        modal("G93", "feed_mode", (*_comment("feed mode set to inverse time"), "SET_FEED_MODE(0, 0)"), "feed_mode"),
        modal("G94", "feed_mode", (*_comment("feed mode set to units per minute"), "SET_FEED_MODE(0, 0)"), "feed_mode"),
    ]


def _offsets() -> list[Code]:
    def once(name: str, act: str, **more: Any) -> Code:
        return Code(name, "offsets", "offsets", act=act, **more)

    systems = [Code(name, "work", "work", act="work_system") for name in WORK_SYSTEMS]
    return [
        *systems,
        Code("G4", "offsets", "dwell", takes="P", needs="P", act="dwell"),
        once("G10", "set_offset", takes="LP", needs="LP", axes="may"),
        once("G28", "go_home", axes="may"),
        once("G28.1", "keep_home"),
        once("G30", "go_home", axes="may"),
        once("G30.1", "keep_home"),
        Code("G43", "length", "length", takes="H", act="tool_length"),
        Code("G43.1", "length", "length", axes="may", act="tool_length"),
        Code("G49", "length", "length", act="tool_length"),
        Code("G53", "offsets", "offsets"),  # the motion of its own line heeds it
        once("G92", "set_g92", axes="must"),
        once("G92.1", "clear_g92"),
        once("G92.2", "suspend_g92"),
        once("G92.3", "restore_g92"),
    ]


def _machine() -> list[Code]:
    def switch(name: str, step: str, *calls: str, **sets: Any) -> Code:
        return Code(name, step, step, sets=sets, calls=calls)

    return [
        switch("M3", "spindle", "START_SPINDLE_CLOCKWISE(0)", spindle="cw"),
        switch("M4", "spindle", "START_SPINDLE_COUNTERCLOCKWISE(0)", spindle="ccw"),
        switch("M5", "spindle", "STOP_SPINDLE_TURNING(0)", spindle="off"),
        switch("M7", "coolant", "MIST_ON()", mist=True),
        switch("M8", "coolant", "FLOOD_ON()", flood=True),
        switch("M9", "coolant", "MIST_OFF()", "FLOOD_OFF()", mist=False, flood=False),
        Code("M6", "tool_change", "tool_change", act="tool_change"),
        Code("M0", "stop", "stop", act="stop", calls=("PROGRAM_STOP()",)),
        Code("M1", "stop", "stop", act="stop", calls=("OPTIONAL_PROGRAM_STOP()",)),
        Code("M2", "stop", "stop", act="end"),
        Code("M30", "stop", "stop", act="end"),
    ]


RS274 = MappingProxyType({code.name: code for code in (*_motion(), *_modal(), *_offsets(), *_machine())})

WORDS_THAT_ACT = MappingProxyType(
    {
        "F": Code("F", "F", "feed", act="feed"),
        "S": Code("S", "S", "speed", act="speed"),
        "T": Code("T", "T", "tool", act="tool"),
    }
)

NOT_YET = MappingProxyType(
    {
        "G5": "splines",
        "G5.1": "splines",
        "G7": "lathe diameter mode",
        "G8": "lathe radius mode",
        "G33": "spindle-synchronised motion",
        "G38.2": "probing",
        "G38.3": "probing",
        "G38.4": "probing",
        "G38.5": "probing",
        "G41": "cutter compensation",
        "G42": "cutter compensation",
        "G73": "canned cycles",
        "G76": "threading cycles",
        **{f"G{number}": "canned cycles" for number in range(81, 90)},
        "G98": "canned cycles",
        "G99": "canned cycles",
        "G95": "feed per revolution",
        "G96": "constant surface speed",
        "G97": "spindle speed modes",
        **{f"M{number}": "override switches" for number in (48, 49, 50, 51, 52, 53)},
        **{f"M{number}": "digital and analogue outputs" for number in range(62, 69)},
        "M19": "spindle orientation",
        "M60": "pallet change",
        "M98": "subroutines",
        "M99": "subroutines",
    }
)
