# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut charts: the shipped ones, what lies between their rows, and files of the shop's own."""

from __future__ import annotations

import tomllib
from importlib import resources
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.cut_charts import CutData, cut_data_for, read_chart, shipped_chart, write_chart
from CNCStepper.machine.processes import PROCESSES

ROOT = Path(__file__).parents[3]
WITH_CHARTS = [name for name, process in PROCESSES.items() if process.uses_chart]
ROWS = [row for name in WITH_CHARTS for row in shipped_chart(name)]


def chart(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "own.toml"
    path.write_text(text, encoding="utf-8")
    return path


ROW = '[[cut]]\nprocess = "plasma"\nmaterial = "copper"\nthickness_mm = 2.0\nfeed_mm_min = 1000.0\nkerf_mm = 1.2\n'


def test_every_process_with_a_chart_ships_one_that_names_its_sources() -> None:
    assert len(WITH_CHARTS) == 7
    for name in WITH_CHARTS:
        rows = shipped_chart(name)
        assert rows and all(row.process == name and row.source for row in rows)


def test_the_charts_are_in_the_package_and_nothing_else_lies_beside_them() -> None:
    folder = resources.files("CNCStepper.machine") / "charts"
    assert sorted(entry.name for entry in folder.iterdir()) == sorted(f"{name}.toml" for name in WITH_CHARTS)
    data = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["setuptools"]["package-data"]
    assert "machine/charts/*.toml" in data["CNCStepper"]


@pytest.mark.parametrize("material", ["mild-steel", "stainless", "aluminium"])
def test_plasma_covers_a_millimetre_to_sixteen(material: str) -> None:
    for thickness_mm in np.linspace(1.0, 16.0, 61):
        row = cut_data_for("plasma", material, float(thickness_mm))
        assert row.thickness_mm == pytest.approx(thickness_mm, abs=0.006)
        assert row.feed_mm_min > 0 and 0.5 < row.kerf_mm < 3
        assert row.pierce_height_mm > row.cut_height_mm > 0


def test_plasma_of_three_millimetres_is_the_books() -> None:
    row = cut_data_for("plasma", "mild-steel", 3.0)
    assert (row.feed_mm_min, row.kerf_mm, row.pierce_delay_s, row.consumable) == (3850.0, 1.5, 0.4, "45A")
    assert (row.pierce_height_mm, row.cut_height_mm) == (3.8, 1.5)
    assert cut_data_for("plasma", "mild-steel", 3.0, "65a").feed_mm_min == 5200.0


def test_in_each_shipped_chart_a_thicker_sheet_is_never_cut_faster_with_the_same_consumable() -> None:
    groups: dict[tuple[str, str, str], list[CutData]] = {}
    for row in ROWS:
        groups.setdefault((row.process, row.material, row.consumable), []).append(row)
    assert len(groups) > 30
    for rows in groups.values():
        assert all(one.thickness_mm < two.thickness_mm for one, two in pairwise(rows))
        assert all(one.feed_mm_min >= two.feed_mm_min for one, two in pairwise(rows))


@pytest.mark.parametrize("seed", range(10))
def test_between_two_rows_every_number_is_linear(seed: int) -> None:
    print(f"seed {seed}")
    rng = np.random.default_rng(seed)
    between = 0
    for _ in range(40):
        first = int(rng.integers(len(ROWS) - 1))
        one, two = ROWS[first : first + 2]
        if (one.process, one.material, one.consumable) != (two.process, two.material, two.consumable):
            continue
        between += 1
        share = float(rng.uniform(0.05, 0.95))
        thickness_mm = one.thickness_mm + share * (two.thickness_mm - one.thickness_mm)
        if min(thickness_mm - one.thickness_mm, two.thickness_mm - thickness_mm) < 0.01:
            continue
        row = cut_data_for(one.process, one.material, thickness_mm, one.consumable, [two, one])
        for key in ("feed_mm_min", "kerf_mm", "amperes", "pressure_bar"):
            low, high = getattr(one, key), getattr(two, key)
            assert getattr(row, key) == pytest.approx(low + share * (high - low), abs=1e-5)
        assert row.number == 0 and row.name == "" and "interpolated" in row.source
    assert between > 20


def test_what_only_one_of_two_rows_gives_is_taken_from_it() -> None:
    thin = CutData(process="plasma", material="x", thickness_mm=1, feed_mm_min=1000, kerf_mm=1, pierce_delay_s=0)
    thick = CutData(process="plasma", material="x", thickness_mm=3, feed_mm_min=500, kerf_mm=2, pierce_delay_s=0.4)
    assert cut_data_for("plasma", "x", 2, "", [thin, thick]).pierce_delay_s == 0.4
    assert cut_data_for("plasma", "x", 1, "", [thin, thick]) is thin


@pytest.mark.parametrize("name", ["Mild Steel", "mild_steel", "STEEL", "mild-steel"])
def test_a_material_is_known_by_its_other_spellings(name: str) -> None:
    assert cut_data_for("plasma", name, 3).material == "mild-steel"


def test_the_kerf_of_a_wire_follows_the_feed_and_is_refused_beyond_what_was_measured() -> None:
    row = cut_data_for("hot-wire", "isopor", 50)
    assert row.kerf_at(300) == row.kerf_mm == 1.2
    assert row.kerf_at(225) == pytest.approx(1.5)
    with pytest.raises(JobError) as refused:
        row.kerf_at(601)
    assert (refused.value.code, refused.value.limit) == ("chart-feed", "150 to 600 mm/min")
    assert cut_data_for("plasma", "mild-steel", 3).kerf_at(10) == 1.5


def test_the_power_is_the_rows_else_a_share_of_the_machines_most() -> None:
    row = cut_data_for("laser", "acrylic", 3)
    assert row.power_s(1000.0) == pytest.approx(700.0)
    assert row.model_copy(update={"power": 255.0}).power_s(1000.0) == 255.0
    assert cut_data_for("plasma", "mild-steel", 3).power_s() == 1.0


@pytest.mark.parametrize(
    ("asked", "code", "said"),
    [
        (("plasma", "wood", 3.0), "chart-material", "mild-steel, stainless, aluminium"),
        (("plasma", "mild-steel", 40.0), "chart-thickness", "0.5 to 6 mm with 45A"),
        (("plasma", "mild-steel", 0.3), "chart-thickness", "0.3 mm"),
        (("plasma", "mild-steel", 8.0, "45A"), "chart-thickness", "limit 0.5 to 6 mm with 45A"),
        (("plasma", "mild-steel", 3.0, "200A"), "chart-consumable", "45A, 65A, 85A"),
        (("milling", "mild-steel", 3.0), "chart-process", "plasma, oxyfuel"),
        (("sawing", "mild-steel", 3.0), "process-unknown", "plasma"),
    ],
)
def test_what_the_chart_does_not_cover_is_refused_with_what_it_does(asked: tuple, code: str, said: str) -> None:
    with pytest.raises(JobError) as refused:
        cut_data_for(*asked)
    assert refused.value.code == code and said in str(refused.value)


def test_a_shops_own_chart_is_taken_alone() -> None:
    own = [CutData(process="plasma", material="copper", thickness_mm=2, feed_mm_min=900, kerf_mm=1.1)]
    assert cut_data_for("plasma", "copper", 2.0, chart=own).feed_mm_min == 900
    with pytest.raises(JobError, match="copper"):
        cut_data_for("plasma", "mild-steel", 3.0, chart=own)
    with pytest.raises(JobError, match="it is for plasma"):
        cut_data_for("laser", "copper", 2.0, chart=own)


def test_a_chart_that_is_written_reads_as_it_was(tmp_path: Path) -> None:
    odd = ROWS[0].model_copy(update={"material": 'a "b" \\ ção', "thc": False, "number": 7, "source": "tab\there"})
    assert write_chart(tmp_path / "all.toml", [*ROWS, odd]) == []
    assert read_chart(tmp_path / "all.toml") == [*ROWS, odd]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (ROW.replace("1000.0", "nan"), "feed_mm_min"),
        (ROW.replace("1000.0", "inf"), "feed_mm_min"),
        (ROW.replace("1000.0", "1e9"), "feed_mm_min"),
        (ROW.replace("1000.0", '"fast"'), "feed_mm_min"),
        (ROW.replace("1000.0", "true"), "feed_mm_min"),
        (ROW.replace("kerf_mm = 1.2", "kerf_mm = 0"), "kerf_mm"),
        (ROW.replace("kerf_mm", "kerf"), "kerf"),
        (ROW.replace("2.0", "-2.0"), "thickness_mm"),
        (ROW.replace('"plasma"', '"sawing"'), "process"),
        (ROW + "kerf_by_feed = [[100, 1.0], [50, 1.2]]\n", "feeds must rise"),
        (ROW + "kerf_by_feed = [[100, 1.0], [200, 1.2]]\n", "kerfs must not"),
        (ROW + "rows = 3\n", "list of tables"),
        (ROW + ROW, "two rows"),
        (ROW + ROW.replace("copper", "Copper"), "two rows"),
        ("cut = 3\n", "[[cut]]"),
        (ROW + "[tool]\n", "[[cut]]"),
        ("", "[[cut]]"),
        ("[[cut", "not a TOML file"),
        ("[[cut]]\nrows = [" + "{thickness_mm = 1}," * 5001 + "]\n", "too many rows"),
    ],
)
def test_a_hostile_chart_is_refused_with_its_file_and_key(text: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(JobError) as refused:
        read_chart(chart(tmp_path, text))
    assert said in str(refused.value) and "own.toml" in str(refused.value.place)


def test_rows_share_the_keys_of_their_table(tmp_path: Path) -> None:
    table = ROW.replace("thickness_mm = 2.0\nfeed_mm_min = 1000.0\n", "")
    rows = (
        "rows = [{ thickness_mm = 1.0, feed_mm_min = 2000.0 }, { thickness_mm = 2.0, feed_mm_min = 1.0, kerf_mm = 2 }]"
    )
    found = read_chart(chart(tmp_path, table + rows))
    assert [(row.thickness_mm, row.feed_mm_min, row.kerf_mm) for row in found] == [(1, 2000, 1.2), (2, 1, 2)]
