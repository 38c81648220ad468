# SPDX-License-Identifier: LGPL-2.1-or-later
"""`check`, `simulate`, `time` and `edit` of lathe programs: the part as cut, and how X is given."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from helpers.cli.command_line import called, command, forked

HEAD = ("G21 G18 {mode} G90 G94", "T1 M6", "S1000 M3", "G4 P3")
MOVES = (("G0", 30, 5), ("G0", 25, 5), ("G1", 25, -40), ("G1", 29, -38), ("G0", 30, 5))
BAR = ("--bar", "55x170", "--face", "1", "--turning-tool", "1=CNMG120408", "--dialect", "linuxcnc")


@pytest.fixture
def program(tmp_path: Path):
    """Return a writer of the same program with X as diameter (G7) or radius (G8)."""

    def write(mode: str, moves=MOVES) -> Path:
        factor = 2 if mode == "G7" else 1
        words = [f"{code} X{factor * x:g} Z{z:g}" + (" F200" if code == "G1" else "") for code, x, z in moves]
        file = tmp_path / f"{mode}.ngc"
        file.write_text("\n".join([*HEAD, *words, "M2", ""]).format(mode=mode))
        return file

    return write


@pytest.mark.parametrize(("mode", "words"), [("G7", "X is a diameter"), ("G8", "X is a radius")])
def test_simulate_draws_the_half_section_and_reads_dimensions(program, tmp_path: Path, mode: str, words: str) -> None:
    picture, report = tmp_path / "part.png", tmp_path / "report.json"
    more = ("--read-at", "-20", "--read-at", "-60", "--json", report, "--machine", "table-a")
    ended = called("simulate", program(mode), *BAR, "-o", picture, *more)
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert words in ended.stdout
    assert "Z-20: diameter 50.0000 mm, bore 0.0000 mm" in ended.stdout
    assert "Z-60: diameter 55.0000 mm" in ended.stdout
    assert picture.read_bytes().startswith(b"\x89PNG")
    content = json.loads(report.read_text("utf-8"))
    assert content["profile"][0] == [-170, 55]
    assert content["x_is"] in words


def test_simulate_writes_the_turned_part_as_a_mesh(program, tmp_path: Path) -> None:
    picture, mesh = tmp_path / "part.png", tmp_path / "part.stl"
    ended = called("simulate", program("G7"), *BAR, "-o", picture, "--stl", mesh, "--machine", "table-a")
    assert ended.returncode == 0, ended.stdout + ended.stderr
    facet = np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("zero", "<u2")])
    points = np.frombuffer(mesh.read_bytes()[84:], facet)["points"].reshape(-1, 3)
    radius = np.hypot(*points[:, :2].T)
    assert radius.max() == pytest.approx(27.5, abs=1e-4)
    assert radius[np.abs(points[:, 2] + 40) < 0.01].min() == pytest.approx(25, abs=1.0)


def test_simulate_shows_the_part_after_a_line(program, tmp_path: Path) -> None:
    pictures = [tmp_path / name for name in ("begin.png", "end.png")]
    for picture, line in zip(pictures, ("5", "8"), strict=True):
        ended = called("simulate", program("G8"), *BAR, "-o", picture, "--line", line, "--machine", "table-a")
        assert ended.returncode == 0, ended.stderr
    assert pictures[0].read_bytes() != pictures[1].read_bytes()


@pytest.mark.parametrize(("mode", "x"), [("G7", "X5"), ("G8", "X2")])
def test_check_finds_a_rapid_in_stock_and_gives_x_as_the_program_does(program, mode: str, x: str) -> None:
    file = program(mode, (("G0", 30, 5), ("G0", 26, 5), ("G0", 26, -10), ("G0", 30, 5)))
    ended = called("check", file, *BAR, "--machine", "table-a")
    assert ended.returncode == 1
    line = next(line for line in ended.stdout.splitlines() if "[rapid-in-stock]" in line)
    assert line.startswith(f"{file}:7:1: error")
    assert f"at {x}" in line


def test_check_of_a_sound_program_is_clean(program) -> None:
    ended = called("check", program("G7"), *BAR, "--machine", "table-a")
    assert ended.returncode == 0, ended.stdout
    assert "[rapid-in-stock]" not in ended.stdout
    assert "clean" in ended.stdout


@pytest.mark.parametrize("mode", ["G7", "G8"])
def test_check_without_a_bar_measures_the_moves_and_their_speeds_though_no_y_is_known(program, mode: str) -> None:
    file = program(mode)
    ended = called("check", file, "--machine", "linuxcnc-lathe")
    assert ended.returncode == 0
    assert "cut 44.5 mm, in air 5.0 mm, rapid 48.0 mm" in ended.stdout
    assert "feed-above-rate" not in ended.stdout and "height-unknown" not in ended.stdout
    file.write_text(file.read_text().replace("F200", "F7000"))
    told = called("check", file, "--machine", "linuxcnc-lathe").stdout
    assert "more of Z than its highest rate (value 7000 mm/min, limit 6000 mm/min)" in told


def test_a_tool_that_is_not_given_is_named(program) -> None:
    options = ("--bar", "55x170", "--turning-tool", "2=drill:10", "--dialect", "linuxcnc")
    ended = called("check", program("G7"), *options, "--machine", "table-a")
    assert "[tool-unknown]" in ended.stdout


def test_tools_come_from_the_tool_table_too(program, tmp_path: Path) -> None:
    table = tmp_path / "tool.tbl"
    table.write_text("T1 P1 D1.6 I85 J5 Q2 ;turning\n")
    options = ("--bar", "55x170", "--tool-table", table, "--dialect", "linuxcnc", "--machine", "table-a")
    ended = called("simulate", program("G7"), *options, "-o", tmp_path / "a.png", "--read-at", "-20")
    assert "Z-20: diameter 50.0000 mm" in ended.stdout, ended.stdout + ended.stderr


def test_a_nose_that_is_not_known_is_no_fault_of_the_dialect(program) -> None:
    """Another dialect, which knows no G7, is not tried for a diameter that the tool table has to give."""
    file = program("G7", (("G42 G1", 25, 5), ("G1", 25, -40)))
    ended = called("check", file, "--machine", "linuxcnc-lathe")
    assert "[tool-diameter]" in ended.stdout + ended.stderr
    assert "--tool-table" in ended.stderr and "conversion" not in ended.stderr


def test_time_and_edit_say_how_x_is_given(program) -> None:
    for verb in (("time", program("G7"), "--machine", "table-a"), ("edit", "feeds", program("G7"), "--factor", "0.5")):
        ended = called(*verb, "--dialect", "linuxcnc")
        assert "X is a diameter" in ended.stderr
        assert ended.returncode == 0
    assert float(called("time", program("G7"), "--machine", "table-a", "--dialect", "linuxcnc").stdout) > 1
    milling = program("G17")
    assert "X is" not in called("time", milling, "--machine", "table-a", "--dialect", "linuxcnc").stderr


@pytest.mark.parametrize(
    "options",
    [
        ("--bar", "55"),
        ("--bar", "55x170x60"),
        ("--bar", "55x170", "--stock", "10,10,10"),
        ("--turning-tool", "CNMG120408"),
        ("--bar", "55x170", "--turning-tool", "spoon:3"),
        ("--bar", "55x170", "--view", "xy"),
        ("--read-at", "3", "--stock", "10,10,10", "--tool", "flat:3"),
    ],
)
def test_options_that_do_not_fit_are_usage_errors(program, tmp_path: Path, options: tuple[str, ...]) -> None:
    ended = called("simulate", program("G7"), "--dialect", "linuxcnc", "-o", tmp_path / "a.png", *options)
    assert ended.returncode == 2, ended.stderr


JOB = """machine = "mini-lathe"
process = "turning"
x_is = "radius"
start = [32.5, 6]
stock = {{ diameter_mm = 55, length_mm = 100 }}
tool = [{{ number = 1, insert = "CNMG 120408" }}, {{ number = 2, kind = "parting", width_mm = 3 }}]
profile = [{{ name = "shaft", points = [[25, 0], [25, -40]] }}]
operation = [{operations}]
"""
FINISH = '{ cycle = "turn_finish", tool = 1, profile = "shaft", spindle_rpm = 500, feed_mm_rev = 0.2 }'
PART = '{ cycle = "turn_part", tool = 2, z_mm = -45, spindle_rpm = 500, feed_mm_rev = 0.1 }'


def test_a_lathe_s_job_gives_stock_tool_and_profile(tmp_path: Path) -> None:
    """The mini-lathe's signs: X from where the tool is set, Z away from the chuck, both incremental here."""
    job, program = tmp_path / "job.toml", tmp_path / "p.txt"
    job.write_text(JOB.format(operations=FINISH))
    words = ("G00 X-7.5", "G01 Z46. F2.", "X4.", "G00 Z-46.", "M02")
    program.write_text("".join(f"N{10 * number} {block} # " for number, block in enumerate(words, 1)) + "?\n")
    ended = called("simulate", program, "--job", job, "-o", tmp_path / "a.png", "--read-at", "-20")
    assert "Z-20: diameter 50.0000 mm" in ended.stdout, ended.stdout + ended.stderr
    assert "X is a radius" in ended.stdout
    assert "[gouge]" not in ended.stdout


def test_each_program_of_a_lathe_s_job_is_checked_behind_those_before_it(tmp_path: Path) -> None:
    """A program is found among those of its job by its moves; one that is none of them needs --part."""
    job, out = tmp_path / "job.toml", tmp_path / "out"
    job.write_text(JOB.format(operations=f"{FINISH}, {PART}"))
    assert called("run", job, "--out", out).returncode == 0
    report = tmp_path / "report.json"
    for program in ("program-1-T1.nc", "program-2-T2.nc"):
        ended = called("check", out / program, "--job", job, "--machine", "mini-lathe", "--json", report)
        assert ended.returncode == 0 and "clean" in ended.stdout, ended.stdout + ended.stderr
    assert json.loads(report.read_text("utf-8"))["profile"] == json.loads((out / "report.json").read_text())["profile"]
    other = out / "program-2-T2.nc"
    other.write_text(other.read_text().replace("X-32.5", "X-32.4"))
    ended = called("check", other, "--job", job, "--machine", "mini-lathe")
    assert "[turning-part]" in ended.stderr and "1 = tool 1, 2 = tool 2" in ended.stderr
    ended = called("check", other, "--job", job, "--machine", "mini-lathe", "--part", 2)
    assert ended.returncode == 0 and "clean" in ended.stdout, ended.stdout + ended.stderr
    refused = called("check", other, "--job", job, "--machine", "mini-lathe", "--part", 3)
    assert "[turning-part]" in refused.stderr


def test_the_programs_of_a_lathe_s_job_are_sent_one_after_the_other(tmp_path: Path) -> None:
    """With the job alone: each is proven behind those before it, and the lathe is switched off and on between them."""
    job, out = tmp_path / "job.toml", tmp_path / "out"
    fast = [words.replace("feed_mm_rev = 0.2", "feed_mm_rev = 2").replace("0.1", "2") for words in (FINISH, PART)]
    job.write_text(JOB.format(operations=", ".join(fast)).replace("-40", "-10").replace("-45", "-15"))
    assert called("run", job, "--out", out).returncode == 0
    for program in ("program-1-T1.nc", "program-2-T2.nc"):
        trace = tmp_path / f"{program}.csv"
        virtual = ("virtual", "lathe", "--tcp", "127.0.0.1:0", "--until-left", "--trace", trace)
        with subprocess.Popen(
            command(*virtual), stdout=subprocess.PIPE, text=True, preexec_fn=forked(*virtual)
        ) as lathe:
            port = lathe.stdout.readline().split()[-1]
            ended = called("send", out / program, "--job", job, "--port", port, "--zero-confirmed", "--keep-open", "0")
            assert ended.returncode == 0, ended.stdout + ended.stderr
            lathe.wait(60)
        steps = np.rint(80 * np.abs(np.diff(np.loadtxt(trace, delimiter=",", skiprows=1)[:, 1:], axis=0))).sum(axis=0)
        ends = interpret((out / program).read_text(), None, "mini-lathe").table().end[:, [0, 2]]
        assert steps.tolist() == np.abs(np.diff(np.rint(80 * ends), axis=0, prepend=[[0, 0]])).sum(axis=0).tolist()
    bad = out / program
    bad.write_text(bad.read_text().replace("X-32.5", "X-32.4"))
    ended = called("send", bad, "--job", job, "--port", "/dev/null", "--zero-confirmed")
    assert ended.returncode == 1 and "[turning-part]" in ended.stderr
