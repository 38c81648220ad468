# SPDX-License-Identifier: LGPL-2.1-or-later
"""The G and M codes of RS274/NGC as data: modal group, words, and what each code sets.

Most codes only set fields of the modal snapshot; those are complete here. A code that does more names an
`act`, a function in `execute.ACTS`. `ORDER` is RS274's order of execution within one line.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

from CNCStepper.canned_cycle_expansion import CYCLE_NAMES, OWN_WORD
from CNCStepper.state import WORK_SYSTEMS
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, PLANE_NAMES, RAPID

NO_MOTION = 4  # G80: coordinates alone mean nothing
SPINDLE_CYCLES = ("G74", "G84", "G85", "G86", "G87", "G88", "G89")
PROBES = ("G38.2", "G38.3", "G38.4", "G38.5")
PROFILE_CYCLES = ("G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2")
SYNCHRONISED = ("G33", "G33.1", "G76")
SPLINES = ("G5", "G5.1")
MOTION_NAMES = (
    *("G0", "G1", "G2", "G3", "G80"),
    *CYCLE_NAMES,
    *SPINDLE_CYCLES,
    *SYNCHRONISED,
    *PROBES,
    *SPLINES,
    "G5.2",
    *PROFILE_CYCLES,
)
UNIT_CODES = {"mm": "G21", "inch": "G20"}
PLANE_CODES = ("G17", "G18", "G19")  # by the plane's number in the table
CODE_OF_PLANE = dict(zip(PLANE_NAMES, PLANE_CODES, strict=True))
CYCLES = frozenset(MOTION_NAMES.index(name) for name in (*CYCLE_NAMES, *SPINDLE_CYCLES))
ANY_PLANE = frozenset(map(MOTION_NAMES.index, ("G0", "G1", "G33", "G33.1", "G76", *PROBES)))  # lie in no plane
MORE_REPEATS = frozenset(MOTION_NAMES.index(name) for name in (*SYNCHRONISED, *PROBES, "G5.2"))
AXES = "XYZ"
ALL_AXES = "XYZABCUVW"
POLAR = "@^"  # distance and angle in the plane XY instead of X and Y
CENTRE_WORDS = "IJK"
ARC_WORDS = CENTRE_WORDS + "R"
SPINDLE = "$"  # the word that names a spindle
ORDER = (
    "spindle_mode",
    "feed_mode",
    "feed",
    "speed",
    "tool",
    "outputs",
    "tool_change",
    "spindle",
    "coolant",
    "overrides",
    "dwell",
    "plane",
    "units",
    "diameter",
    "compensation",
    "length",
    "work",
    "path",
    "distance",
    "arc_centres",
    "retract",
    "offsets",
    "motion",
    "stop",
)


@dataclass(frozen=True)
class Code:
    """One G or M code, or one of the words F, S and T, which act on their own.

    group: two codes of one modal group may not share a line. step: when it is executed, from `ORDER`.
    takes, needs: the letters it may use and those that must be there. axes: "" or how it uses the axis words:
    "may", "must". sets: fields of `State`. motion: the kind of move that it selects, for the lines after it too where
    it is `modal`.
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
    modal: bool = True


def _comment(text: str) -> tuple[str, ...]:
    return (f'COMMENT("interpreter: {text}")',)


def _moving(name: str, **more: Any) -> Code:
    return Code(name, "motion", "motion", motion=MOTION_NAMES.index(name), **more)


def _spindle_cycles() -> list[Code]:
    own = {"G74": "P", "G84": "PL", "G85": "L", "G86": "PL", "G87": "IJKL", "G88": "PL", "G89": "PL"}
    return [_moving(name, takes="R" + letters, axes="must") for name, letters in own.items()]


def _synchronised() -> list[Code]:
    return [
        _moving("G33", takes="K$", needs="K", axes="must"),
        _moving("G33.1", takes="IK$", needs="K", axes="must"),
        _moving("G76", takes="EHIJKLPQR$", needs="PIJK", axes="must"),
    ]


def _motion() -> list[Code]:
    return [
        Code("G0", "motion", "motion", axes="may", motion=RAPID),
        Code("G1", "motion", "motion", axes="may", motion=LINE),
        Code("G2", "motion", "motion", takes="IJKRP", axes="may", motion=ARC_CW),
        Code("G3", "motion", "motion", takes="IJKRP", axes="may", motion=ARC_CCW),
        Code("G80", "motion", "motion", motion=NO_MOTION, calls=_comment("motion mode set to none")),
        *(
            Code(name, "motion", "motion", takes="RL" + OWN_WORD[name], axes="must", motion=MOTION_NAMES.index(name))
            for name in CYCLE_NAMES
        ),
        *_spindle_cycles(),
        *_synchronised(),
        *(_moving(name, axes="must") for name in PROBES),
        _moving("G5", takes="IJPQ", axes="must", modal=False),
        _moving("G5.1", takes="IJ", axes="must", modal=False),
        _moving("G5.2", takes="PL", axes="may"),
        *(_moving(name, takes="DEIPQR", axes="may", modal=False) for name in PROFILE_CYCLES),
        Code("G98", "retract", "retract", act="retract", calls=_comment("retract mode set to old_z")),
        Code("G99", "retract", "retract", act="retract", calls=_comment("retract mode set to r_plane")),
    ]


def _modal() -> list[Code]:
    def modal(name: str, step: str, calls: tuple[str, ...] = (), act: str = "", **sets: Any) -> Code:
        return Code(name, step, step, sets=sets, calls=calls, act=act, silent=step in ("distance", "arc_centres"))

    distance = "distance mode changed to "
    far = ("SELECT_PLANE(CANON_PLANE_UNKNOWN)",)
    return [
        modal("G17", "plane", ("SELECT_PLANE(CANON_PLANE_XY)",), "plane", plane="XY"),
        modal("G18", "plane", ("SELECT_PLANE(CANON_PLANE_XZ)",), "plane", plane="ZX"),
        modal("G19", "plane", ("SELECT_PLANE(CANON_PLANE_YZ)",), "plane", plane="YZ"),
        modal("G20", "units", ("USE_LENGTH_UNITS(CANON_UNITS_INCHES)",), units="inch"),
        modal("G21", "units", ("USE_LENGTH_UNITS(CANON_UNITS_MM)",), units="mm"),
        Code("G17.1", "plane", "plane", act="other_plane", calls=far),
        Code("G18.1", "plane", "plane", act="other_plane", calls=far),
        Code("G19.1", "plane", "plane", act="other_plane", calls=far),
        modal("G7", "diameter", act="diameter"),
        modal("G8", "diameter", act="diameter"),
        modal("G40", "compensation", act="compensation_off"),
        Code("G41", "compensation", "compensation", takes="DL", act="compensation_by_tool"),
        Code("G42", "compensation", "compensation", takes="DL", act="compensation_by_tool"),
        Code("G41.1", "compensation", "compensation", takes="DLR", act="compensation_by_word"),
        Code("G42.1", "compensation", "compensation", takes="DLR", act="compensation_by_word"),
        modal("G61", "path", ("SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)",), "path", path_mode="exact_path"),
        modal("G61.1", "path", ("SET_MOTION_CONTROL_MODE(CANON_EXACT_STOP)",), "path", path_mode="exact_stop"),
        Code("G64", "path", "path", takes="PQ", sets={"path_mode": "blend"}, act="blend"),
        modal("G90", "distance", _comment(distance + "absolute"), distance="absolute"),
        modal("G91", "distance", _comment(distance + "incremental"), distance="incremental"),
        modal("G90.1", "arc_centres", _comment("IJK distance mode changed to absolute"), arc_centres="absolute"),
        modal("G91.1", "arc_centres", _comment("IJK distance mode changed to incremental"), arc_centres="incremental"),
        modal("G93", "feed_mode", (*_comment("feed mode set to inverse time"), "SET_FEED_MODE(0, 0)"), "feed_mode"),
        modal("G94", "feed_mode", (*_comment("feed mode set to units per minute"), "SET_FEED_MODE(0, 0)"), "feed_mode"),
        Code(
            *("G95", "feed_mode", "feed_mode", "$"),
            calls=(*_comment("feed mode set to units per revolution"), "SET_FEED_MODE(0, 1)"),
            act="feed_mode",
        ),
    ]


def _offsets() -> list[Code]:
    def once(name: str, act: str, **more: Any) -> Code:
        return Code(name, "offsets", "offsets", act=act, **more)

    systems = [Code(name, "work", "work", act="work_system") for name in WORK_SYSTEMS]
    return [
        *systems,
        Code("G4", "offsets", "dwell", takes="P", needs="P", act="dwell"),
        once("G10", "set_table", takes="LPRQIJ", needs="L", axes="may"),
        once("G28", "go_home", axes="may"),
        once("G28.1", "keep_home"),
        once("G30", "go_home", axes="may"),
        once("G30.1", "keep_home"),
        Code("G43", "length", "length", takes="H", act="tool_length"),
        Code("G43.1", "length", "length", axes="may", act="tool_length"),
        Code("G43.2", "length", "length", takes="H", act="tool_length"),
        Code("G49", "length", "length", act="tool_length"),
        once("G52", "set_g52", axes="must"),
        Code("G53", "offsets", "offsets"),  # the motion of its own line heeds it
        once("G5.3", "end_nurbs"),
        once("G92", "set_g92", axes="must"),
        once("G92.1", "clear_g92"),
        once("G92.2", "suspend_g92"),
        once("G92.3", "restore_g92"),
    ]


def _machine() -> list[Code]:
    def switch(name: str, step: str, *calls: str, **sets: Any) -> Code:
        return Code(name, step, step, sets=sets, calls=calls)

    def output(name: str, takes: str, step: str = "outputs", act: str = "output") -> Code:
        return Code(name, step, step, takes=takes, act=act)

    return [
        Code("M3", "spindle", "spindle", takes="$", act="spindle"),
        Code("M4", "spindle", "spindle", takes="$", act="spindle"),
        Code("M5", "spindle", "spindle", takes="$", act="spindle"),
        Code("M19", "spindle", "spindle", takes="PQR$", act="orient"),
        Code("G96", "spindle_mode", "spindle_mode", takes="D$", needs="S", act="surface_speed"),
        Code("G97", "spindle_mode", "spindle_mode", takes="$", act="turning_speed"),
        switch("M7", "coolant", "MIST_ON()", mist=True),
        switch("M8", "coolant", "FLOOD_ON()", flood=True),
        switch("M9", "coolant", "MIST_OFF()", "FLOOD_OFF()", mist=False, flood=False),
        Code("M6", "tool_change", "tool_change", act="tool_change"),
        Code("M61", "tool_change", "tool_change", takes="Q", act="tool_is"),
        *(output(f"M{number}", "P") for number in range(62, 66)),
        output("M66", "PELQ", act="wait_input"),
        output("M67", "EQ", act="analog_output"),
        output("M68", "EQ", act="analog_output"),
        *(output(f"M{number}", "P" if number > 49 else "", "overrides", "override") for number in range(48, 54)),
        Code("M70", "spindle", "spindle", act="keep_modes"),
        Code("M71", "spindle", "spindle", act="forget_modes"),
        Code("M72", "spindle", "spindle", act="restore_modes"),
        Code("M73", "spindle", "spindle", act="keep_modes"),
        Code("M0", "stop", "stop", act="stop"),
        Code("M1", "stop", "stop", act="stop"),
        Code("M60", "stop", "stop", act="stop"),
        Code("M2", "stop", "stop", act="end"),
        Code("M30", "stop", "stop", act="end"),
        Code(
            "M99", "stop", "stop", act="end"
        ),  # of a main program; that of a subprogram leads back (`run_with_subroutines.py`)
    ]


RS274 = MappingProxyType({code.name: code for code in (*_motion(), *_modal(), *_offsets(), *_machine())})

# of lathes whose language is no RS274/NGC
SPEED_LIMIT = Code("G50", "offsets", "spindle_mode", needs="S", axes="may", act="speed_limit")
TWO_BLOCK_CYCLES = tuple(
    _moving(name, takes=takes, axes="may", modal=False)
    for name, takes in (("G70", "PQ"), ("G71", "PQR"), ("G72", "PQR"), ("G73", "PQR"), ("G76", "PQR"))
)
LEAD_BY_FEED = Code("G32", "motion", "motion", axes="must", motion=MOTION_NAMES.index("G33"))

WORDS_THAT_ACT = MappingProxyType(
    {
        "F": Code("F", "F", "feed", act="feed"),
        "S": Code("S", "S", "speed", act="speed"),
        "T": Code("T", "T", "tool", act="tool"),
    }
)

ALONE = "is read as a line of its own, in a whole program, where the dialect has subroutines"
FLOW = MappingProxyType({"M98": ALONE, "M99": ALONE})
