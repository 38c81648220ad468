# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's materials with the model Machinability (.FCMat): read into a Material, and written from one.

    SurfaceSpeedCarbide, SurfaceSpeedHSS    "70 m/min"        the least and the most speed
    UnitCuttingForce, ChipThicknessExponent, YoungsModulus    turning, where all three are there

FreeCAD has no chip load, plunge factor, stepdown or stepover: those of the shipped material nearest in kind are taken.
A file that is written here holds ours in a mapping of its own, "CNCStepper", which FreeCAD passes over. FreeCAD's
values count where they differ from it.
"""

from __future__ import annotations

import json
import re
import uuid
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Place, Text, joined
from CNCStepper.machine.files.fcmat_files import Content, Entry, Nested, fcmat_text, read_fcmat
from CNCStepper.machine.materials import Cutting, Material, shipped_materials
from CNCStepper.machine.profile import validated
from CNCStepper.machine.tools.freecad_tool_bits import quantity
from CNCStepper.quantities import Bounds
from CNCStepper.safe_text import printable

ENDING = ".FCMat"
OURS = "CNCStepper"
MACHINABILITY = "9d81fcb2-bf81-48e3-bb57-d45ecf380096"
STANDARD, KIND = "1e2c0088-904a-4537-925f-64064c07d700", "KindOfMaterial"
ELASTIC = "f6f9e48c-b116-4e82-ad7f-3659a9219c50"
MATERIALS_OF_THE_PROJECT = uuid.uuid5(uuid.NAMESPACE_OID, "CNCStepper")
SPEEDS = {"carbide": "SurfaceSpeedCarbide", "hss": "SurfaceSpeedHSS"}
FORCE, EXPONENT, MODULUS = "UnitCuttingForce", "ChipThicknessExponent", "YoungsModulus"
TURNING = {  # FreeCAD's property -> ours
    FORCE: "force_n_mm2",
    EXPONENT: "exponent",
    MODULUS: "elasticity_n_mm2",
}
NEAR = {  # the material whose chip load is taken: FreeCAD's name, Father or KindOfMaterial, besides our own names
    "aluminium-6061": "aluminium|aluminum",
    "brass": "brass|copper",
    "mild-steel": "steel|cast steel|case-hardened steel|cold forming steel|fine grain steel|heat-treatable steel"
    "|iron|cast iron",
    "stainless": "stainless steel|austenitic stainless steel",
    "hardwood": "hard wood|wood",
    "softwood": "soft wood|softwood",
    "mdf": "mdf|engineered wood",
    "acrylic": "acrylic|thermoplast",
}
KINDS = {kind: like for like, kinds in NEAR.items() for kind in kinds.split("|")}
IN_MINUTE = {"m": 1.0, "cm": 0.01, "mm": 0.001, "ft": 0.3048, "in": 0.0254}
UNITS_M_MIN = {
    f"{length}/{time}": meters * times
    for length, meters in IN_MINUTE.items()
    for time, times in (("min", 1), ("s", 60))
}
UNITS_N_MM2 = {
    "N/mm^2": 1.0,
    "N/mm²": 1.0,
    "MPa": 1.0,
    "GPa": 1000.0,
    "kPa": 0.001,
    "kg/(mm*s^2)": 0.001,
    "Pa": 1e-6,
    "psi": 0.006894757293,
    "ksi": 6.894757293,
}
READ = {  # property -> the kind of quantity, and its units
    **{key: (Bounds("surface_speed"), UNITS_M_MIN) for key in SPEEDS.values()},
    FORCE: (Bounds("specific_force"), UNITS_N_MM2),
    EXPONENT: (Bounds("share", most=0.99), {"": 1.0}),
    MODULUS: (Bounds("elasticity"), UNITS_N_MM2),
}
DIGITS = 5  # of values in another unit than ours: FreeCAD rounds 70 m/min to 1166.67 mm/s
MOST_NAME = 80
ADVICE = "write it in FreeCAD's material editor"


def read_material(path: Path) -> Material:
    """Return the material of a .FCMat file; raises JobError for a file without the model or of an unknown kind."""
    content = read_fcmat(path)
    if MACHINABILITY not in [entry.text for keys, entry in content.items() if keys[-1] == "UUID"]:
        raise JobError(
            "fcmat-model",
            "the material has no surface speeds: it lacks the model Machinability",
            advice="add this model in FreeCAD's material editor",
            place=Place(str(path)),
        )
    values = _values(content, path)
    own = _own(content, path)
    base = own or _nearest(content, path)
    turning = {ours: values[theirs] for theirs, ours in TURNING.items() if theirs in values}
    title = _text(content, "General", "Name") or path.stem
    changed: dict[str, Any] = {
        "title": printable(title, 2 * MOST_NAME),
        "turning": turning if len(turning) == len(TURNING) else None,
        **{cutter: _cutting(own, base, cutter, values.get(key)) for cutter, key in SPEEDS.items()},
    }
    return validated(Material, {**base.model_dump(), **changed}, str(path))


def write_material(one: Material, path: Path) -> None:
    """Write a material for FreeCAD 1.0 and newer, which calls it by the file's name; its UUID follows from its own."""
    turned = one.turning
    models: dict[str, Nested] = {
        "MaterialStandard": {"UUID": STANDARD, KIND: one.name},
        "Machinability": {"UUID": MACHINABILITY, **_machinability(one)},
    }
    if turned is not None:
        modulus = f"{turned.elasticity_n_mm2!r} N/mm^2"
        models["IsotropicLinearElastic"] = {"UUID": ELASTIC, MODULUS: modulus}
    own = one.model_dump(exclude={"name", "source", "title", "turning"}, exclude_none=True)
    content: Nested = {
        "General": {
            "UUID": str(uuid.uuid5(MATERIALS_OF_THE_PROJECT, one.name)),
            "Name": one.title,
            "ReferenceSource": one.source,
        },
        "Models": models,
        OURS: {"name": one.name, **{key: json.dumps(value) for key, value in own.items()}},
    }
    write_whole(path, fcmat_text(content).encode("utf-8"))


# --- inside -----------------------------------------------------------------------------------------


def _machinability(one: Material) -> dict[str, str]:
    """Return FreeCAD's values; of a range of speeds the least, which suits every tool."""
    cuttings = {key: getattr(one, cutter) for cutter, key in SPEEDS.items()}
    speeds = {key: f"{cutting.speed_m_min[0]!r} m/min" for key, cutting in cuttings.items() if cutting is not None}
    if one.turning is None:
        return speeds
    return {**speeds, FORCE: f"{one.turning.force_n_mm2!r} N/mm^2", EXPONENT: repr(one.turning.exponent)}


def _values(content: Content, path: Path) -> dict[str, float]:
    """Return the quantities of the models in our units; raises JobError for a bad one, and without carbide's speed."""
    entries = {keys[-1]: entry for keys, entry in content.items() if keys[0] == "Models" and entry.text.strip()}
    values = {key: _value(key, entries[key], path) for key in READ if key in entries}
    if SPEEDS["carbide"] not in values:
        raise JobError(
            "fcmat-speed",
            Text("the material has no {key}", key=SPEEDS["carbide"]),
            advice=ADVICE,
            place=Place(str(path)),
        )
    return values


def _value(key: str, entry: Entry, path: Path) -> float:
    bounds, units = READ[key]
    place = Place(str(path), entry.line)
    try:
        value = quantity(entry.text, units)
    except ValueError as error:
        what = Text("{key} is no quantity in one of: {units}", key=key, units=", ".join(filter(None, units)) or "1")
        raise JobError(
            "fcmat-value", what, value=printable(entry.text, MOST_NAME), advice=ADVICE, place=place
        ) from error
    is_exact = units.get(" ".join(entry.text.split()[1:])) == 1.0
    return bounds.require(value if is_exact else float(f"{value:.{DIGITS}g}"), key, place)


def _cutting(own: Material | None, base: Material, cutter: str, speed_m_min: float | None) -> dict[str, Any] | None:
    """Return what a cutter does: our range whose least speed FreeCAD has, else that speed alone; None without one."""
    if speed_m_min is None:
        return None
    ours: Cutting | None = getattr(own, cutter, None)
    chips: Cutting | None = getattr(base, cutter)
    speeds = (speed_m_min, speed_m_min)
    if ours is not None and ours.speed_m_min[0] == speed_m_min:
        speeds = ours.speed_m_min
    return {"speed_m_min": speeds, "chip_load_mm": chips.chip_load_mm if chips else ()}


def _own(content: Content, path: Path) -> Material | None:
    """Return the material that we wrote into the file; None for a file that is FreeCAD's alone."""
    entries = {keys[1]: entry for keys, entry in content.items() if keys[0] == OURS and len(keys) == 2}
    if "name" not in entries:
        return None
    own: dict[str, Any] = {"name": entries.pop("name").text, "title": ""}
    own["source"] = _text(content, "General", "ReferenceSource")
    for key, entry in entries.items():
        try:
            own[key] = json.loads(entry.text)
        except (ValueError, RecursionError) as error:
            what = Text("{key} of {ours} is no JSON", key=printable(key, MOST_NAME), ours=OURS)
            place = Place(str(path), entry.line)
            raise JobError("fcmat-value", what, advice="export the material anew", place=place) from error
    return validated(Material, own, str(path))


def _nearest(content: Content, path: Path) -> Material:
    """Return the shipped material whose chip load is taken, under the name of FreeCAD's; raises for an unknown kind."""
    title = _text(content, "General", "Name") or path.stem
    said = [title, *(_last(content, key) for key in ("Father", KIND))]
    known = {**{name: name for name in shipped_materials()}, **KINDS}
    like = next((known[word.lower()] for word in said if word.lower() in known), None)
    if like is None:
        kinds = joined(", ", [printable(word, MOST_NAME) for word in said[1:] if word])
        raise JobError(
            "fcmat-kind",
            "no material here is near to this one, so that its chip load is not known",
            value=kinds,
            advice=Text("write its KindOfMaterial in FreeCAD, one of: {kinds}", kinds=", ".join(KINDS)),
            place=Place(str(path)),
        )
    name = "-".join(re.findall(r"\w+", title.lower()))[:MOST_NAME] or "material"
    source = f"FreeCAD: {printable(path.name, MOST_NAME)}; chip load of {like}"
    return shipped_materials()[like].model_copy(update={"name": name, "source": source})


def _text(content: Content, *keys: str) -> str:
    return content[keys].text.strip() if keys in content else ""


def _last(content: Content, key: str) -> str:
    """Return the text of a key of any model, "" for none."""
    return next((entry.text.strip() for keys, entry in content.items() if keys[0] == "Models" and keys[-1] == key), "")
