# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material files, there and back with FreeCAD's own reader: its machining materials, and those that we write for it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.freecad_materials import SPEEDS, TURNING, read_material, write_material
from CNCStepper.machine.materials import Material, shipped_materials

IS_OLD = FreeCAD.Version()[0] == "0"  # its files are INI, without surface speeds
SHIPPED = Path(FreeCAD.getResourceDir()) / "Mod" / "Material"
UNITS = {**dict.fromkeys(SPEEDS.values(), "m/min"), "UnitCuttingForce": "MPa", "YoungsModulus": "MPa"}
ROUNDED = 5e-5  # FreeCAD 1.0 writes two decimals, 1.1 six digits


@pytest.fixture
def folder(tmp_path: Path) -> Iterator[Path]:
    """The folder of the user's materials in FreeCAD; what a test writes there is deleted."""
    folder = tmp_path if IS_OLD else Path(dict(each[:2] for each in manager().MaterialLibraries)["User"])
    folder.mkdir(parents=True, exist_ok=True)
    before = set(folder.iterdir())
    yield folder
    for file in set(folder.iterdir()) - before:
        file.unlink()


def manager() -> Any:
    import Materials

    return Materials.MaterialManager()


def values_in_freecad(there: Any) -> dict[str, float]:
    """Return what FreeCAD's reader found, by its own names, in our units."""
    known = [key for key in (*SPEEDS.values(), *TURNING) if there.hasPhysicalProperty(key)]
    found = {key: there.getPhysicalValue(key) for key in known}
    given = {key: value for key, value in found.items() if value is not None and math.isfinite(float(value))}
    return {key: float(value.getValueAs(UNITS[key]) if key in UNITS else value) for key, value in given.items()}


def values_here(one: Material) -> dict[str, float]:
    """Return the same of a material of ours; the least of a range of speeds."""
    cuttings = {key: getattr(one, cutter) for cutter, key in SPEEDS.items()}
    speeds = {key: cutting.speed_m_min[0] for key, cutting in cuttings.items() if cutting is not None}
    return speeds | {key: getattr(one.turning, ours) for key, ours in TURNING.items() if one.turning is not None}


def test_freecad_s_own_materials_are_read_as_freecad_reads_them() -> None:
    files = sorted((SHIPPED / ("StandardMaterial" if IS_OLD else "Resources/Materials/Machining")).glob("*.FCMat"))
    assert len(files) > 10
    for file in files:
        if IS_OLD:
            with pytest.raises(JobError, match="fcmat-old"):
                read_material(file)
            continue
        [there] = [
            each for each in manager().Materials.values() if each.Name == file.stem and "Machin" in each.Directory
        ]
        values = values_in_freecad(there)
        assert values_here(read_material(file)) == pytest.approx({key: values[key] for key in SPEEDS.values()})


def test_what_we_write_is_what_freecad_reads_and_saves(folder: Path) -> None:
    for name, one in shipped_materials().items():
        write_material(one, folder / f"{name}.FCMat")
        assert read_material(folder / f"{name}.FCMat") == one
    if IS_OLD:
        return
    library = manager()
    library.refresh()
    for name, one in shipped_materials().items():
        [there] = [each for each in library.Materials.values() if each.Name == name]
        assert values_in_freecad(there) == pytest.approx(values_here(one))
        library.save("User", there, f"{name}.FCMat", overwrite=True)
        saved = read_material(folder / f"{name}.FCMat")
        assert "CNCStepper:" not in (folder / f"{name}.FCMat").read_text("utf-8-sig")
        assert values_here(saved) == pytest.approx(values_here(one), rel=ROUNDED)
        assert saved.carbide.chip_load_mm == one.carbide.chip_load_mm
