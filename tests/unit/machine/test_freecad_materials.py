# SPDX-License-Identifier: LGPL-2.1-or-later
"""Materials of FreeCAD: read with the chip load of the nearest one here, written so that nothing is lost."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.freecad_materials import KINDS, MACHINABILITY, read_material, write_material
from CNCStepper.machine.materials import Material, Turning, shipped_materials

MILD = f"""\
---
General:
  UUID: "029b8fac-d453-4ff5-ba26-b37a79a33d97"
  Name: "Mild Steel (soft)"
Models:
  Father:
    UUID: '9cdda8b6-b606-4778-8f13-3934d8668e67'
    Father: "Metal"
  MaterialStandard:
    UUID: '1e2c0088-904a-4537-925f-64064c07d700'
    KindOfMaterial: "Steel"
  Machinability:
    UUID: '{MACHINABILITY}'
    SurfaceSpeedHSS: '25 m/min'
    SurfaceSpeedCarbide: '70 m/min'
    UnitCuttingForce: '2298 N/mm^2'
    ChipThicknessExponent: 0.20
  Linear Elastic:
    YoungsModulus: "210 GPa"
"""


def read(folder: Path, old: str = "", new: str = "") -> Material:
    assert old in MILD
    file = folder / "Mild.FCMat"
    file.write_text(MILD.replace(old, new), encoding="utf-8")
    return read_material(file)


def test_a_material_of_freecad_has_its_speeds_and_the_chip_load_of_the_nearest_one(tmp_path: Path) -> None:
    found, like = read(tmp_path), shipped_materials()["mild-steel"]
    assert (found.name, found.title) == ("mild-steel-soft", "Mild Steel (soft)")
    assert found.source == "FreeCAD: Mild.FCMat; chip load of mild-steel"
    assert found.hss is not None and found.hss.speed_m_min == (25, 25) and found.carbide.speed_m_min == (70, 70)
    assert found.carbide.chip_load_mm == like.carbide.chip_load_mm
    assert (found.plunge_factor, found.stepdown, found.stepover) == (like.plunge_factor, like.stepdown, like.stepover)
    assert found.turning == Turning(force_n_mm2=2298, exponent=0.2, elasticity_n_mm2=210_000)


@pytest.mark.parametrize("text", ["70 m/min", "1166.67 mm/s", "1,16667 m/s", "70000 mm/min", "7000 cm/min"])
def test_a_speed_is_read_in_every_unit_that_freecad_writes(tmp_path: Path, text: str) -> None:
    assert read(tmp_path, "70 m/min", text).carbide.speed_m_min == (70, 70)


@pytest.mark.parametrize("text", ["2298 MPa", "2.298 GPa", "2.298e+06 kg/(mm*s^2)", "2298000000 Pa"])
def test_a_force_is_read_in_every_unit_that_freecad_writes(tmp_path: Path, text: str) -> None:
    turning = read(tmp_path, "2298 N/mm^2", text).turning
    assert turning is not None and turning.force_n_mm2 == 2298


@pytest.mark.parametrize("key", ["UnitCuttingForce", "ChipThicknessExponent", "YoungsModulus"])
def test_a_material_is_turned_only_where_force_exponent_and_modulus_are_there(tmp_path: Path, key: str) -> None:
    assert read(tmp_path, key, f"Other{key}").turning is None
    line = re.search(rf"{key}: (.*)", MILD)
    assert line is not None and read(tmp_path, line[0], f'{key}: ""').turning is None


@pytest.mark.parametrize(
    ("name", "father", "kind", "like"),
    [
        ("Soft Wood", "Wood", "Wood", "softwood"),
        ("Balsa", "Wood", "Wood", "hardwood"),
        ("Particle Board", "Engineered Wood", "Wood", "mdf"),
        ("Gray", "Metal", "Cast Iron", "mild-steel"),
        ("Austenitic Stainless Steel", "Metal", "Steel", "stainless"),
        ("HDPE", "Thermoplast", "", "hdpe"),
    ],
)
def test_the_nearest_material_follows_from_name_father_and_kind(
    tmp_path: Path, name: str, father: str, kind: str, like: str
) -> None:
    text = MILD.replace("Mild Steel (soft)", name).replace("Metal", father).replace('"Steel"', f'"{kind}"')
    (tmp_path / "a.FCMat").write_text(text, encoding="utf-8")
    found = read_material(tmp_path / "a.FCMat")
    assert found.source.endswith(f"chip load of {like}")
    assert found.carbide.chip_load_mm == shipped_materials()[like].carbide.chip_load_mm


def test_every_kind_leads_to_a_material_that_ships() -> None:
    assert set(KINDS.values()) <= set(shipped_materials())


@pytest.mark.parametrize(
    ("old", "new", "code", "line"),
    [
        (MACHINABILITY, "x", "fcmat-model", 0),
        ("SurfaceSpeedCarbide", "SurfaceSpeedDiamond", "fcmat-speed", 0),
        ('"Steel"', '"Titanium"', "fcmat-kind", 0),
        ("70 m/min", "70 km/h", "fcmat-value", 15),
        ("70 m/min", "fast", "fcmat-value", 15),
        ("70 m/min", "70 mm", "fcmat-value", 15),
        ("70 m/min", "0 m/min", "quantity", 15),
        ("2298 N/mm^2", "9e99 GPa", "quantity", 16),
        ("0.20", "1.5", "quantity", 17),
    ],
)
def test_what_cannot_be_a_material_here_is_refused(tmp_path: Path, old: str, new: str, code: str, line: int) -> None:
    with pytest.raises(JobError) as caught:
        read(tmp_path, old, new)
    assert caught.value.code == code and caught.value.advice
    assert caught.value.place is not None and caught.value.place.line == line


@pytest.mark.parametrize("name", shipped_materials())
def test_every_material_comes_back_as_it_was_written(tmp_path: Path, name: str) -> None:
    file = tmp_path / "one.FCMat"
    write_material(shipped_materials()[name], file)
    assert read_material(file) == shipped_materials()[name]


def test_what_freecad_changes_in_a_written_file_counts(tmp_path: Path) -> None:
    steel, file = shipped_materials()["mild-steel"], tmp_path / "steel.FCMat"
    write_material(steel, file)
    text = file.read_text("utf-8")
    assert read_identity(text) == read_identity(written_again(steel, file)) != read_identity(MILD)
    file.write_text(text.replace("25.0 m/min", "30 m/min").replace("Mild steel", "Aço doce"), encoding="utf-8")
    found = read_material(file)
    assert (found.name, found.title, found.source) == (steel.name, "Aço doce", steel.source)
    assert found.hss is not None and found.hss.speed_m_min == (30, 30) and found.carbide == steel.carbide


@pytest.mark.parametrize("name", shipped_materials())
def test_a_written_material_that_freecad_saves_under_another_name_is_still_near_to_ours(
    tmp_path: Path, name: str
) -> None:
    one, file = shipped_materials()[name], tmp_path / "Peça.FCMat"
    write_material(one, file)
    text = file.read_text("utf-8").replace(f'"{one.title}"', '"Peça"')
    file.write_text(text[: text.index("CNCStepper:")], encoding="utf-8")
    found = read_material(file)
    assert (found.name, found.title, found.source) == ("peça", "Peça", f"FreeCAD: Peça.FCMat; chip load of {name}")
    assert (found.carbide.chip_load_mm, found.turning) == (one.carbide.chip_load_mm, one.turning)


@pytest.mark.parametrize("text", ["{", "[" * 100_000, "9" * 5000])
def test_a_table_of_ours_that_is_spoilt_is_refused_by_its_line(tmp_path: Path, text: str) -> None:
    file = tmp_path / "steel.FCMat"
    write_material(shipped_materials()["mild-steel"], file)
    file.write_text(file.read_text("utf-8").replace('stepover: "0.25"', f'stepover: "{text}"'), encoding="utf-8")
    with pytest.raises(JobError, match=r"stepover.*\[fcmat-value\]"):
        read_material(file)


def read_identity(text: str) -> str:
    found = re.search(r'UUID: "([-0-9a-f]{36})"', text)
    assert found is not None
    return found[1]


def written_again(material: Material, file: Path) -> str:
    write_material(material, file)
    return file.read_text("utf-8")
