# SPDX-License-Identifier: LGPL-2.1-or-later
"""QtPlasmaC's material files: read as its documents have them, written so that nothing is lost, refused by line."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.cut_charts import CutData, cut_data_for, read_chart, shipped_chart, write_chart
from CNCStepper.machine.qtplasmac_materials import KEYS, read_materials

DOCUMENTED = """\
# plasmac material file
# items marked * are mandatory
#[MATERIAL_NUMBER_1]
#NAME               =

[MATERIAL_NUMBER_12]
NAME                = 5mm Mild Steel 40A
KERF_WIDTH          = 0.5
THC                 = 1
PIERCE_HEIGHT       = 3.1
PIERCE_DELAY        = 0.1
PUDDLE_JUMP_HEIGHT  = 150
PUDDLE_JUMP_DELAY   = .25
CUT_HEIGHT          = 0.75
CUT_SPEED           = 3000
CUT_AMPS            = 45
CUT_VOLTS           = 110
PAUSE_AT_END        = 0.1
GAS_PRESSURE        = 5
CUT_MODE            = 1
"""
INCHES = """\
[MATERIAL_NUMBER_1]
NAME = 1/4 in Mild Steel 65A
KERF_WIDTH = 0.07
PIERCE_HEIGHT = 0.15
PIERCE_DELAY = 0.5
CUT_HEIGHT = 0.06
CUT_SPEED = 100
GAS_PRESSURE = 80
"""


def file(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "table_material.cfg"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_documented_file_is_read(tmp_path: Path) -> None:
    (row,) = read_chart(file(tmp_path, DOCUMENTED))
    assert row == CutData(
        process="plasma", material="mild-steel", thickness_mm=5, consumable="40A", number=12,
        name="5mm Mild Steel 40A", kerf_mm=0.5, thc=True, pierce_height_mm=3.1, pierce_delay_s=0.1,
        puddle_jump_height_percent=150, puddle_jump_delay_s=0.25, cut_height_mm=0.75, feed_mm_min=3000, amperes=45,
        volts=110, pause_at_end_s=0.1, pressure_bar=5, cut_mode=1,
    )  # fmt: skip


def test_a_file_of_inches_is_read_where_that_is_said(tmp_path: Path) -> None:
    (row,) = read_chart(file(tmp_path, INCHES), "inch")
    assert (row.material, row.thickness_mm, row.consumable) == ("mild-steel", 6.35, "65A")
    assert row.feed_mm_min == pytest.approx(2540) and row.kerf_mm == pytest.approx(1.778)
    assert row.pressure_bar == pytest.approx(5.5158, abs=1e-4) and row.thc is False
    assert read_chart(file(tmp_path, "# units: inch\n" + INCHES)) == [row]


def test_a_file_in_the_other_unit_is_refused_unless_it_says_its_own(tmp_path: Path) -> None:
    with pytest.raises(JobError) as refused:
        read_chart(file(tmp_path, INCHES))
    assert refused.value.code == "material-units" and "# units: inch" in refused.value.advice
    with pytest.raises(JobError, match="seems to be in mm"):
        read_chart(file(tmp_path, DOCUMENTED), "inch")
    with pytest.raises(JobError, match="seems to be in mm"):
        read_materials(file(tmp_path, DOCUMENTED), "inch")


@pytest.mark.parametrize("units", ["mm", "inch"])
def test_random_materials_survive_being_written_and_read_in_either_unit(units: str, tmp_path: Path) -> None:
    rng = np.random.default_rng(seed := 7)
    print(f"seed {seed}")
    rows = []
    for number in rng.permutation(np.arange(1, 41)):
        values = {own: round(float(rng.uniform(0.1, 3.0)), 3) for own, kind in KEYS.values() if kind == "length"}
        rest = {"pierce_delay_s": round(float(rng.uniform(0, 2)), 2), "amperes": float(rng.integers(0, 200))}
        rows.append(
            CutData(
                process="plasma", material=["mild-steel", "copper alloy"][number % 2].replace(" ", "-"),
                thickness_mm=float(number) / 8, consumable=["", "45A", "FineCut 3"][number % 3], number=int(number),
                **{**values, **rest, "feed_mm_min": float(rng.integers(100, 9000))}, thc=bool(number % 2),
                cut_mode=int(number % 4), pressure_bar=5.5, puddle_jump_height_percent=float(number % 3) * 50,
            )
        )  # fmt: skip
    path = tmp_path / "random_material.cfg"
    assert write_chart(path, rows, units) == []
    again = read_chart(path)
    for one, two in zip(rows, again, strict=True):
        assert set(two.model_fields_set) >= {own for own, _ in KEYS.values()}
        for key, value in one:
            if key != "name":
                assert getattr(two, key) == (pytest.approx(value, abs=2e-5) if isinstance(value, float) else value), key
    first = path.read_text("utf-8")
    write_chart(path, again, units)
    assert path.read_text("utf-8") == first
    assert {row.consumable for row in rows} == {"", "45A", "FineCut 3"} and {row.thc for row in rows} == {True, False}


def test_the_shipped_chart_becomes_a_material_file_with_numbers(tmp_path: Path) -> None:
    path = tmp_path / "shipped_material.cfg"
    rows = list(shipped_chart("plasma"))
    notes = write_chart(path, rows)
    assert any("lead_in_mm" in note for note in notes) and any("source" in note for note in notes)
    again = read_chart(path)
    assert [row.number for row in again] == list(range(1, len(rows) + 1))
    assert cut_data_for("plasma", "mild-steel", 3.0, chart=again).feed_mm_min == 3850.0
    assert cut_data_for("plasma", "mild-steel", 3.0, "65A", again).number > 0
    assert cut_data_for("plasma", "mild-steel", 5.0, chart=again).number == 0  # no such material: interpolated


def test_free_numbers_go_around_those_that_are_taken(tmp_path: Path) -> None:
    rows = [
        row.model_copy(update={"number": number})
        for row, number in zip(shipped_chart("plasma")[:4], (0, 1, 0, 3), strict=True)
    ]
    write_chart(tmp_path / "a.cfg", rows)
    assert [row.number for row in read_chart(tmp_path / "a.cfg")] == [2, 1, 4, 3]
    with pytest.raises(JobError, match="is used twice"):
        write_chart(tmp_path / "b.cfg", [rows[1], rows[1]])
    with pytest.raises(JobError, match="laser"):
        write_chart(tmp_path / "b.cfg", list(shipped_chart("laser")))


@pytest.mark.parametrize(
    ("name", "material", "thickness_mm", "consumable"),
    [
        ("mild-steel 3 mm 45A", "mild-steel", 3.0, "45A"),
        ("3mm Mild Steel 45A FineCut", "mild-steel", 3.0, "45A FineCut"),
        ('Mild Steel 1/4" 65A', "mild-steel", 6.35, "65A"),
        ("Aluminum 1-1/2 in", "aluminum", 38.1, ""),
        ("Aluminum 1 1/2 in", "aluminum", 38.1, ""),
        ("3/8 Mild Steel", "mild-steel", 9.525, ""),
        ("16ga Stainless 30A", "stainless", 1.5875, "30A"),
        ("10 gauge Mild Steel", "mild-steel", 3.4163, ""),
        ("Aluminum 12 ga", "aluminum", 2.0525, ""),
        ("S355 12 mm 105A", "s355", 12.0, "105A"),
        ("1,5 mm Inox", "inox", 1.5, ""),
        (".125in Copper", "copper", 3.175, ""),
    ],
)
def test_names_as_people_write_them_say_material_and_thickness(
    name: str, material: str, thickness_mm: float, consumable: str, tmp_path: Path
) -> None:
    (row,) = read_chart(file(tmp_path, DOCUMENTED.replace("5mm Mild Steel 40A", name)))
    assert (row.material, row.thickness_mm, row.consumable) == (material, thickness_mm, consumable)


SECTION = DOCUMENTED[DOCUMENTED.index("[MATERIAL_NUMBER_12]") :]


@pytest.mark.parametrize(
    ("text", "code", "said"),
    [
        (DOCUMENTED + SECTION, "material-file", "_material.cfg:21"),
        (DOCUMENTED + SECTION.replace("12]", "13]"), "chart-twice", "two rows"),
        (DOCUMENTED.replace("_12]", "_0]"), "material-file", "1 to 999999"),
        (DOCUMENTED.replace("_12]", "_1000000]"), "material-file", "1 to 999999"),
        (DOCUMENTED.replace("_12]", "_-2]"), "material-file", "not a line"),
        (DOCUMENTED.replace("_12]", "_" + "9" * 5000 + "]"), "material-file", "not a line"),
        (DOCUMENTED.replace("= 3000", "= nan"), "material-file", "CUT_SPEED"),
        (DOCUMENTED.replace("= 3000", "= inf"), "material-file", "CUT_SPEED"),
        (DOCUMENTED.replace("= 3000", "= 1e300"), "quantity", "CUT_SPEED"),
        (DOCUMENTED.replace("= 3000", "= -3000"), "quantity", "CUT_SPEED"),
        (DOCUMENTED.replace("= 3000", "= 0"), "quantity", "CUT_SPEED"),
        (DOCUMENTED.replace("= 3000", "=" + "1" * 5000), "material-file", "CUT_SPEED"),
        (DOCUMENTED.replace("= 3000", "= fast"), "material-file", "fast"),
        (DOCUMENTED.replace("= 3000", "="), "material-file", "no CUT_SPEED"),
        (DOCUMENTED.replace("CUT_SPEED           = 3000\n", ""), "material-file", "no CUT_SPEED"),
        (DOCUMENTED.replace("CUT_SPEED", "CUT_FEED"), "material-file", "no key CUT_FEED"),
        (DOCUMENTED.replace("CUT_AMPS ", "CUT_VOLTS"), "material-file", "is twice in one material"),
        (DOCUMENTED.replace("THC                 = 1", "THC = 2"), "material-file", "0 or 1"),
        (DOCUMENTED.replace("CUT_MODE            = 1", "CUT_MODE = 1.5"), "material-file", "0 to 3"),
        (DOCUMENTED.replace("= 0.5", "= 0"), "quantity", "KERF_WIDTH"),
        (DOCUMENTED.replace("5mm Mild Steel 40A", "Mild Steel"), "material-name", "material 12"),
        (DOCUMENTED.replace("5mm Mild Steel 40A", "5mm"), "material-name", "material 12"),
        (DOCUMENTED.replace("5mm Mild Steel 40A", "1/0 in Steel"), "material-name", "material 12"),
        (DOCUMENTED.replace("5mm Mild Steel 40A", "99999 mm Steel"), "quantity", "thickness of material 12"),
        ("CUT_SPEED = 3\n", "material-file", "not a line"),
        (DOCUMENTED + "what is this\n", "material-file", "not a line"),
        (DOCUMENTED + "\x00\x1b[2J\n", "material-file", "not a line"),
        ("".join(f"[MATERIAL_NUMBER_{number}]\n" for number in range(1, 5003)), "material-file", ""),
    ],
)
def test_a_hostile_file_is_refused_by_line(text: str, code: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(JobError) as refused:
        read_chart(file(tmp_path, text))
    assert refused.value.code == code and said in str(refused.value)
    assert "\x1b" not in str(refused.value)


def test_a_file_without_materials_has_no_rows_and_a_huge_one_is_not_read(tmp_path: Path) -> None:
    assert read_chart(file(tmp_path, "# nothing\n")) == []
    with pytest.raises(JobError, match=r"too large"):
        read_chart(file(tmp_path, "#" * 4_000_001))
