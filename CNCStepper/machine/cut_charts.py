# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut charts: for process, material, thickness and consumable the feed, kerf, pierce and power that cut it.

    [[cut]]                                rows of a chart in TOML; charts ship in machine/charts/; the
                                           user's own, CONFIG/cncstepper/charts/PROCESS.toml, take their place
    process = "plasma"
    material = "mild-steel"
    consumable = "45A"
    rows = [                               each is a row with the other keys of its table; without `rows` the table is
        { thickness_mm = 3.0, feed_mm_min = 3850.0, kerf_mm = 1.5, pierce_delay_s = 0.4 },
    ]

Between two thicknesses of one material and consumable the values are interpolated; outside them they are refused.
"""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from functools import cache, lru_cache
from importlib import resources
from itertools import pairwise
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, MissingPackage, Place, Text
from CNCStepper.machine.cut_data import CutData, between
from CNCStepper.machine.files.profile_files import config_folder
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.files.toml_text import value_text
from CNCStepper.machine.processes import PROCESSES, process_named
from CNCStepper.machine.profile import validated
from CNCStepper.machine.qtplasmac_materials import read_materials, write_materials
from CNCStepper.quantities import MOST_ITEMS
from CNCStepper.safe_text import printable
from CNCStepper.tolerances import SAME_THICKNESS_MM

MATERIAL_ALIASES = {
    "aluminum": "aluminium",
    "birch-plywood": "plywood",
    "inox": "stainless",
    "isopor": "eps",
    "stainless-steel": "stainless",
    "steel": "mild-steel",
    "styrofoam": "xps",
}

__all__ = [
    "CutData",
    "cut_data_for",
    "known_chart",
    "material_key",
    "own_chart_path",
    "read_chart",
    "shipped_chart",
    "write_chart",
]


def cut_data_for(
    process: str, material: str, thickness_mm: float, consumable: str = "", chart: Sequence[CutData] | None = None
) -> CutData:
    """Return the row that cuts a thickness of a material, interpolated between two rows where it lies between them.

    chart: rows of the shop's own; without it those of `known_chart`. Without `consumable` the chart's first one that
    covers the thickness is taken. Raises JobError for a process, material, consumable or thickness that is not covered.
    """
    rows = _of_process(process, known_chart(process) if chart is None else chart)
    of_material = [row for row in rows if material_key(row.material) == material_key(material)]
    if not of_material:
        names = ", ".join(dict.fromkeys(row.material for row in rows))
        raise JobError(
            "chart-material",
            Text("the chart of {process} has no material '{material}'", process=process, material=printable(material)),
            advice=Text("use one of: {materials}, or give a chart of your own", materials=names),
        )
    groups = _by_consumable(of_material, consumable)
    for group in groups:
        if found := _of_thickness(group, thickness_mm):
            return found
    raise _thickness_refusal(process, material, thickness_mm, groups)


def material_key(name: str) -> str:
    """Return how a material's name is compared: "Mild Steel", "mild_steel" and "mild-steel" are one."""
    key = "-".join(name.lower().replace("_", " ").replace("-", " ").split())
    return MATERIAL_ALIASES.get(key, key)


@cache
def shipped_chart(process: str) -> tuple[CutData, ...]:
    """Return the rows that ship for a process; raises JobError for one that there is not or that takes no chart."""
    if not process_named(process).uses_chart:
        names = ", ".join(name for name, one in PROCESSES.items() if one.uses_chart)
        raise JobError(
            "chart-process",
            Text("{process} takes no cut chart", process=process),
            advice=Text("charts are there for: {processes}", processes=names),
        )
    entry = resources.files("CNCStepper.machine") / "charts" / f"{process}.toml"
    return tuple(_rows(tomllib.loads(entry.read_text("utf-8")), f"{process}.toml"))


def known_chart(process: str) -> tuple[CutData, ...]:
    """Return the rows of the user's own chart of a process, else the ones that ship; raises JobError."""
    shipped = shipped_chart(process)
    try:
        path = own_chart_path(process)
        stamp = path.stat()
    except (OSError, MissingPackage):  # a user without a folder has none of his own
        return shipped
    return _read_own(path, (stamp.st_mtime_ns, stamp.st_size))


def own_chart_path(process: str) -> Path:
    """Return the file of the user's chart of a process, which need not be there; raises MissingPackage."""
    return config_folder() / "charts" / f"{process}.toml"


@lru_cache(maxsize=16)
def _read_own(path: Path, stamp: tuple[int, ...]) -> tuple[CutData, ...]:
    return tuple(read_chart(path))


def read_chart(path: Path, units: str = "") -> list[CutData]:
    """Return the rows of a chart in TOML, or of QtPlasmaC's material file (`*.cfg`), which is in `units`.

    units: "mm" or "inch" of a material file; "" is what it says itself, else mm. Raises JobError that names the file,
    and the key or line.
    """
    if path.suffix.lower() != ".cfg":
        return _rows(read_toml(path), str(path))
    rows = read_materials(path, units)
    _refuse_twice(rows, Place(str(path)))
    return rows


def write_chart(path: Path, rows: Sequence[CutData], units: str = "mm") -> list[str]:
    """Write the rows as TOML, or as QtPlasmaC's material file (`*.cfg`) in `units`; return notes on omitted values."""
    if path.suffix.lower() == ".cfg":
        return write_materials(path, rows, units)
    tables = [
        "[[cut]]\n" + "".join(f"{key} = {value_text(value)}\n" for key, value in _given(row).items()) for row in rows
    ]
    write_whole(path, ("# Cut chart, made by CNCStepper\n\n" + "\n".join(tables)).encode("utf-8"))
    return []


def _of_process(process: str, rows: Sequence[CutData]) -> list[CutData]:
    process_named(process)
    if of_process := [row for row in rows if row.process == process]:
        return of_process
    there = ", ".join(dict.fromkeys(row.process for row in rows)) or "nothing"
    raise JobError(
        "chart-process",
        Text("the chart has no row of {process}", process=process),
        advice=Text("it is for {processes}: choose another chart or process", processes=there),
    )


def _by_consumable(rows: Sequence[CutData], consumable: str) -> list[list[CutData]]:
    """Return the rows of each consumable, thickness rising; of the one that is asked for only."""
    groups: dict[str, list[CutData]] = {}
    for row in rows:
        groups.setdefault(row.consumable.lower(), []).append(row)
    if consumable and consumable.lower() not in groups:
        names = ", ".join(dict.fromkeys(row.consumable or '""' for row in rows))
        raise JobError(
            "chart-consumable",
            Text("the chart has no consumable '{consumable}' for it", consumable=printable(consumable)),
            advice=Text("use one of: {consumables}", consumables=names),
        )
    chosen = [groups[consumable.lower()]] if consumable else list(groups.values())
    return [sorted(group, key=lambda row: row.thickness_mm) for group in chosen]


def _of_thickness(group: Sequence[CutData], thickness_mm: float) -> CutData | None:
    for row in group:
        if abs(row.thickness_mm - thickness_mm) <= SAME_THICKNESS_MM:
            return row
    for thin, thick in pairwise(group):
        if thin.thickness_mm < thickness_mm < thick.thickness_mm:
            return between(thin, thick, thickness_mm)
    return None


def _thickness_refusal(
    process: str, material: str, thickness_mm: float, groups: Sequence[Sequence[CutData]]
) -> JobError:
    ranges = [
        f"{group[0].thickness_mm:g} to {group[-1].thickness_mm:g} mm"
        + (f" with {group[0].consumable}" if group[0].consumable else "")
        for group in groups
    ]
    return JobError(
        "chart-thickness",
        Text("the chart of {process} does not cover this thickness of {material}", process=process, material=material),
        value=f"{thickness_mm:g} mm",
        limit="; ".join(ranges),
        advice="take a thickness within it, another consumable, or give a chart of your own with this row",
    )


def _rows(content: dict[str, Any], file: str) -> list[CutData]:
    """Return the rows of a file's content, in its order; raises JobError that names the table, key and value."""
    tables = content.get("cut")
    place = Place(file)
    if set(content) != {"cut"} or not isinstance(tables, list) or not all(isinstance(one, dict) for one in tables):
        raise JobError(
            "bad-value", "a cut chart holds [[cut]] tables and nothing else", advice="write those", place=place
        )
    spread = [row for table in tables for row in _spread(table, place)]
    if len(spread) > MOST_ITEMS["cuts"]:
        raise JobError(
            "bad-value",
            "the chart has too many rows",
            value=f"{len(spread)}",
            limit=f"{MOST_ITEMS['cuts']}",
            advice="split the chart",
            place=place,
        )
    rows = [validated(CutData, row, file) for row in spread]
    _refuse_twice(rows, place)
    return rows


def _spread(table: dict[str, Any], place: Place) -> list[dict[str, Any]]:
    """Return the rows of a table: those of its `rows`, with its other keys, or the table itself."""
    if "rows" not in table:
        return [table]
    rows = table["rows"]
    if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise JobError(
            "bad-value", "rows must be a list of tables", advice="write rows = [{ ... }, { ... }]", place=place
        )
    common = {key: value for key, value in table.items() if key != "rows"}
    return [{**common, **row} for row in rows]


def _refuse_twice(rows: Sequence[CutData], place: Place) -> None:
    """Raise JobError where two rows are for the same cut, because it is unclear which one counts."""
    seen = set()
    for row in rows:
        says = (row.process, material_key(row.material), row.consumable.lower(), row.thickness_mm)
        if says in seen:
            raise JobError(
                "chart-twice",
                Text(
                    "two rows are for {thickness:g} mm of {material}", thickness=row.thickness_mm, material=row.material
                ),
                value=row.consumable,
                advice="take one out, or give them different consumables",
                place=place,
            )
        seen.add(says)


def _given(row: CutData) -> dict[str, Any]:
    return row.model_dump(exclude_defaults=True)
