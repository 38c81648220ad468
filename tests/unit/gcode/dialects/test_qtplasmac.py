# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs for QtPlasmaC: only documented words in their order, read back as the table, taken by its own filter."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from math import cos, sin
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.conversion.convert import convert
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.plasma_words import PlasmaSwitches
from CNCStepper.gcode.writer.write import WriteOptions, written
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.prove import prove_job
from CNCStepper.machine.cut_charts import cut_data_for, write_chart
from CNCStepper.machine.cut_data import CutData
from CNCStepper.state import Start, State, ToolEntry
from CNCStepper.toolpath import ARC_CCW, RAPID, TableBuilder, Toolpath
from helpers.gcode.qtplasmac_words import filtered, out_of_order, undocumented, with_numbers
from helpers.gcode.rs274_runs import rs274_calls

ROOT = Path(__file__).parents[4]
ROW = cut_data_for("plasma", "mild-steel", 3.0)
NUMBERED = ROW.model_copy(update={"number": 7})
ZERO = Start.at_zero()
PREAMBLE = "G21 G64 P0.02\nM52 P1\n"
TORCH = PREAMBLE + "(o=0, ph=3.8, pd=0.4, ch=1.5, fr=3000, kw=1.5)\nF#<_hal[plasmac.cut-feed-rate]>\n"


def sheet(seed: int, counts: Counter[str] | None = None, scribes: bool = False) -> Toolpath:
    """Return random holes and lines as the cutting cycle writes them, with heights, dwells and ends without power."""
    rng, counts = np.random.default_rng(seed), Counter() if counts is None else counts
    table = TableBuilder(ZERO, State(tool=1))
    for _ in range(int(rng.integers(2, 7))):
        x, y, radius = (float(value) for value in rng.uniform((0, 0, 3), (400, 300, 30)).round(3))
        feed = ROW.feed_mm_min * float(rng.choice([1.0, 0.6, 0.75, 0.333]))
        tool = int(rng.choice([0, 0, 2, 1] if scribes else [0, 0, 2]))
        over = float(rng.choice([0.0, 0.5]))
        counts.update(
            {f"tool {tool}": 1, "slow": feed < ROW.feed_mm_min, "over": over > 0, "fast": feed == ROW.feed_mm_min}
        )
        table.rapid((x, y, 10))
        table.rapid((x, y, 3.8))
        table.set_state(replace(table.state, spindle="cw", spindle_rpm=1.0, spindle_number=tool))
        table.event("dwell", ROW.pierce_delay_s)
        table.feed((x, y, 1.5), ROW.feed_mm_min)
        table.feed((x + radius, y, 1.5), ROW.feed_mm_min)
        table.arc(ARC_CCW, (x + radius, y, 1.5), (x, y, 1.5), feed)
        table.set_state(replace(table.state, spindle="off"))
        if over:
            end = (x + radius * cos(over), y + radius * sin(over), 1.5)
            table.arc(ARC_CCW, end, (x, y, 1.5), feed)
        table.rapid((x, y, 10))
    return table.toolpath()


def options(units: str = "mm", row: CutData | None = ROW) -> WriteOptions:
    return WriteOptions(units=units, cut_data=row, tools={1: "jet 1.5 mm"})


def flat_rows(path: Toolpath) -> list[tuple]:
    """Return kind, end, feed and power of the moves in the plane."""
    table, at, rows = path.table(), (np.nan, np.nan), []
    for kind, end, feed, state in zip(table.kind, table.end, table.feed, table.state, strict=True):
        here = tuple(float(value) for value in end[:2])
        if kind not in (RAPID, 1) or not np.allclose(here, at, atol=1e-9):
            one = path.states[int(state)]
            power = one.spindle, one.spindle_number if one.spindle != "off" else 0
            rows.append((int(kind), *here, float(feed) if kind != RAPID else 0.0, *power))
        at = here
    return rows


@pytest.mark.parametrize("units", ["mm", "inch"])
@pytest.mark.parametrize("row", [ROW, NUMBERED, None], ids=["temporary", "numbered", "none"])
def test_what_is_written_reads_as_the_table_without_heights_and_writes_as_the_same_text(units, row):
    counts: Counter[str] = Counter()
    for seed in range(25):
        path, given = sheet(seed, counts, scribes=True), options(units, row)
        made = written(path, "qtplasmac", given)
        read = interpret(made.text, ZERO, "qtplasmac")
        rows = [one for one in flat_rows(read) if one[0] != RAPID]
        wanted = [one for one in flat_rows(path) if one[0] != RAPID]
        assert len(rows) == len(wanted), f"seed {seed}\n{made.text}"
        for one, other in zip(rows, wanted, strict=True):
            assert one[0] == other[0] and one[4:] == other[4:], f"seed {seed}"
            assert np.allclose(one[1:3], other[1:3], atol=0.003) and one[3] == pytest.approx(other[3], rel=2e-3)
        assert written(read, "qtplasmac", given).text == made.text
        assert undocumented(made.text) == [] and out_of_order(made.text) == []
    assert all(counts[name] > 15 for name in ("tool 0", "tool 1", "tool 2", "slow", "fast", "over"))


def test_the_words_of_a_small_hole_are_the_documents():
    table = TableBuilder(ZERO, State(tool=1))
    table.rapid((10, 10, 0))
    table.set_state(replace(table.state, spindle="cw", spindle_rpm=1.0))
    table.event("dwell", 0.4)
    table.feed((15, 10, 0), 3850)
    table.arc(ARC_CCW, (15, 10, 0), (10, 10, 0), 2310)
    table.set_state(State(tool=1))
    table.arc(ARC_CCW, (10, 15, 0), (10, 10, 0), 2310)
    text = written(table.toolpath(), "qtplasmac", options(row=NUMBERED)).text
    assert text.splitlines()[5:] == [
        "(nu=7, na=mild-steel 3 mm 45A, ph=3.8, pd=0.4, ch=1.5, fr=3850, kw=1.5, th=1, ca=45)",
        "M190 P7",
        "M66 P3 L3 Q1",
        "F#<_hal[plasmac.cut-feed-rate]>",
        "G54",
        "G0 X10.000 Y10.000",
        "M3 $0 S1",
        "G1 X15.000",
        "M67 E3 Q60",
        "G3 X15.000 Y10.000 I-5.000 J0.000",
        "M62 P3",
        "G3 X10.000 Y15.000 I-5.000 J0.000",
        "M63 P3",
        "M67 E3 Q0",
        "M5 $0",
        "M5 $-1",
        "M9",
        "M68 E3 Q0",
        "M2",
    ]


def test_a_feed_above_the_materials_is_said_by_f():
    table = TableBuilder(ZERO, State(spindle="cw", spindle_rpm=1.0))
    for x, feed in ((1, 3850), (2, 5000), (3, 1925)):
        table.feed((x, 0, 0), feed)
    text = written(table.toolpath(), "qtplasmac", options()).text
    assert [line for line in text.splitlines() if line[0] == "F" or "E3" in line] == [
        "M68 E3 Q0", "F#<_hal[plasmac.cut-feed-rate]>", "F5000", "F#<_hal[plasmac.cut-feed-rate]>", "M67 E3 Q50",
        "M67 E3 Q0", "M68 E3 Q0",
    ]  # fmt: skip
    assert interpret(text, ZERO, "qtplasmac").table().feed.tolist() == [3850, 5000, 1925]


@pytest.mark.parametrize("units", ["mm", "inch"])
def test_linuxcnc_runs_what_is_written_once_numbers_stand_for_what_only_qtplasmac_knows(units, tmp_path):
    for seed in range(8):
        for row in (ROW, NUMBERED, None):
            text = written(sheet(seed), "qtplasmac", options(units, row)).text.replace(
                "$2", "$0"
            )  # rs274 has spindle 0
            calls, accepted = rs274_calls(with_numbers(text, 3850 if units == "mm" else 150), tmp_path)
            assert accepted, f"seed {seed}: {calls[-3:]}\n{text}"
            assert sum("ARC_FEED" in call for call in calls) >= 2
            assert not any("DWELL" in call for call in calls)


@pytest.mark.parametrize("units", ["mm", "inch"])
@pytest.mark.parametrize("row", [ROW, NUMBERED], ids=["temporary", "numbered"])
def test_qtplasmacs_own_filter_takes_what_is_written_without_a_word(units, row, tmp_path):
    materials = tmp_path / "a_material.cfg"
    write_chart(materials, [NUMBERED], units)
    for seed in range(4):
        text = written(sheet(seed), "qtplasmac", options(units, row)).text
        out, faults = filtered(text, tmp_path, materials.read_text("ascii"), inch=units == "inch")
        assert faults == [] and ";qtplasmac filtered" in out
        assert sum(line.startswith("m3$") for line in out.splitlines()) == text.count("M3 $")


def test_the_filter_does_find_faults(tmp_path):
    _, faults = filtered("G21\nM190 P9\nM66 P3 L3 Q1\nM3 $0 S1\nF#<_hal[plasmac.cut-feed-rate]>\nG1 X1\nM2\n", tmp_path)
    assert any("missing from the material file" in fault for fault in faults)
    assert any("before movement" in fault for fault in faults)


# reading


@pytest.mark.parametrize(
    "line",
    ["M3 $3 S1", "M4 $0 S1", "M67 E3", "M190", "M190 P1.5", "M66 P3 L3", "M66 P3 L3 Q0", "#<hole> = 2", "G18", "G0 Z5",
     "F#<_hal[plasmac.torch-on]>", "M5 $3", "M62 P4", "#<holes> = 5", "(o=3, ph=1, pd=1, ch=1, fr=1)"],
)  # fmt: skip
def test_the_reader_of_the_tests_refuses_what_is_not_documented(line):
    assert undocumented(line) == [line]


@pytest.mark.parametrize(
    "line",
    ["M3 $0 S1", "M3 $1 S1", "M3 $2 S1", "M5 $0", "M5 $-1", "M67 E3 Q60", "M68 E3 Q0", "M62 P3", "M63 P1", "M64 P2",
     "M65 P3", "M190 P12", "M190 P-1", "M66 P3 L3 Q1", "M52 P1", "#<holes> = 2", "#<oclength> = 6.5", "T1 M6", "G43 H0",
     "#<h_diameter>=20", "#<h_velocity> = 50", "#<pierce-only> = 1", "#<keep-z-motion>=1", "#<tube-cut>=1"],
)  # fmt: skip
def test_every_documented_word_is_read(line):
    assert undocumented(line) == []
    path = interpret(f"{PREAMBLE}(nu=12, ph=3.8, pd=0.4, ch=1.5, fr=3000)\nG0 X1\n{line}\nM2\n", ZERO, "qtplasmac")
    warned = any(event.kind == "warning" for event in path.events)
    assert warned == any(name in line for name in ("holes", "pierce-only", "keep-z", "tube-cut"))


@pytest.mark.parametrize(
    ("lines", "code"),
    [
        ("M3 $3 S1", "spindle-number"),
        ("M3 $-1 S1", "spindle-number"),
        ("M3 $0 S1\nM3 $1 S1", "spindle-number"),
        ("M4 S1", "refused-code"),
        ("G18", "refused-code"),
        ("M190", "missing-word"),
        ("M190 P1.5", "bad-value"),
        ("M190 P-2", "bad-value"),
        ("M190 P1000000", "bad-value"),
        ("M66 P3 L3", "missing-word"),
        ("M67 Q60", "missing-word"),
        ("F#<_hal[plasmac.cut-feed-rate]>", "material-unknown"),
        ("M190 P3\nM66 P3 L3 Q1\nF#<_hal[plasmac.cut-feed-rate]>", "material-unknown"),
        ("F#<_hal[plasmac.torch-on]>", "unknown-parameter"),
        ("(o=0, ph=3.8, pd=0.4, ch=1.5)", "material"),
        ("(o=0, ph=3.8, pd=0.4, ch=1.5, fr=nan)", "material"),
        ("(o=0, ph=3.8, pd=0.4, ch=1.5, fr=-1)", "material"),
        ("(o=0, ph=3.8, pd=0.4, ch=1.5, fr=1e99)", "material"),
        ("(o=0, ph=3.8, ph=3.8, pd=0.4, ch=1.5, fr=1)", "material"),
        ("(o=0, ph=3.8, pd=0.4, ch=1.5, fr=1, xx=3)", "material"),
        ("(o=1, ph=3.8, pd=0.4, ch=1.5, fr=1)", "material"),
        ("(o=7, nu=3, na=a, ph=3.8, pd=0.4, ch=1.5, fr=1)", "material"),
        ("(o=0, ph=3.8, pd=0.4, ch=1.5, fr=1, th=2)", "material"),
        ("(o=0, ph=3.8, pd=0.4, ch=1.5, fr=1, cm=1.5)", "material"),
    ],
)
def test_what_qtplasmac_could_not_take_is_refused_with_its_line(lines, code):
    with pytest.raises(ProgramError) as refused:
        interpret(f"{PREAMBLE}G0 X1\n{lines}\nM2\n", ZERO, "qtplasmac")
    assert refused.value.code == code
    assert refused.value.place is not None and refused.value.place.line == 3 + len(lines.splitlines())


def test_a_numbered_material_is_known_by_its_comment_and_the_default_by_the_callers_feed():
    known = (
        "(nu=3, ph=3.8, pd=0.4, ch=1.5, fr=2500)\nM190 P3\nM66 P3 L3 Q1\nF#<_hal[plasmac.cut-feed-rate]>\nG1 X1\nM2\n"
    )
    assert interpret(PREAMBLE + known, ZERO, "qtplasmac").table().feed.tolist() == [2500]
    given = PREAMBLE + "F#<_hal[plasmac.cut-feed-rate]>\nG1 X1\nM2\n"
    assert interpret(given, ZERO, "qtplasmac:feed=1800").table().feed.tolist() == [1800]
    inches = "G20\n(o=0, ph=0.15, pd=0.4, ch=0.06, fr=100)\nF#<_hal[plasmac.cut-feed-rate]>\nG1 X1\nM2\n"
    assert interpret(inches, ZERO, "qtplasmac").table().feed.tolist() == [pytest.approx(2540)]


def test_the_share_of_the_feed_holds_until_it_is_taken_back():
    moves = "M67 E3 Q60\nG1 X1\nX2\nF1000\nX3\nM68 E3 Q0\nX4\nM67 E3 Q150\nX5\nM67 E3 Q-4\nX6\nM67 E5 Q9\nX7\nM2\n"
    feeds = interpret(TORCH + moves, ZERO, "qtplasmac").table().feed
    assert feeds.tolist() == pytest.approx([1800, 1800, 600, 1000, 1000, 1000, 1000])


def test_the_torch_goes_off_and_on_as_the_words_say():
    moves = (
        "G0 X1\nM3 $0 S1\nG1 X2\nM62 P3\nX3\nM62 P2\nX4\nM63 P3\nM5 $0\nG0 X5\n"
        "M3 $2 S1\nG1 X6\nM5 $0\nX7\nM5 $2\nX8\nM3 S1\nX9\nM5\nX10\nM2\n"
    )
    path = interpret(TORCH + moves, ZERO, "qtplasmac")
    on = [path.states[state].spindle for state in path.table().state]
    assert on == ["off", "cw", "off", "off", "off", "cw", "cw", "off", "cw", "off"]
    assert [event.text for event in path.events if event.kind == "output"] == ["M62 P2"]


def test_moves_of_z_are_taken_out_as_the_filter_does_it():
    moves = (
        "G53 G0 Z[#<_ini[axis_z]max_limit>*1 - 5.000] (Z just below max)\nG0 X5 Z10 Y6\nz3\nG1 X7 Z#5 F9 (Z 4)\nM2\n"
    )
    path = interpret(TORCH + moves, ZERO, "qtplasmac")
    assert path.table().end.tolist() == [[5, 6, 0], [7, 6, 0]]
    assert [event.text for event in path.events if event.kind == "comment"] == ["Z just below max", "Z 4"]


def test_the_samples_that_ship_with_linuxcnc_are_read():
    folder = Path("/usr/share/linuxcnc/ncfiles/plasmac")
    programs = sorted(folder.glob("*.ngc"))
    assert len(programs) > 10
    for program in programs:
        text = program.read_text("latin-1")
        language = "qtplasmac" if "(o=" in text else "qtplasmac:feed=3000"
        materials = "".join(f"(nu={number}, ph=3, pd=1, ch=1, fr=3000)\n" for number in range(1, 9))
        if "M190" in text.upper():
            text = materials + text
        path = interpret(text, replace(ZERO, tools={0: ToolEntry(), 1: ToolEntry()}), language)
        assert len(path) > 1 and (path.table().end[:, 2] == 0).all()


# converting

GRBL = "G21 G90\nG0 X10 Y10\nM3 S1000\nG4 P0.4\nG1 X60 F3000\n{within}Y40\nM5\nG4 P2\nG0 X0 Y0\nM2\n"


@pytest.mark.parametrize("within", ["", "G4 P1.5\n"])
def test_a_torch_program_is_converted_without_its_pierce_delay_and_with_all_other_dwells(within, tmp_path):
    text = convert(GRBL.format(within=within), "grbl", "qtplasmac", ZERO).text
    assert undocumented(text) == [] and out_of_order(text) == []
    lines = text.splitlines()
    assert lines[lines.index("M3 $0 S1") + 1].startswith("G1 X60")
    assert [line for line in lines if line.startswith("G4 ")] == [*(["G4 P1.5"] if within else []), "G4 P2"]
    assert rs274_calls(text, tmp_path)[1]


def test_a_conversion_that_loses_another_dwell_is_refused(monkeypatch):
    monkeypatch.setattr(PlasmaSwitches, "dwell", lambda *_: None)
    with pytest.raises(ProgramError) as refused:
        convert(GRBL.format(within=""), "grbl", "qtplasmac", ZERO)
    assert refused.value.code == "convert-differs" and "dwell 2" in refused.value.value


# a job


@pytest.mark.slow
def test_the_gasket_is_cut_by_the_table_with_qtplasmac_that_ships(tmp_path):
    job = (ROOT / "examples" / "jobs" / "gasket-plasma.toml").read_text("utf-8").replace("torch-table", "plasmac-table")
    drawings = (ROOT / "examples" / "drawings").as_posix()
    (tmp_path / "gasket.toml").write_text(job.replace("../drawings", drawings), "utf-8")
    asked, machine = load_job(tmp_path / "gasket.toml")
    made = make_program(asked, machine)
    text = made.program
    assert undocumented(text) == [] and out_of_order(text) == [] and "Z" not in text and "G4 " not in text
    assert text.count("M3 $0 S1") == text.count("M5 $0") == 7
    assert text.count("M67 E3 Q60") == text.count("M62 P3") == text.count("M63 P3") == 4  # the small holes
    assert filtered(text, tmp_path)[1] == [] and rs274_calls(with_numbers(text, 3850), tmp_path)[1]
    read = interpret(text, ZERO, machine.language())
    assert [event.value for event in read.events if event.kind == "dwell"] == [0.4] * 7  # the material's pierce delay
    wanted = [one for one in flat_rows(made.toolpath) if one[0] != RAPID]
    for one, other in zip((one for one in flat_rows(read) if one[0] != RAPID), wanted, strict=True):
        assert one[0] == other[0] and one[4:] == other[4:] and one[1:3] == pytest.approx(other[1:3], abs=0.003)
        assert one[3] == pytest.approx(other[3], rel=2e-3)
    proof = prove_job(asked, machine, text, file="gasket.ngc")
    assert not proof.refused and {one.code for one in proof.findings if one.severity == "error"} == set()
    assert len(proof.pieces) >= 7
