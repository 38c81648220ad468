# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC with QtPlasmaC: the torch's height, pierce and cut data are QtPlasmaC's own, by the material chosen.

Its words are in `interpreter/functions/plasma.py`; moves of Z are taken out, as its own filter does it.
"""

from dataclasses import replace

from CNCStepper.gcode.dialects.codes import Code
from CNCStepper.gcode.dialects.definition import Writing, changed, same_advice
from CNCStepper.gcode.dialects.linuxcnc import LINUXCNC

MATERIAL = Code("M190", "material", "outputs", takes="P", needs="P", act="material")
_PLANES = ("G18", "G19", "G17.1", "G18.1", "G19.1")
_CODES = {name: code for name, code in LINUXCNC.codes.items() if name not in ("M4", *_PLANES)}
_CHANGED = (
    *(changed(name, act="plasma_tool") for name in ("M3", "M5")),
    *(changed(f"M{number}", act="plasma_output") for number in range(62, 66)),
    *(changed(name, act="velocity") for name in ("M67", "M68")),
    changed("M52", act="adaptive_feed"),
    changed("M66", act="material_wait"),
    MATERIAL,
)

QTPLASMAC = replace(
    LINUXCNC,
    name="qtplasmac",
    title="LinuxCNC with QtPlasmaC",
    codes={**_CODES, **{code.name: code for code in _CHANGED}},
    letters=LINUXCNC.letters.replace("Z", ""),
    refused={
        **{name: advice for name, advice in LINUXCNC.refused.items() if name != "M190"},
        **same_advice(_PLANES, "QtPlasmaC moves Z itself: arcs are in XY"),
        "M4": "start the torch with M3 $0 S1, the scribe with M3 $1 S1, a spot with M3 $2 S1",
    },
    writing=Writing(
        header=("{units} G17 G90 G91.1", "G40 G49 G80 G92.1 G94 G97", "M52 P1", "M68 E3 Q0"),
        footer=("M5 $-1", "M9", "M68 E3 Q0", "M2"),
        units={"mm": "G21 G64 P0.02", "inch": "G20 G64 P0.0008"},
        tool_change=("pause", "split", "m6"),
        work_systems=LINUXCNC.writing.work_systems if LINUXCNC.writing else (),
        lifts=False,
    ),
    front=("without_height",),
    has_z=False,
    plasma=True,
    spindles=3,
)
