# SPDX-License-Identifier: LGPL-2.1-or-later
"""The materials as a table: those that ship, and the user's own and changed ones, CONFIG/cncstepper/materials.toml.

Only what differs from the shipped table is written, so that a row that is deleted gives the shipped one back.
"""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Text
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.files.toml_text import document_text
from CNCStepper.machine.freecad_materials import ENDING, read_material, write_material
from CNCStepper.machine.libraries.table_draft import (
    Column,
    Problems,
    Values,
    doubled,
    model_problem,
    unknown_ending,
)
from CNCStepper.machine.materials import Material, material, material_names, own_materials_path, shipped_materials
from CNCStepper.machine.profile import validated

KEY = "key"  # of a material's name in jobs; its title is for people
TITLE = "Materials of the user's own, and shipped ones that the user has changed"
SPEEDS, LOADS, TURNING = "_speed_m_min", "_chip_load_mm", "turning_"
PLAIN = ("title", "source", "plunge_factor", "stepdown", "stepover")
CUTTERS = ("carbide", "hss")
OF_TURNING = ("force_n_mm2", "exponent", "elasticity_n_mm2")


class MaterialLibrary:
    """The materials: a row each, with surface speeds and chip loads for carbide and HSS, and what turning needs."""

    ENDINGS: tuple[str, ...] = (".toml", ENDING)
    columns: tuple[Column, ...] = (
        Column(KEY, "text", is_needed=True),
        Column("title", "text", is_needed=True),
        *(Column(key, is_needed=True) for key in ("plunge_factor", "stepdown", "stepover")),
        *(
            Column(f"{cutter}{end}", "rows", is_needed=cutter == CUTTERS[0])
            for cutter in CUTTERS
            for end in (SPEEDS, LOADS)
        ),
        *(Column(f"{TURNING}{key}") for key in OF_TURNING),
        Column("source", "text"),
    )

    def rows(self) -> list[tuple[Values, Any]]:
        """Return all materials; raises JobError for a bad file of the user's."""
        return [(_values(material(name)), None) for name in material_names()]

    def new_row(self, rows: Sequence[Values]) -> Values:
        """Return a material with a free name and the values of the first one, to be changed."""
        names = {row.get(KEY) for row in rows}
        free = next(f"material-{number}" for number in range(1, len(names) + 2) if f"material-{number}" not in names)
        return {**_values(material(material_names()[0])), KEY: free, "title": free, "source": None}

    def judge(self, rows: Sequence[Values]) -> Problems:
        """Return what is wrong with materials: their values, and names that two have."""
        problems = doubled(rows, KEY)
        for number, row in enumerate(rows):
            if found := model_problem(Material, {"name": row[KEY], **_content(row)}):
                place, sentence = found
                problems.setdefault((number, _column_of(place)), sentence)
        return problems

    def save(self, rows: Sequence[tuple[Values, Any]]) -> Path:
        """Write those that differ from the shipped ones into the user's file."""
        path, shipped = own_materials_path(), shipped_materials()
        path.parent.mkdir(parents=True, exist_ok=True)
        own = [
            values
            for values, _ in rows
            if values[KEY] not in shipped or _content(values) != _content(_values(shipped[values[KEY]]))
        ]
        write_whole(path, _text(own).encode("utf-8"))
        return path

    def read(self, path: Path) -> tuple[list[tuple[Values, Any]], list[str]]:
        """Return the materials of a file in the form of the user's own, or the one of FreeCAD's; raises JobError."""
        if self._is_fcmat(path):
            return [(_values(read_material(path)), None)], []
        tables = read_toml(path)
        found = [validated(Material, {"name": name, **table}, str(path)) for name, table in tables.items()]
        return [(_values(one), None) for one in found], []

    def write(self, rows: Sequence[tuple[Values, Any]], path: Path) -> list[str]:
        """Write materials into a file, FreeCAD's holds one; raises JobError for one of another kind."""
        if self._is_fcmat(path):
            write_material(_only(rows), path)
            return []
        write_whole(path, _text([values for values, _ in rows]).encode("utf-8"))
        return []

    def _is_fcmat(self, path: Path) -> bool:
        """Return whether a file is one of FreeCAD's, not TOML; raises JobError for another ending."""
        ending = path.suffix.lower()
        if ending not in [known.lower() for known in self.ENDINGS]:
            raise unknown_ending(path, self.ENDINGS)
        return ending == ENDING.lower()


def _only(rows: Sequence[tuple[Values, Any]]) -> Material:
    if len(rows) != 1:
        value = Text("{count} materials", count=len(rows))
        advice = "mark one row, or write a file that ends in .toml"
        raise JobError("fcmat-one", "a material file of FreeCAD holds one material", value=value, advice=advice)
    values, _ = rows[0]
    return validated(Material, {"name": values[KEY], **_content(values)}, values[KEY])


def _text(rows: Sequence[Values]) -> str:
    text = document_text({row[KEY]: _content(row) for row in rows}, TITLE)
    tomllib.loads(text)
    return text


def _values(one: Material) -> Values:
    """Return the cells of a material."""
    values: Values = {KEY: one.name, **{key: getattr(one, key) for key in PLAIN}}
    for cutter in CUTTERS:
        if (cutting := getattr(one, cutter)) is not None:
            values[f"{cutter}{SPEEDS}"] = (cutting.speed_m_min,)
            values[f"{cutter}{LOADS}"] = cutting.chip_load_mm or None
    if one.turning is not None:
        values |= {f"{TURNING}{key}": getattr(one.turning, key) for key in OF_TURNING}
    return values


def _content(values: Values) -> Values:
    """Return the table of a material in its file."""
    content: Values = {key: values.get(key) for key in PLAIN if values.get(key) is not None}
    content.setdefault("source", "")
    for cutter in CUTTERS:
        speeds, loads = values.get(f"{cutter}{SPEEDS}"), values.get(f"{cutter}{LOADS}")
        if speeds or loads:
            speed = {"speed_m_min": list(speeds[0])} if speeds else {}
            content[cutter] = {**speed, **({"chip_load_mm": [list(row) for row in loads]} if loads else {})}
    turned = {key: values[f"{TURNING}{key}"] for key in OF_TURNING if values.get(f"{TURNING}{key}") is not None}
    return {**content, **({"turning": turned} if turned else {})}


def _column_of(place: tuple[str, ...]) -> str:
    """Return the column of a place in the model."""
    if place[:1] and place[0] in CUTTERS:
        return f"{place[0]}{LOADS if 'chip_load_mm' in place else SPEEDS}"
    if place[:1] == ("turning",):
        return f"{TURNING}{place[1] if len(place) > 1 else OF_TURNING[0]}"
    return place[0] if place and place[0] in PLAIN else KEY
