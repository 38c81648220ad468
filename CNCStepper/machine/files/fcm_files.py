# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD CAM's machine files (.fcm, JSON): read into a profile's content, and written from a profile.

    machine.axes.X   type "linear", limits {min, max} in mm, max_velocity in mm/min, joint {origin, axis}
    machine.toolheads   toolhead_type "rotary", "laser", "plasma", "waterjet" ..., min_rpm, max_rpm, coolant
    postprocessor.file_name   "grbl", "linuxcnc" ...

Lengths are in mm whatever `units` says: that is how FreeCAD shows them. Older files have the limits beside the type,
`spindles` and `spindle_type`. What such a file does not have comes from the profile it is laid over: steps per mm,
accelerations, homing, ramps. Rotary axes have no place in a profile.
"""

from __future__ import annotations

import copy
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Place
from CNCStepper.machine.files.toml_reader import read_json
from CNCStepper.machine.profile import AXIS_NAMES, Machine

VERSION = 1
MOST_BYTES = 1_000_000
PROCESS_OF_TOOLHEAD = {"laser": "laser", "plasma": "plasma", "waterjet": "waterjet"}
TOOLHEAD_OF_PROCESS = {process: toolhead for toolhead, process in PROCESS_OF_TOOLHEAD.items()} | {"oxyfuel": "plasma"}
CONTROLLERS = ("grbl", "linuxcnc", "mach", "marlin")  # of a post-processor's name, where it is in it
DIRECTIONS = {"x": [1.0, 0.0, 0.0], "y": [0.0, 1.0, 0.0], "z": [0.0, 0.0, 1.0]}
W_OF_KW = 1000.0


def read_fcm(path: Path, base: Mapping[str, Any]) -> dict[str, Any]:
    """Return the content of a profile: what the file says over `base`, a profile's content.

    Raises JobError where the file is none, has not the axes X and Y (of a lathe X and Z), or bad limits.
    """
    whole = read_json(path, MOST_BYTES)
    machine = whole.get("machine", whole)
    axes = machine.get("axes") if isinstance(machine, dict) else None
    if not isinstance(machine, dict) or not isinstance(axes, dict):
        raise _refusal(path, "this is no machine file of FreeCAD: it has no axes")
    made = copy.deepcopy(dict(base))
    made["name"] = str(machine.get("name") or made.get("name", path.stem))
    present = {
        name.lower(): axis for name, axis in axes.items() if name.lower() in AXIS_NAMES and isinstance(axis, dict)
    }
    if "x" not in present or len(present) < 2:
        raise _refusal(path, "the machine has not the axes X and Y, or X and Z")
    made["axis"] = {name: _axis(path, made, name, present[name]) for name in AXIS_NAMES if name in present}
    heads = machine.get("toolheads") or machine.get("spindles") or []
    if isinstance(heads, list) and heads and isinstance(heads[0], dict):
        _take_toolhead(path, made, heads[0])
    controller = _controller(whole.get("postprocessor"))
    return made | ({"controller": controller} if controller else {})


def fcm_text(machine: Machine, description: str = "") -> str:
    """Return a profile as the text of a machine file of FreeCAD's."""
    axes = {name.upper(): _axis_entry(name, axis) for name, axis in machine.own_axes.items()}
    content = {
        "freecad_version": "1.2.0",
        "machine": {
            "name": machine.name,
            "manufacturer": "",
            "description": description,
            "units": "metric",
            "axes": axes,
            "toolheads": [_toolhead(machine)],
        },
        "version": VERSION,
        "postprocessor": {"file_name": machine.controller.partition(":")[0], "properties": {}},
        "output": {"units": "metric"},
        "processing": {"tool_change": machine.tool_change == "m6"},
    }
    return json.dumps(content, indent=4, ensure_ascii=False) + "\n"


def write_fcm(path: Path, machine: Machine, description: str = "") -> None:
    """Write a profile as a machine file of FreeCAD's, whole or not at all."""
    write_whole(path, fcm_text(machine, description).encode("utf-8"))


def _axis(path: Path, base: Mapping[str, Any], name: str, told: Mapping[str, Any]) -> dict[str, Any]:
    """Return an axis with the file's travel and speed; one that the base has not is made like its X."""
    axes = base.get("axis", {})
    axis = copy.deepcopy(axes.get(name) or axes.get("x") or {})
    given = told.get("limits")
    limits = given if isinstance(given, dict) else told
    values = {"travel_min_mm": limits.get("min"), "travel_max_mm": limits.get("max")}
    values["max_rate_mm_min"] = told.get("max_velocity")
    return axis | {key: _number(path, value) for key, value in values.items() if value is not None}


def _take_toolhead(path: Path, made: dict[str, Any], head: Mapping[str, Any]) -> None:
    kind = str(head.get("toolhead_type", head.get("spindle_type", "rotary")))
    made["processes"] = [PROCESS_OF_TOOLHEAD.get(kind, "milling")]
    coolant = [name for name in ("mist", "flood") if head.get(f"coolant_{name}") is True]
    made["outputs"] = {"coolant": coolant}
    made["tool_change"] = "m6" if head.get("tool_change") == "automatic" else made.get("tool_change", "pause")
    if head.get("max_rpm") or "spindle" in made or kind == "laser":
        made["spindle"] = _spindle(path, made.get("spindle", {"min_rpm": 0, "max_rpm": 1000}), head, kind)


def _spindle(path: Path, base: Mapping[str, Any], head: Mapping[str, Any], kind: str) -> dict[str, Any]:
    spindle = dict(base)
    for key in ("min_rpm", "max_rpm"):
        if head.get(key):
            spindle[key] = _number(path, head[key])
    if head.get("max_power_kw"):
        spindle["power_w"] = _number(path, head["max_power_kw"]) * W_OF_KW
    wait = head.get("toolhead_wait", head.get("spindle_wait"))
    if wait:
        spindle["spin_up_s"] = _number(path, wait)
    return spindle | {"laser": kind == "laser"}


def _controller(post: Any) -> str:
    name = str(post.get("file_name", "")).lower() if isinstance(post, dict) else ""
    return next((controller for controller in CONTROLLERS if controller in name), "")


def _axis_entry(name: str, axis: Any) -> dict[str, Any]:
    return {
        "type": "linear",
        "role": "head_linear" if name == "z" else "table_linear",
        "parent": None,
        "sequence": 0,
        "joint": {"origin": [0, 0, 0], "axis": DIRECTIONS[name]},
        "limits": {"min": axis.travel_min_mm, "max": axis.travel_max_mm},
        "max_velocity": axis.max_rate_mm_min,
    }


def _toolhead(machine: Machine) -> dict[str, Any]:
    spindle, process = machine.spindle, machine.processes[0]
    return {
        "name": "Spindle",
        "id": "toolhead1",
        "toolhead_type": TOOLHEAD_OF_PROCESS.get(process, "rotary"),
        "max_power_kw": spindle.power_w / W_OF_KW,
        "max_rpm": spindle.max_rpm if machine.has_spindle else 0,
        "min_rpm": spindle.min_rpm if machine.has_spindle else 0,
        "tool_change": "automatic" if machine.tool_change == "m6" else "manual",
        "coolant_flood": "flood" in machine.outputs.coolant,
        "coolant_mist": "mist" in machine.outputs.coolant,
        "coolant_delay": 0.0,
        "toolhead_wait": spindle.spin_up_s,
    }


def _number(path: Path, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise _refusal(path, "a limit, speed or power in the file is no number")
    return value


def _refusal(path: Path, what: str) -> JobError:
    advice = "save the machine again in FreeCAD's machine editor (CAM)"
    return JobError("fcm", what, advice=advice, place=Place(str(path)))
