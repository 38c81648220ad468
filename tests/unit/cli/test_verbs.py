# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line as a stranger uses it: exit states, findings, files."""

from __future__ import annotations

import io
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import FAMILY_OF, group, main
from CNCStepper.control.program.certificate import Certificate
from CNCStepper.errors import ProgramError
from CNCStepper.simulation.meshes.stl_mesh import STL_FACET

ROOT = Path(__file__).parents[3]
JOBS = ROOT / "examples" / "jobs"
POCKET = JOBS / "elliptical-pocket.toml"
PLATE = ("--stock", "40,40,5", "--origin", "top-left-front", "--tool", "flat:6")
SQUARE = "G21 G90 G17\nT1\nM3 S10000\nG4 P3\nG0 Z5\nG0 X0 Y0\nG1 Z-1 F100\nG1 X20 F500\nY20\nX0\nY0\nG0 Z5\nM5\nM2\n"


def run(*arguments: str | Path) -> Result:
    return CliRunner().invoke(group, [str(argument) for argument in arguments])


@pytest.fixture
def square(tmp_path: Path) -> Path:
    path = tmp_path / "peça nº 1.nc"
    path.write_text(SQUARE, encoding="utf-8")
    return path


@pytest.mark.parametrize("verb", FAMILY_OF)
def test_every_verb_has_a_help_for_strangers(verb: str) -> None:
    result = run(verb, "--help")
    assert result.exit_code == 0
    assert len(result.output.splitlines()) > 5


@pytest.mark.slow
def test_run_writes_program_report_and_picture_and_check_agrees(tmp_path: Path) -> None:
    job = JOBS / "brazil-engraving.toml"
    result = run("run", job, "--out", tmp_path / "saída 1")
    assert result.exit_code == 0, result.output
    report = json.loads((tmp_path / "saída 1" / "report.json").read_text("utf-8"))
    assert report["time_s"] > 40 and report["gouge_mm"] <= 0.01
    certificate = Certificate.read(tmp_path / "saída 1" / "certificate.zip")
    certificate.check_clean()
    assert certificate.content["times"]["operations_s"][0]["time_s"] > 40
    assert "pierces 1" in result.output and "engrave: " in result.output
    assert (tmp_path / "saída 1" / "part.png").read_bytes().startswith(b"\x89PNG")
    program = tmp_path / "saída 1" / "program.nc"
    assert program.read_text("ascii").endswith("M2\n")
    assert run("check", program, "--machine", "table-a", "--job", job).exit_code == 0
    program.write_text(program.read_text("ascii").replace("Y36.378", "Y36.428"), encoding="ascii")
    changed = run("check", program, "--machine", "table-a", "--job", job)
    assert changed.exit_code == 1 and "[gouge]" in changed.output


def test_a_clean_program_is_exit_0(square: Path) -> None:
    result = run("check", square, "--machine", "table-a", "--work-zero", "-200,-200,-40")
    assert result.exit_code == 0, result.output
    assert "clean" in result.output


def test_with_stock_and_tool_the_clean_program_stays_clean(square: Path) -> None:
    stock = ("--stock", "40,40,5", "--origin", "top-left-front", "--tool", "flat:6")
    assert run("check", square, "--machine", "table-a", *stock).exit_code == 0


def test_a_program_beyond_the_travel_is_exit_1_with_its_place(square: Path) -> None:
    result = run("check", square, "--machine", "table-a", "--work-zero", "-10,-200,-40")
    assert result.exit_code == 1
    assert f"{square}:8:" in result.output


def test_a_program_larger_than_the_travel_is_refused_without_a_zero(tmp_path: Path) -> None:
    path = tmp_path / "large.nc"
    path.write_text("G21 G90\nG0 Z5\nG0 X0 Y0\nG1 X400.01 F500\nM2\n", encoding="ascii")
    result = run("check", path, "--machine", "table-a")
    assert result.exit_code == 1
    assert "large.nc:4:" in result.output


@pytest.mark.slow
def test_a_word_that_is_none_is_exit_1_with_line_and_column(tmp_path: Path) -> None:
    path = tmp_path / "bad.nc"
    path.write_text("G21 G90\nG1 X10 F100 Q5\n", encoding="ascii")
    result = run("check", path, "--machine", "table-a")
    assert result.exit_code == 1
    assert result.output.startswith(f"{path}:2:13: ")
    outside = subprocess.run(
        [sys.executable, "-m", "CNCStepper.cli", "check", str(path), "--machine", "table-a"],
        capture_output=True,
        encoding="utf-8",
    )
    assert outside.returncode == 1
    assert "bad.nc:2:13" in outside.stdout and not outside.stderr


def test_every_bad_line_is_told(tmp_path: Path) -> None:
    path = tmp_path / "bad.nc"
    path.write_text("G21 G90\nG1 X10 F100 Q5\nG1 X11 F100\nG1 K2\nM2\n", encoding="ascii")
    lines = run("check", path, "--machine", "table-a").output.splitlines()
    assert [line.removeprefix(f"{path}:").split(":")[0] for line in lines[:-1]] == ["2", "4"]
    assert "refused" in lines[-1]


def test_an_empty_program_is_no_clean_one(tmp_path: Path) -> None:
    path = tmp_path / "empty.nc"
    path.write_text("", encoding="ascii")
    result = run("check", path, "--machine", "table-a")
    assert result.exit_code == 1
    assert "moves nothing" in result.output


def test_a_cut_at_an_unknown_place_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "blind.nc"
    path.write_text("G21 G90\nG0 X10\nG1 Z-5 F100\nG0 X30\nM2\n", encoding="ascii")
    result = run("check", path, "--machine", "table-a", "--stock", "40,40,5", "--tool", "flat:6")
    assert result.exit_code == 1
    assert f"{path}:3:" in result.output


@pytest.mark.slow
def test_run_tells_the_recalculated_stepover_and_what_no_tool_reaches(tmp_path: Path) -> None:
    text = (JOBS / "elliptical-pocket.toml").read_text("utf-8").replace('"../machines/table-a.toml"', '"table-a"')
    job = tmp_path / "narrow.toml"
    job.write_text(text.replace("radius_y_mm = 25", "radius_y_mm = 8"), encoding="utf-8")
    result = run("run", job, "--out", tmp_path / "out")
    assert result.exit_code == 0, result.output
    assert "stays at each end" in result.output and "ae_mm" in result.output
    figures = json.loads((tmp_path / "out" / "report.json").read_text("utf-8"))["operations"][0]["figures"]
    assert figures["ae_mm"] <= 2.4 and figures["ap_mm"] == pytest.approx(1.96) and figures["levels"] == 6


@pytest.mark.slow
def test_the_report_has_every_corner_that_no_tool_reaches(tmp_path: Path) -> None:
    result = run("run", JOBS / "cycles" / "rectangular-pocket.toml", "--out", tmp_path / "out")
    assert result.exit_code == 0, result.output
    operation = json.loads((tmp_path / "out" / "report.json").read_text("utf-8"))["operations"][-1]
    corners = operation["rest_corners"]
    assert len(corners) == operation["figures"]["rest_corners"] == 4
    assert all(set(corner) == {"thick_mm", "place_mm", "area_mm2"} and corner["thick_mm"] > 0 for corner in corners)


@pytest.mark.parametrize(
    "arguments",
    [
        ("check", "none.nc", "--machine", "table-a"),
        ("check", "SQUARE", "--machine", "table-z"),
        ("check", "SQUARE", "--machine", "table-a", "--stock", "40,40"),
        ("check", "SQUARE", "--machine", "table-a", "--stock", "40,40,5", "--tool", "round:6"),
        ("check", "SQUARE", "--machine", "table-a", "--tool", "flat:6"),
        ("check", "SQUARE", "--machine", "table-a", "--stock=-1,10,10"),
        ("check", "SQUARE", "--machine", "table-a", "--dialect", "nosuch"),
        ("check", "SQUARE"),
        ("simulate", "SQUARE", *PLATE, "--out", "p.gif"),
        ("simulate", "SQUARE", *PLATE, "--out", "p.png", "--at", "1", "--line", "2"),
        ("simulate", "SQUARE", *PLATE, "--out", "p.png", "--view", "yz"),
        ("simulate", "SQUARE", "--out", "p.png"),
        ("simulate", "SQUARE", *PLATE, "--job", POCKET, "--out", "p.png"),
        ("check", "SQUARE", "--machine", "table-a", "--tool", "flat:6", "--job", POCKET),
        ("virtual", "grbl"),
        ("send", "SQUARE"),
        ("send", "SQUARE", "--port", "none"),
        ("send", "SQUARE", "--port", "none", "--despite-certificate"),
        ("send", "SQUARE", "--port", "none", "--tool", "flat:6"),
        ("nonsense",),
    ],
)
def test_wrong_usage_is_exit_2(arguments: tuple[str, ...], square: Path) -> None:
    result = run(*(str(square) if argument == "SQUARE" else argument for argument in arguments))
    assert result.exit_code == 2, result.output


def test_time_is_one_number_on_the_last_line(square: Path) -> None:
    result = run("time", square, "--machine", "table-a")
    assert 17 < float(result.output.splitlines()[-1]) < 18.5


def test_simulate_draws_and_reports(square: Path, tmp_path: Path) -> None:
    out, told = tmp_path / "part.png", tmp_path / "part.json"
    result = run("simulate", square, *PLATE, "--out", out, "--json", told)
    assert result.exit_code == 0, result.output
    assert out.stat().st_size > 10_000
    assert json.loads(told.read_text("utf-8"))["removed_volume_mm3"] > 300


def test_simulate_has_a_first_picture_on_disk_before_it_judges(
    square: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, sizes = tmp_path / "part.png", []
    monkeypatch.setattr("CNCStepper.job.prove.times_and_whole_s", lambda *_: sizes.append(out.stat().st_size) or 1 / 0)
    assert isinstance(run("simulate", square, *PLATE, "--out", out).exception, ZeroDivisionError)
    assert sizes[0] > 1000 and out.read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
@pytest.mark.parametrize("view", ["isometric", "xy", "zy", "depth"])
def test_simulate_draws_each_view(view: str, square: Path, tmp_path: Path) -> None:
    for ending, begin in ((".png", b"\x89PNG"), (".svg", b"<?xml")):
        out = tmp_path / f"part{ending}"
        result = run("simulate", square, *PLATE, "--view", view, "--out", out, "--work-zero", "-200,-200,-40")
        assert result.exit_code == 0, result.output
        assert out.read_bytes().startswith(begin)


def removed_cm3(result: Result) -> float:
    return float(result.output.splitlines()[-1].rpartition(": ")[2].split()[0])


@pytest.mark.slow
def test_simulate_shows_the_part_at_a_moment_as_the_picture_and_the_mesh(square: Path, tmp_path: Path) -> None:
    volumes = []
    for more in ((), ("--at", "0"), ("--line", "7"), ("--line", "8")):
        stl = tmp_path / "part.stl"
        result = run("simulate", square, *PLATE, "--view", "zy", "--out", tmp_path / "part.png", "--stl", stl, *more)
        assert result.exit_code == 0, result.output
        facets = np.frombuffer(stl.read_bytes()[84:], STL_FACET)["points"].astype(float)
        volumes.append(float(np.einsum("ij,ij->", facets[:, 0], np.cross(facets[:, 1], facets[:, 2])) / 6))
        assert removed_cm3(result) == pytest.approx((8000 - volumes[-1]) / 1000, abs=0.06)
    assert ", line 8" in result.output
    whole, nothing, plunge, one_side = volumes
    quarter_mm2 = np.pi * 9 / 4  # of the tool, whose centre runs along the stock's edge; the cut is 1 mm deep
    assert nothing == pytest.approx(8000, rel=1e-6) and nothing - plunge == pytest.approx(quarter_mm2, rel=0.02)
    assert nothing - one_side == pytest.approx(20 * 3 + quarter_mm2, rel=0.02)
    assert whole < one_side


@pytest.mark.slow
def test_simulate_is_exit_1_when_a_check_refuses_the_program_and_draws_it(square: Path, tmp_path: Path) -> None:
    square.write_text(SQUARE.replace("G0 Z5\nM5", "G0 X40\nG0 Z5\nM5"), encoding="utf-8")
    out = tmp_path / "part.png"
    result = run("simulate", square, *PLATE, "--out", out)
    assert result.exit_code == 1 and f"{square}:12:" in result.output
    assert out.stat().st_size > 10_000


@pytest.mark.slow
def test_simulate_animates(square: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("CNCStepper.cli.program.simulate.ANIMATION_S", 0.4)
    out = tmp_path / "part.gif"
    assert run("simulate", square, *PLATE, "--view", "depth", "--out", out).exit_code == 0
    assert out.read_bytes().startswith(b"GIF89a")


@pytest.mark.slow
def test_a_program_changed_by_hand_is_checked_against_its_job(tmp_path: Path) -> None:
    assert run("run", POCKET, "--out", tmp_path).exit_code == 0
    program, told = tmp_path / "program.nc", tmp_path / "told.json"
    against = ("--job", POCKET, "--json", told)
    certificate = tmp_path / "again.json"
    clean = run("check", program, "--machine", "table-a", *against, "--certificate", certificate)
    assert clean.exit_code == 0, clean.output
    again, first = (
        Certificate.read(path).sending(made_with={}) for path in (certificate, tmp_path / "certificate.zip")
    )
    assert again.content == first.content
    lines = program.read_text("ascii").splitlines()
    last = max(number for number, line in enumerate(lines) if line.startswith("G3"))
    program.write_text("\n".join(lines[: last - 40] + lines[last + 1 :]), encoding="ascii")
    refused = run("check", program, "--machine", "table-a", *against)
    assert refused.exit_code == 1 and json.loads(told.read_text("utf-8"))["left_over_mm"] > 0.1
    drawn = run("simulate", program, "--job", POCKET, "--out", tmp_path / "p.png", "--view", "xy", "--line", "60")
    assert drawn.exit_code == 1 and "[left-over]" in drawn.output and ", line 60" in drawn.output


@pytest.mark.slow
def test_a_job_file_brings_its_clamps_and_edge_into_the_check(tmp_path: Path) -> None:
    text = POCKET.read_text("utf-8").replace("../machines/", f"{(ROOT / 'examples' / 'machines').as_posix()}/")
    careful, clamped = tmp_path / "careful.toml", tmp_path / "clamped.toml"
    careful.write_text(text.replace("[stock]", "[stock]\nedge_mm = 10.5"), encoding="utf-8")
    clamped.write_text(f"{text}\n[[clamp]]\ncorners_mm = [[35, -5], [48, 5]]\ntop_mm = 12\n", encoding="utf-8")
    assert run("run", POCKET, "--out", tmp_path).exit_code == 0
    for job, code in ((careful, "sheet-edge"), (clamped, "clamp")):
        result = run("check", tmp_path / "program.nc", "--machine", "table-a", "--job", job)
        assert result.exit_code == 1 and f"[{code}]" in result.output, result.output


def test_time_and_steps_refuse_further_axes_with_their_line(tmp_path: Path) -> None:
    program = tmp_path / "turned.ngc"
    program.write_text("G21 G90\nG0 X1\nG1 A90 F100\nM2\n", encoding="ascii")
    for verb in (("time", program), ("steps", program, "--as", "csv")):
        error = run(*verb, "--machine", "table-a", "--dialect", "linuxcnc").exception
        assert isinstance(error, ProgramError) and str(error).startswith(f"{program}:3: moves of A B C U V W")


def test_a_tool_table_tells_lengths_and_diameters_to_every_verb(tmp_path: Path) -> None:
    program, table, out = tmp_path / "part.ngc", tmp_path / "peças.tbl", tmp_path / "new.ngc"
    lines = "G21 G90 T1 M6\nG43\nS1000 M3 F200\nG0 X0 Y0 Z5\nG41 G1 X20 Y1\nG1 Y20\nG40 G0 Z9\nM5\nM2\n"
    program.write_text(lines, encoding="ascii")
    table.write_text("T1 P1 D6 Z41.5 ; flat\n", encoding="ascii")
    verbs = (
        ("time", program, "--machine", "table-a"),
        ("check", program, "--machine", "table-a"),
        ("edit", "feeds", program, "--factor", "2"),
        ("print", program, "--out", tmp_path / "sheet.html"),
        ("convert", program, "--to", "linuxcnc", "-o", out),
    )
    for verb in verbs:
        bare = run(*verb, "--dialect", "linuxcnc")
        assert bare.exit_code == 1 and "tool 1 is not in the tool table" in f"{bare.exception}{bare.output}"
        told = run(*verb, "--dialect", "linuxcnc", "--tool-table", table)
        assert told.exit_code == 0, told.output


def hints_in(lines: list[str]) -> list[str]:
    """Return the hints but the conversion, which test_conversion_hint.py holds."""
    return [line for line in lines if line.startswith("hint: ") and "cncstepper convert" not in line]


def test_no_option_is_named_that_the_verb_lacks(tmp_path: Path, monkeypatch, capsys) -> None:
    path = tmp_path / "drawn.nc"
    path.write_text("#1=2\nG0 X#1\nM2\n", encoding="ascii")
    monkeypatch.setattr(sys, "argv", ["cncstepper", "drawing", str(path)])
    with pytest.raises(SystemExit, match="1"):
        main()
    told = capsys.readouterr().err
    assert "not part of this dialect" in told and "--dialect" not in told


@pytest.mark.parametrize(
    ("text", "more", "hint"),
    [
        ("#1=2\nG0 X#1\nG0 Y#1\nM2\n", (), "hint: --dialect says"),
        ("o1 sub\no1 endsub\nM2\n", (), "hint: --dialect says"),
        ("T3 M6\nG43\nM2\n", ("--dialect", "linuxcnc"), "hint: --tool-table FILE"),
        ("G17 G41 D3\nG1 X1 F1\nM2\n", ("--dialect", "linuxcnc"), "hint: --tool-table FILE"),
        ("G28\nM2\n", (), "hint: --position X,Y,Z says where the machine stands at first, --parameters FILE"),
        ("o<far> call\nM2\n", ("--dialect", "linuxcnc"), "hint: --search FOLDER"),
        ("G0 Q\nM2\n", (), None),
    ],
)
def test_a_refusal_names_the_option_that_helps(tmp_path: Path, monkeypatch, text, more, hint) -> None:
    path = tmp_path / "ç 1.ngc"
    path.write_text(text, encoding="ascii")
    checked = run("check", path, "--machine", "table-a", *more)
    monkeypatch.setattr(sys, "argv", ["cncstepper", "time", str(path), "--machine", "table-a", *more])
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(io.BytesIO()))
    monkeypatch.setattr(sys, "stderr", told := io.TextIOWrapper(io.BytesIO(), "utf-8"))
    with pytest.raises(SystemExit, match="1"):
        main()
    told.flush()
    for lines in (checked.stderr.splitlines(), told.buffer.getvalue().decode("utf-8").splitlines()):
        assert checked.exit_code == 1 and len(hints_in(lines)) == (hint is not None)
        assert hint is None or hints_in(lines)[0].startswith(hint)


def test_each_verb_says_how_it_reads_by_default() -> None:
    def told(*verb: str) -> str:
        return " ".join(run(*verb, "--help").output.split())

    assert "[default: linuxcnc]" in told("trace") and "[default: linuxcnc]" in told("convert")
    for verb in (("check",), ("time",), ("print",), ("edit", "offset"), ("compact",), ("simulate",)):
        assert "[default: as the machine does; without one grbl]" in told(*verb)


def test_trace_prints_canonical_calls(square: Path) -> None:
    assert "STRAIGHT_FEED(20.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)" in run("trace", square).output


def test_another_dialect_reads_another_language(tmp_path: Path) -> None:
    path = tmp_path / "thesis.nc"
    path.write_text("g0 x2 y11\nG2 X11 Y2 I1 J1\nG90\ny-8\n", encoding="ascii")
    assert run("check", path, "--machine", "table-a").exit_code == 1  # I and J are no absolute centre for grbl
    result = run("check", path, "--machine", "table-a", "--dialect", "thesis-a")
    assert result.exit_code == 0, result.output
