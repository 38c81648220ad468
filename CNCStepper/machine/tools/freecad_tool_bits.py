# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's tool bits (`.fctb`) and libraries (`.fctl`), as FreeCAD 0.20 to 1.1 write them: JSON, lengths with units.

    library   { "tools": [{"nr": 1, "path": "5mm_Endmill.fctb"}, ...] }     bits beside it, or in ../Bit
    bit       { "name": ..., "shape": "endmill.fcstd", "parameter": {"Diameter": "5.0000 mm", ...}, "attribute": {} }

A bit's keys that we do not have (its whole length, its shank) are kept and written back. Ours that FreeCAD does not
have (feeds, flutes' load) stand in a table of their own, "CNCStepper", which FreeCAD passes over.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import is_there
from CNCStepper.machine.files.toml_reader import read_json
from CNCStepper.machine.tools.stored_tool import StoredTool, given_keys, tool_or_note
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.quantities import Bounds, shown
from CNCStepper.safe_text import printable

OURS = "CNCStepper"
SHAPES = {  # FreeCAD's name of a shape -> ours
    "endmill": "flat",
    "ballend": "ball",
    "bullnose": "bullnose",
    "v-bit": "v",
    "vbit": "v",
    "chamfer": "v",
    "drill": "drill",
}
WRITTEN = {  # ours -> FreeCAD's, and the type that FreeCAD 1.1 wants beside it
    "flat": ("endmill", "Endmill"),
    "ball": ("ballend", "Ballend"),
    "bullnose": ("bullnose", "Bullnose"),
    "v": ("v-bit", "VBit"),
    "engraver": ("v-bit", "VBit"),
    "drill": ("drill", "Drill"),
}
LENGTHS = {
    "Diameter": "diameter_mm",
    "CuttingEdgeHeight": "flute_length_mm",
    "TipDiameter": "tip_diameter_mm",
    "CornerRadius": "corner_radius_mm",
    "TorusRadius": "corner_radius_mm",
}
ANGLES = {"CuttingEdgeAngle": "tip_angle_deg", "TipAngle": "point_angle_deg"}
UNITS_MM = {
    "mm": 1.0,
    "": 1.0,
    "cm": 10.0,
    "m": 1000.0,
    "um": 0.001,
    "µm": 0.001,
    "in": 25.4,
    '"': 25.4,
    "thou": 0.0254,
}
MOST_BYTES, MOST_TOOLS = 4_000_000, 10_000
MOST_NAME = 200
LONGEST_NUMBER = 60  # characters of a quantity with its unit
QUANTITY = re.compile(r"\s*([-+]?[\d.,]+(?:e[-+]?\d+)?)\s*(.*?)\s*", re.IGNORECASE)


def read_bit(path: Path, number: int = 1) -> StoredTool:
    """Return the tool of a `.fctb` file; raises JobError for a file that is none."""
    content = _json(path)
    if not isinstance(content.get("parameter"), dict) or "shape" not in content:
        what = "not a tool bit: it has no shape or no parameter"
        advice = "save it again in FreeCAD's tool bit editor (CAM)"
        raise JobError("tool-bit", what, place=Place(str(path)), advice=advice)
    for key in ("attribute", OURS):
        if not isinstance(content.get(key) or {}, dict):
            what = Text("not a tool bit: its {key} is no object", key=key)
            advice = "save it again in FreeCAD's tool bit editor (CAM)"
            raise JobError("tool-bit", what, place=Place(str(path)), advice=advice)
    name, kind = _text(content.get("name", path.stem)), _shape_of(content)
    if kind not in SHAPES:
        return StoredTool(
            number,
            name,
            None,
            content,
            (Text("its shape '{kind}' is none of {shapes}", kind=kind, shapes=", ".join(SHAPES)),),
        )
    try:
        keys = _keys(content, SHAPES[kind])
    except ValueError as error:
        return StoredTool(number, name, None, content, (str(error),))
    tool, notes = tool_or_note({"number": number, **keys})
    return StoredTool(number, name, tool, content, notes)


def write_bit(stored: StoredTool, path: Path) -> None:
    """Write a tool as `.fctb`: the keys of its original file, overwritten by the tool's own values."""
    write_whole(path, (json.dumps(_bit(stored), indent=2, ensure_ascii=True) + "\n").encode("ascii"))


def read_library(path: Path) -> list[StoredTool]:
    """Return the tools of a `.fctl` file; a bit that is not found is one without a tool."""
    content = _json(path)
    tools, place = content.get("tools"), Place(str(path))
    if not isinstance(tools, list):
        advice = "save it again in FreeCAD's tool library editor (CAM)"
        raise JobError("tool-library", "not a tool library: it has no list of tools", place=place, advice=advice)
    if len(tools) > MOST_TOOLS:
        value, limit = f"{len(tools)}", f"{MOST_TOOLS}"
        what, advice = "the library has too many tools", "split the file"
        raise JobError("tool-library", what, value=value, limit=limit, place=place, advice=advice)
    return [_listed(entry, path) for entry in tools]


def bit_files(tools: list[StoredTool], path: Path) -> list[Path]:
    """Return the files of a library's bits, one a tool."""
    names = (re.sub(r'[\\/:*?"<>|]+', "_", stored.name).strip() or "tool" for stored in tools)
    return [_bit_folder(path) / f"{stored.number}_{name}.fctb" for stored, name in zip(tools, names, strict=True)]


def write_library(tools: list[StoredTool], path: Path) -> list[Path]:
    """Write a `.fctl` and a `.fctb` for each tool beside it (in ../Bit for a library of FreeCAD's); return the bits."""
    _bit_folder(path).mkdir(parents=True, exist_ok=True)
    bits = bit_files(tools, path)
    for stored, bit in zip(tools, bits, strict=True):
        write_bit(stored, bit)
    entries = [{"nr": stored.number, "path": bit.name} for stored, bit in zip(tools, bits, strict=True)]
    content = {"label": path.stem, "tools": entries, "version": 1}
    write_whole(path, (json.dumps(content, indent=2) + "\n").encode("utf-8"))
    return bits


def quantity(text: Any, units: dict[str, float]) -> float:
    """Return a number with its unit, "5.0000 mm" or "0.375 in", in ours; raises ValueError for anything else."""
    plain = isinstance(text, str | int | float) and not isinstance(text, bool)
    words = text if isinstance(text, str) else shown(text)
    match = QUANTITY.fullmatch(words) if plain and len(words) <= LONGEST_NUMBER else None
    if match is None or match[2] not in units:
        raise ValueError(Text("'{words}' is no length or angle that is known", words=printable(words, LONGEST_NUMBER)))
    return float(match[1].replace(",", ".")) * units[match[2]]


def _json(path: Path) -> dict[str, Any]:
    return read_json(path, MOST_BYTES)


def _text(value: Any) -> str:
    """Return what should be a text, as one that can be shown."""
    return printable(value, MOST_NAME) if isinstance(value, str) else shown(value)


def _shape_of(content: dict[str, Any]) -> str:
    """Return FreeCAD's name of the shape, without folder and ending."""
    name = _text(content["shape"]).replace("\\", "/").rpartition("/")[2]
    return name.lower().removesuffix(".fcstd")


def _keys(content: dict[str, Any], shape: str) -> dict[str, Any]:
    """Return our keys of a bit; raises ValueError for a value that is no quantity."""
    parameter = {**content["parameter"], **(content.get("attribute") or {})}
    keys: dict[str, Any] = {"shape": shape}
    wanted = {**LENGTHS, **ANGLES}
    own = {"bullnose": "corner_radius_mm", "v": "tip_", "drill": "point_"}.get(shape, "-")
    for theirs, ours in wanted.items():
        if theirs in parameter and (ours in ("diameter_mm", "flute_length_mm") or ours.startswith(own)):
            keys[ours] = quantity(parameter[theirs], UNITS_MM if theirs in LENGTHS else {"°": 1.0, "deg": 1.0, "": 1.0})
    flat = shape == "bullnose" and "FlatRadius" in parameter
    if flat and "diameter_mm" in keys and "corner_radius_mm" not in keys:
        keys["corner_radius_mm"] = keys["diameter_mm"] / 2.0 - quantity(parameter["FlatRadius"], UNITS_MM)
    if str(parameter.get("Flutes", "")).strip().isdigit():
        keys["flutes"] = int(parameter["Flutes"])
    if str(parameter.get("Material", "")).lower() in ("hss", "carbide"):
        keys["made_of"] = str(parameter["Material"]).lower()
    return keys | {key: value for key, value in (content.get(OURS) or {}).items() if key != "number"}


def _bit(stored: StoredTool) -> dict[str, Any]:
    raw = stored.raw if "parameter" in stored.raw else {}  # else it is that of another kind of file
    content: dict[str, Any] = {"version": 2, "attribute": {}, **raw, "name": stored.name or "tool"}
    if stored.tool is None:
        return content
    tool = stored.tool
    if tool.shape not in WRITTEN:
        what = Text("FreeCAD has no tool bit for a {tool_shape}", tool_shape=tool.shape)
        advice = "leave it out, or save the tools in a file of another kind"
        raise JobError("tool-shape", what, value=stored.name, advice=advice)
    if not raw:
        shape, kind = WRITTEN[tool.shape]
        content |= {"shape": f"{shape}.fcstd", "shape-type": kind}
    parameter = dict(raw.get("parameter", {}))
    said = _keys({"parameter": parameter}, SHAPES[_shape_of(content)])
    parameter |= _parameters(tool, said)
    said = _keys({"parameter": parameter}, SHAPES[_shape_of(content)])
    ours = {
        key: value for key, value in given_keys(tool).items() if key != "number" and not _same(said.get(key), value)
    }
    content["parameter"] = dict(sorted(parameter.items()))
    content.pop(OURS, None)
    return content | ({OURS: ours} if ours else {})


def _parameters(tool: Tool, said: dict[str, Any]) -> dict[str, str]:
    """Return FreeCAD's parameters for values of the tool that differ from the bit or that the bit lacks."""
    found = {"Flutes": str(tool.flutes)} if tool.flutes and tool.flutes != said.get("flutes") else {}
    for theirs, ours in (*LENGTHS.items(), *ANGLES.items()):
        value = getattr(tool, ours)
        if theirs != "TorusRadius" and value and not _same(said.get(ours), value):
            found[theirs] = f"{value:.4f} \u00b0" if theirs in ANGLES else f"{value:.4f} mm"
    return found


def _same(one: Any, other: Any) -> bool:
    numbers = isinstance(one, int | float) and isinstance(other, int | float)
    return abs(one - other) < 1e-9 if numbers else one == other


def _listed(entry: Any, library: Path) -> StoredTool:
    try:
        number, name = _number(entry["nr"]), entry["path"].replace("\\", "/")
    except (KeyError, TypeError, ValueError, OverflowError, AttributeError) as error:
        what, advice = "a tool of the library has no number nr or no path", "correct the entry"
        raise JobError("tool-library", what, value=shown(entry), advice=advice, place=Place(str(library))) from error
    for folder in (library.parent, library.parent.parent / "Bit"):
        if is_there(folder / name):
            return read_bit(folder / name, number)
    told = Text("its file '{name}' is neither here nor in ../Bit", name=_text(name))
    return StoredTool(number, _text(Path(name).stem), None, {}, (told,))


def _number(value: Any) -> int:
    """Return the number of a tool in a library; raises ValueError for none."""
    return int(Bounds("number").require(int(value), "nr"))


def _bit_folder(library: Path) -> Path:
    return library.parent.parent / "Bit" if library.parent.name == "Library" else library.parent
