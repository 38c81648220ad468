# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each dialect reads the programs of its source, writes one job in its own way, and refuses what it does not mean."""

from __future__ import annotations

import csv
import re
from math import pi
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.conversion.convert import convert
from CNCStepper.gcode.dialects import dialect, dialect_names
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.writer.write import WriteOptions, write_split, written
from CNCStepper.machine.profile import load_machine
from CNCStepper.state import Start
from CNCStepper.toolpath import LINE, TableBuilder, Toolpath
from helpers.gcode.dialect_jobs import one_job
from helpers.gcode.thesis_programs import PART_1
from helpers.gcode.writer_toolpaths import row_points

ZERO = Start.at_zero()
ROOT = Path(__file__).parents[4]
LEFT_OUT = ("spindle", "coolant", "dwell", "pause", "tool")


def lengths(path: Toolpath) -> tuple[float, float]:
    """Return the length of the lines and that of the arcs, mm."""
    table, sums = path.table(), [0.0, 0.0]
    for row, points in enumerate(row_points(path, 2001)):
        sums[int(table.turns[row] > 0)] += float(np.linalg.norm(np.diff(points[:, :2], axis=0), axis=1).sum())
    return sums[0], sums[1]


# A: the control unit for stepper tables


@pytest.mark.parametrize("number", PART_1)
def test_the_first_test_part_of_thesis_a(number):
    """Four quarter circles, two of radius 80 and two of 160, and four lines of 80 on the axes; 1 and 4 begin at 80."""
    path = interpret(PART_1[number], Start(), "thesis-a")
    straight, round_ = lengths(path)
    assert round_ == pytest.approx(2 * (80 + 160) * pi / 2, abs=0.01)
    assert straight == pytest.approx(80 + 4 * 80 if number in (1, 4) else 160 + 3 * 80)
    ends = path.table().end[:, :2]
    assert {*np.hypot(*ends.T).round(9)} == {80.0, 160.0}
    assert ends[-1].tolist() == [0, -80]


@pytest.mark.parametrize("number", PART_1)
def test_the_parts_of_thesis_a_are_written_in_its_language_again(number):
    path = interpret(PART_1[number], Start(), "thesis-a")
    made = written(path, "thesis-a", WriteOptions(retract=False))
    assert not made.notes
    again = interpret(made.text, Start(), "thesis-a")
    assert np.array_equal(again.table().end, path.table().end)
    assert np.array_equal(again.table().centre, path.table().centre)
    assert "F" not in made.text  # the language has no word for the machine's own speed
    assert re.search(r"^G[23] .* I0 J0$", made.text, re.MULTILINE)


# B: the mini-lathe


def test_the_example_records_of_the_mini_lathe():
    path = interpret("N30 G00 X-10. # N40 Z-50. # N50 X5000 Z50. #", ZERO, "mini-lathe")
    assert path.table().end.tolist() == [[-10, 0, 0], [-10, 0, -50], [-9.5, 0, 0]]
    path = interpret("N30 G01X-10. F1. # N40 Z-50. # N50 X5000 Z50. F2500 #", ZERO, "mini-lathe")
    assert path.table().end[-1].tolist() == [-9.5, 0, 0]
    assert path.table().feed.tolist() == [60, 60, 15]  # 1 mm/s and 0.25 mm/s
    assert set(path.table().kind.tolist()) == {LINE}


@pytest.mark.parametrize(
    ("text", "name", "end"),
    [
        ("G71 # G00 X1. # M02 # ?", "mini-lathe", 25.4),
        ("G70 # G00 X1. # M02 # ?", "mini-lathe", 1.0),
        ("G70 # G00 X1. # M02 # ?", "mini-lathe:g70=inch", 25.4),
        ("G71 # G00 X10000 #", "mini-lathe:g70=inch", 1.0),
        ("G00 X10.5 #", "mini-lathe", 10.5),
        ("G21 # G00 X10. #", "mini-lathe", 5.0),
        ("G20 # G00 X10. #", "mini-lathe", 10.0),
        ("G20 # G00 X10. #", "mini-lathe:g20=diameter", 5.0),
        ("G21 # G70 # G00 X10. #", "mini-lathe:g20=diameter,g70=inch", 254.0),
        ("/ G00 X10. # G00 X2. # ; a comment # X1. #", "mini-lathe", 3.0),
    ],
)
def test_units_comments_and_skipped_records_of_the_mini_lathe(text, name, end):
    assert interpret(text, ZERO, name).table().end[-1, 0] == end


def test_an_absent_axis_stays_in_absolute_mode_and_is_told():
    path = interpret("G90 # G00 X20. Z30. # X10. # Z5. X10. #", ZERO, "mini-lathe")
    assert path.table().end.tolist() == [[20, 0, 30], [10, 0, 30], [10, 0, 5]]
    assert [(event.kind, event.index) for event in path.events] == [("warning", 2)]
    made = convert("G90 # G00 X20. Z30. # X10. #", "mini-lathe", "linuxcnc", ZERO)
    assert [str(note) for note in made.notes] == [path.events[0].text + " (line 1)"]
    wire = prepare("G90 # G00 X20. Z30. #\nX10. #", "mini-lathe")
    assert wire.lines == ("G90#G00X20.Z30.#", "G00X10.Z30.#")
    with pytest.raises(ProgramError, match="drives an axis without a word to 0"):
        prepare("G90 # G00 X20. #", "mini-lathe")


def test_the_wire_of_the_mini_lathe_may_be_cut_after_every_record():
    text = "N10 G01 X-10. F1. # N20 Z-5. # ; note #\nN30 X5000 #\nM02 #\n?\n"
    wire = prepare(text, "mini-lathe")
    assert wire.lines == ("G01X-10.F1.#G01Z-5.F1.#", "G01X5000F1.#", "M02#")
    assert interpret(wire.text, ZERO, "mini-lathe").table().end.tolist() == [[-10, 0, 0], [-10, 0, -5], [-9.5, 0, -5]]


@pytest.mark.parametrize(("feed", "written"), [("10", "F0.1667"), ("0.1181", ""), ("0.06", "F0.0010"), ("0.0001", "")])
def test_a_feed_that_the_digits_of_the_mini_lathe_cannot_hold_is_refused(feed: str, written: str) -> None:
    text = f"G20 G90 G18\nG1 X1 Z0 F{feed}\nM2\n"
    if written:
        assert written.rstrip("0") in convert(text, "linuxcnc", "mini-lathe", ZERO).text
        return
    with pytest.raises(ProgramError) as refused:
        convert(text, "linuxcnc", "mini-lathe", ZERO, "a.ngc")
    assert refused.value.code in ("feed-digits", "no-feed") and refused.value.place.line == 2


# C: fixed cycles and freehand lines on an ISO control


def freehand_map() -> Toolpath:
    """Return the map of examples/: the first point positions the tool, each later one ends a linear block."""
    with (ROOT / "examples" / "brazil-outline.csv").open(encoding="utf-8") as file:
        points = [(float(x), float(y)) for x, y in csv.reader(line for line in file if line[0] not in "#x")]
    table = TableBuilder(Start())
    table.rapid((*points[0], 5))
    table.feed((*points[0], -0.5), 100)
    for point in points[1:]:
        table.feed((*point, -0.5), 400)
    return table.toolpath()


def test_the_freehand_map_is_an_iso_program():
    made = written(freehand_map(), "iso", WriteOptions(retract=False))
    lines = made.text.splitlines()
    assert lines[:2] == ["%", "N10 G71 G17 G90"] and lines[-1] == "%" and lines[-2].endswith(" M02")
    blocks = [line for line in lines if re.match(r"N\d+ X", line)]
    assert len(blocks) == len(freehand_map()) - 2 >= 200
    numbers = [int(line[1:].split()[0]) for line in lines if line.startswith("N")]
    assert numbers == list(range(10, 10 * len(numbers) + 1, 10))
    assert np.array_equal(interpret(made.text, Start(), "iso").table().end, freehand_map().table().end)


def test_an_iso_program_may_be_named_and_counts_on_after_the_largest_number():
    for name in ("%1234", "%\nO1234", "%\n:1234", "O1234"):
        assert len(interpret(f"{name}\nN10 G71 G90\nN20 G0 X5. Y1.\nN30 G04 X0.5\nN40 M02\n%\n", ZERO, "iso")) == 1
    table = TableBuilder(Start())
    for x in range(1100):
        table.feed((x, 0, 0), 100)
    lines = written(table.toolpath(), "iso", WriteOptions(retract=False)).text.splitlines()
    numbers = [int(line[1:].split()[0]) for line in lines if line.startswith("N")]
    assert max(numbers) == 9990 and numbers.count(10) == 2


@pytest.mark.parametrize("word", ["X", "U", "F"])
def test_an_iso_dwell_is_in_seconds(word):
    path = interpret(f"N10 G04 {word}2.5", ZERO, "iso")
    assert [(event.kind, event.value) for event in path.events] == [("dwell", 2.5)] and len(path) == 0


# dwells, messages and checksums elsewhere


@pytest.mark.parametrize(
    ("text", "name", "seconds"),
    [
        ("G4 P2", "grbl", 2.0),
        ("G4 P2", "mach", 2.0),
        ("G4 P2000", "mach:dwell=ms", 2.0),
        ("G4 P2000", "marlin", 2.0),
        ("G4 S2", "marlin", 2.0),
        ("G4 P500 S2", "marlin", 2.0),
    ],
)
def test_what_p_means_after_g4(text, name, seconds):
    assert [event.value for event in interpret(text, ZERO, name).events] == [seconds]


def test_a_program_as_marlin_takes_it():
    text = "G21 ; units\nN1 G90*30\nM117 Hello (you)\nG0 X5 F3000\nG1 X10 F600\nM0 Click to go on\nG4 S1\n"
    checksum = 0
    for byte in b"N1 G90":
        checksum ^= byte
    path = interpret(text.replace("*30", f"*{checksum}"), ZERO, "marlin")
    assert path.table().feed.tolist() == [0, 600]
    told = [(event.kind, event.text) for event in path.events if event.kind in ("message", "pause")]
    assert told == [("message", "Hello [you]"), ("pause", "Click to go on")]
    with pytest.raises(ProgramError, match=f"should be \\*{checksum}"):
        interpret("N1 G90*31", ZERO, "marlin")


def test_marlin_gets_one_command_a_line_and_the_feed_of_its_rapids():
    made = written(one_job(), "marlin", WriteOptions(tool_change="pause", rapid_mm_min=3000, retract=False))
    for line in made.text.splitlines():
        assert line[0] in "GM;"
        assert len(re.findall(r"[GMT]\d", line.partition(";")[0])) == (line[0] != ";")
    assert not re.search(r"G1[789]|G91|G28|M2\b|M30|T\d", made.text)
    feed = 0.0
    for line in made.text.splitlines():
        feed = float(found[1]) if (found := re.search(r"F([\d.]+)", line.partition(";")[0])) else feed
        assert not line.startswith("G0") or feed == 3000
        assert not line.startswith("G1") or feed != 3000


# writing


@pytest.mark.parametrize("name", [name for name in dialect_names() if name != "qtplasmac"])  # it mills nothing
def test_golden_programs_of_one_job(name, golden):
    one = dialect(name)
    job = one_job(is_lathe=name == "mini-lathe" or one.is_lathe)
    options = WriteOptions(title="One job", spin_up_s=2, tools={1: "flat 6 mm", 2: "drill 3 mm"}, leave_out=LEFT_OUT)
    changes = one.writing.tool_change
    if "pause" in changes:
        options = WriteOptions(**{**options.__dict__, "tool_change": "m6" if "m6" in changes else "pause"})
        texts = [written(job, name, options).text]
    else:
        texts = [
            text for _, text in write_split(job, name, WriteOptions(**{**options.__dict__, "tool_change": "split"}))
        ]
    golden(f"gcode/job.{name}.nc", "\n".join(texts))
    for text in texts:
        assert text.isascii() and all(len(line) < (one.line_limit or 200) for line in text.splitlines())
        interpret(text, Start(), name)


def test_every_dialect_is_a_machine_s_controller(tmp_path):
    profile = (ROOT / "examples" / "machines" / "table-a.toml").read_text("utf-8")
    for name in (*dialect_names(), "mach:dwell=ms", "mini-lathe:g20=diameter,g70=inch"):
        path = tmp_path / "machine.toml"
        path.write_text(re.sub(r'controller = "\w+"', f'controller = "{name}"', profile), "utf-8")
        assert dialect(load_machine(path).controller).name == name


def test_a_setting_that_a_dialect_lacks_is_refused():
    for name in ("mach:dwell=h", "grbl:dwell=ms", "mini-lathe:g70", "nothing"):
        with pytest.raises(ProgramError) as caught:
            dialect(name)
        assert caught.value.code == "unknown-dialect" and "use one of" in str(caught.value)


# from one dialect to another

PROGRAM = """%
(a part)
G20 G90 G17
T1 M6
M3 S1000
G0 X0 Y0 Z1
G98 G81 X.1 Y.2 Z-.1 R.1 F10
X.5
G80
G1 X1 Y0
G92 X0
G1 X.5
G92.1
G91 G1 X.25
G90
G3 X1.75 Y1 Z.5 I0 J.5 P2
G4 P1.5
M2
%
"""
LATHES = ("mini-lathe", "fanuc-lathe", "mach-turn")
NAMES = [name for name in dialect_names() if name not in (*LATHES, "linuxcnc", "qtplasmac")]


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_a_converted_program_makes_the_same_moves(name):
    made = convert(PROGRAM, "linuxcnc", name, ZERO, leave_out=LEFT_OUT)
    path, again = interpret(PROGRAM, ZERO, "linuxcnc"), interpret(made.text, ZERO, name)
    one, other = (np.vstack(row_points(each, 400)) for each in (path, again))
    slack = 25.4e-4 * 2 + 0.15  # two digits and the step between points
    assert max(np.linalg.norm(other - point, axis=1).min() for point in one[::7]) < slack
    assert max(np.linalg.norm(one - point, axis=1).min() for point in other[::7]) < slack
    notes = [note.what for note in made.notes]
    assert "the shift of G92 went into the coordinates" in notes
    assert "incremental coordinates became absolute" in notes
    assert ("G81 became plain moves" in notes) == (not dialect(name).writing.canned)


COMPENSATED = """G21 G90 G17 G40
T1 M6
M3 S1000
G0 X-10 Y-10 Z5
G1 Z-1 F100
G41.1 D4
G1 X0 Y0 F300
Y20
X30
Y0
X0
G40 G1 X-10 Y-10
G0 Z5
M2
"""


@pytest.mark.parametrize("name", ["grbl", "marlin", "iso", "thesis-a"])
def test_cutter_compensation_becomes_the_path_of_the_centre(name):
    made = convert(COMPENSATED, "linuxcnc", name, ZERO, leave_out=LEFT_OUT)
    assert "G41" not in made.text
    ends = interpret(made.text, ZERO, name).table().end[:, :2].round(3).tolist()
    assert [-2.0, 20.0] in ends or [-2.0, 22.0] in ends  # the tool's centre is its radius left of the line
    assert np.array_equal(ends[-1], [-10, -10])


def test_subroutines_and_expressions_are_written_out():
    text = "o1 sub\nG1 X[#1 * 2] F100\nG1 X0\no1 endsub\nG21 G90\no2 repeat [3]\no1 call [2.5]\no2 endrepeat\nM2\n"
    made = convert(text, "linuxcnc", "grbl", ZERO)
    assert made.text.count("X5.000") == 3
    assert "subroutines and loops were written out" in [note.what for note in made.notes]


def test_a_thread_is_refused_where_the_spindle_cannot_drive_it():
    text = "G21 G90 G18 G7\nM3 S500\nG0 X10 Z5\nG33 Z-10 K1.5\nM2"
    with pytest.raises(ProgramError, match=r"grbl 1\.1 programs are written without 'G33'.*whose controller has G33"):
        convert(text, "linuxcnc", "grbl", ZERO)


def test_what_the_other_machine_cannot_do_is_refused_unless_it_may_be_left_out():
    with pytest.raises(ProgramError, match="thesis A has no words for the spindle"):
        convert(PROGRAM, "linuxcnc", "thesis-a", ZERO)
    with pytest.raises(ProgramError, match="mini-lathe B has no axis Y"):
        convert(PROGRAM, "linuxcnc", "mini-lathe", ZERO, leave_out=LEFT_OUT)
    made = convert("G18 G21 G90\nG0 X1 Z2\nG1 X3 Z4 F60\nM2", "linuxcnc", "mini-lathe", Start())
    assert made.text.splitlines()[3:5] == ["N40 G00 X1.0000 Z2.0000 #", "N50 G01 X3.0000 Z4.0000 F1. #"]


@pytest.mark.parametrize("name", ["grbl", "linuxcnc", "marlin", "iso"])
@pytest.mark.parametrize("way", ["none", "touch_off"])
def test_the_lengths_of_tools_are_kept_by_words_or_in_the_coordinates(name, way):
    """What the machine's Z does is the same, unless the operator zeroes each tool."""
    text = "G21 G90\nT1 M6\nG43 H1\nM3 S100\nG0 X0 Y0 Z5\nG1 Z-1 F100\nM2\n"
    start = Start(position_mm=(0, 0, 0), zero_known=True, tool_lengths_mm={1: 41.5})
    made = convert(text, "linuxcnc", name, start, tool_length=way, leave_out=LEFT_OUT, tool_lengths_mm={1: 41.5})
    again = interpret(made.text, start, name)
    length = 41.5 if way == "none" else 0.0
    assert again.table().end[-1, 2] == -1 + length
    words = {"grbl": "G43.1 Z41.500", "linuxcnc": "G43 H1", "iso": "G43 H1", "marlin": "Z40.500"}
    assert (words[name] in made.text) == (way == "none")
