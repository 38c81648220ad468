# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program that is proven piece by piece has the findings, the report and the certificate of the whole text."""

from __future__ import annotations

import re
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.control.program.certificate import Certificate
from CNCStepper.errors import JobError, ProgramError
from CNCStepper.gcode.interpreter import program_file
from CNCStepper.gcode.interpreter.fast_path import compiled_reader  # noqa: F401  before CHUNK_ROWS is set
from CNCStepper.job import prove_file as prove_file_module
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.job.prove import prove
from CNCStepper.job.prove_file import prove_file
from CNCStepper.machine.profile import Motor
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.checks import load_checks
from CNCStepper.simulation.removal import engagement
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start
from helpers.job.prove_runs import (  # noqa: F401  pieces is a fixture
    CORED,
    FLAT,
    STOCK,
    TABLE,
    assert_same,
    both,
    machine_with,
    pieces,
)
from helpers.simulation.seeded_programs import clean_program, faults_of

FAULTY = (  # each line of it is there for a check that looks beyond one row
    "%\n(operation: first)\nX1 Y1\nG21 G90 G17 T1\nG1 Z-1 F300\n(MSG, look)\nG0 Z5\nM3 S10000\n(still waiting)\nG4 P1\n"
    "G4 P0.5\n"
    "G1 X2 Z-1\nX9\nG2 X12 Y4 I3 J0\nM8\nG64 P0.05\nG1 X13\nX14\nX14 Y9\nG64\nX15\nX16\nG61\n"
    "(operation: second)\nG0 X20\n"
    "G0 Z-2\nM5\nX25\nG1 X26\nX27\nM3 S10000\nM0\nX30 F9000\nX31\nM5\nG0 Z9\nT2\nG0 X5\nM3 S24000\nG1 Z-25 F100\nX200\n"
    "Y-190\nG55 G0 Z9\nG92 X5\nG1 X6 Z-3\nG10 L2 P1 X3\nX0\n(MSG, end)\nM5\nM2\n%\nG1 X1000\n"
)


@pytest.mark.parametrize("dialect", ["grbl", "grblhal", "linuxcnc"])
@pytest.mark.parametrize("stock", [None, STOCK], ids=["no-stock", "stock"])
@pytest.mark.parametrize("start", [None, Start.with_work_zero((-200.0, -200.0, -40.0))], ids=["unknown", "zero"])
@pytest.mark.usefixtures("pieces")
def test_all_that_checks_find_beyond_a_row(
    tmp_path: Path, dialect: str, stock: Stock | None, start: Start | None
) -> None:
    tools = CORED if stock else None
    machine = machine_with(controller=dialect)
    text = FAULTY.replace("\nX1 Y1", "\nG0 X1 Y1") if dialect == "linuxcnc" else re.sub("G6[14].*\n", "", FAULTY)
    whole, parts = both(tmp_path, text, machine, dialect, stock=stock, tools=tools, start=start)
    assert_same(whole, parts)
    codes = {finding.code for finding in whole.findings}
    wanted = {"spin-up", "pause-spindle", "height-unknown", "feed-above-rate"}
    wanted |= {"corners-cut"} if dialect == "linuxcnc" else set()
    wanted |= {"spindle-off", "rapid-in-stock", "below-stock", "plunge"} if stock else set()
    wanted |= {"travel"} if start else {"place-unknown"}
    assert wanted <= codes, wanted - codes


@pytest.mark.slow
@pytest.mark.usefixtures("pieces")
def test_play_is_taken_up_line_by_line(tmp_path: Path) -> None:
    machine = machine_with(backlash_mm=0.05)
    text = "G21 G90\n(operation: a)\nG0 Z5\nG0 X0 Y0\nM3 S9000\nG4 P3\n(MSG, go)\nG1 Z-1 F200\n" + "".join(
        f"X{10 + index % 3} Y{index % 5}\n(comment {index})\n" for index in range(40)
    )
    whole, parts = both(tmp_path, text + "G2 X20 Y4 I5 J0\nG0 Z5\nM2\n", machine, stock=STOCK, tools=FLAT)
    assert len(whole.wire.lines) > 60, "play is taken up in lines of its own"
    assert_same(whole, parts)


@pytest.mark.slow
@pytest.mark.usefixtures("pieces")
def test_the_torque_of_motors_and_beams_that_are_never_on(tmp_path: Path) -> None:
    load = {"travel_per_turn_mm": 10.0, "mass_kg": 8.0, "inertia_kg_m2": 5e-5, "force_n": 40.0, "efficiency": 0.8}
    machine = machine_with(motor=Motor(**load, torque=((0, 0.1), (300, 0.08), (600, 0.0))))
    beam = Tool(number=1, shape="jet", diameter_mm=1)
    text = "G21 G90\nG0 Z5\n" + "".join(f"G1 X{index % 7} Y{index % 3} F1500\n" for index in range(60)) + "M2\n"
    whole, parts = both(tmp_path, text, machine, stock=STOCK, tools=beam)
    assert {"spindle-off", "motor-torque"} <= {finding.code for finding in whole.findings}
    assert_same(whole, parts)
    assert_same(*both(tmp_path, text.replace("X3", "M3 S900 X3"), machine, stock=STOCK, tools=beam))


LIMITED = {
    "flutes": 2,
    "flute_length_mm": 3.0,
    "length_mm": 6.0,
    "holder_diameter_mm": 20.0,
    "engagement_max_deg": 120.0,
    "chip_load_max_mm": 0.004,
    "chip_load_min_mm": 0.002,
}
LOADED = (  # loads rise and fall, tools change and come back, the path breaks off, goes straight down, round and far
    "G21 G90 G17 T1\nG0 X-40 Y0 Z5\nM3 S10000\nG4 P3\nG1 Z-2 F300\nX-10\nX-12 Y2\nZ-4\nX0 F90\nG0 Z-5\nG0 Z5\n"
    "T2\nG0 X-20 Y-10\nG1 Z-2.5 F20\nX20 F900\nG2 X20 Y-10 I0 J5\nG1 X21\nX20.9\nX20.8\nZ-2.6\nX19\nG0 Z5\nX300\n"
    "X0\nT1\nG0 X10 Y10\nG1 Z-8 F200\nX20\nG3 X20 Y10 I-4 J0\nG1 Y-20 Z-9 F2000\nG0 Z5\nT3\nG0 X0 Y15\nG1 Z-1 F100\n"
    "X9\nG0 Z5\nT2\nG0 X-25 Y-20\nG1 Z-2.8 F500\nX25\nY-19.9\nX-25\nG0 Z9\nM5\nM2\n"
)


@pytest.mark.slow
@pytest.mark.parametrize("small", [False, True], ids=["all-at-once", "few-at-once"])
@pytest.mark.usefixtures("pieces")
def test_tools_that_say_what_they_may_meet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, small: bool) -> None:
    first = Tool(number=1, shape="flat", diameter_mm=6, **LIMITED)
    second = Tool(number=2, shape="ball", diameter_mm=4, **LIMITED | {"flute_length_mm": 2.55, "length_mm": 20.0})
    third = Tool(number=3, shape="flat", diameter_mm=3)
    tools = {tool.number: tool for tool in (first, second, third)}
    file = tmp_path / "whole.nc"
    file.write_text(LOADED, encoding="ascii")
    whole = prove(LOADED, TABLE, file=str(file), dialect="grbl", stock=STOCK, tools=tools)
    if small:
        monkeypatch.setattr(load_checks, "BLOCK", 3)
        monkeypatch.setattr(engagement, "MOST_PLACES", 7)
    parts = prove_file(file, TABLE, dialect="grbl", stock=STOCK, tools=tools, sent=tmp_path)
    assert_same(whole, parts)
    found = Counter(finding.code for finding in whole.findings)
    assert found["flute-length"] == found["engagement"] == 2 and found["holder"] == 1, found
    assert any("too thick" in finding.text for finding in whole.findings)
    assert_same(*both(tmp_path, LOADED, TABLE, stock=STOCK, tools=first))


@pytest.mark.slow
@pytest.mark.usefixtures("pieces")
def test_programs_with_planted_faults(tmp_path: Path) -> None:
    found: Counter[str] = Counter()
    for seed in range(3):
        clean = clean_program(seed)
        for program in (clean, *(fault.program for fault in faults_of(clean, seed))):
            more = {"stock": program.stock, "tools": program.tools, "start": program.start}
            whole, parts = both(tmp_path, program.text, TABLE, **more)
            assert_same(whole, parts)
            found.update(finding.code for finding in whole.findings)
    assert found["rapid-in-stock"] and found["spindle-off"] and found["plunge"] and found["travel"], found


@pytest.mark.usefixtures("pieces")
@pytest.mark.parametrize("line", ["G1 X5 Q7", "G999", "G1 X1 ! Y2", "X" + "1" * 90])
def test_a_refused_line_is_named_as_in_the_whole_text(tmp_path: Path, line: str) -> None:
    file = tmp_path / "p.nc"
    file.write_text("G21 G90\r\nG0 X1 (here)\r\n" * 30 + f"  {line}\r\nG0 X2\r\n", encoding="latin-1", newline="")
    with pytest.raises(ProgramError) as whole:
        prove(file.read_text("latin-1"), TABLE, file=str(file))
    with pytest.raises(ProgramError) as parts:
        prove_file(file, TABLE)
    assert str(parts.value) == str(whole.value)


@pytest.mark.parametrize("when", ["while it is read", "before its fingerprint is taken"])
def test_a_file_that_is_written_while_it_is_proven_gets_no_certificate(tmp_path: Path, when: str) -> None:
    file, other = tmp_path / "peça.nc", tmp_path / "other.nc"
    file.write_text("G21 G90\nG0 Z0\nG0 X0 Y0\nG1 X-10 F500\nM2\n", "ascii")
    other.write_text(file.read_text("ascii").replace("X-10", "X-30"), "ascii")
    saved = {"while it is read": lambda share: other.exists() and other.replace(file)}.get(when, lambda share: None)
    with pytest.raises(JobError) as refused:
        proof = prove_file(file, TABLE, sent=tmp_path, share=saved)
        other.replace(file)
        certificate_of(proof)
    assert refused.value.code == "file-changed"


def test_a_certificate_of_a_file_is_read_back(tmp_path: Path) -> None:
    _, parts = both(tmp_path, "G21 G90\nG0 Z5\nG1 X1 F100\nM2\n", TABLE)
    file = tmp_path / "certificate.zip"
    certificate_of(parts).write(file)
    assert list(Certificate.read(file).send_job().lines) == ["G21G90", "G0Z5", "G1X1F100", "M2"]
    assert list(Certificate.read(file).file_lines) == [1, 2, 3, 4]


RASTER = "G21 G90\nG0 X0 Y0\nM4 S0\nG1 F3000\n", "G1 X{x} Y{y} S{s}\n", "M5\nM2\n"
HOLES = "G21 G90\nM3 S9000\nG0 Z5\nG99 G81 X0 Y0 Z-1 R1 F300\n", "X{x} Y{y}\n", "G80\nM5\nM2\n"


@pytest.mark.slow
@pytest.mark.parametrize(("text", "dialect"), [(RASTER, "grbl"), (HOLES, "linuxcnc")], ids=["raster", "holes"])
def test_three_times_the_lines_hold_no_more(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: tuple[str, str, str], dialect: str
) -> None:
    rows = 100
    monkeypatch.setattr("CNCStepper.toolpath.CHUNK_ROWS", rows)
    monkeypatch.setattr("CNCStepper.state.PIECE", rows)
    monkeypatch.setattr(prove_file_module, "PART_ROWS", 2 * rows)
    monkeypatch.setattr(program_file, "PIECE", 4000)
    held: list[int] = []
    see = prove_file_module._FileProof._see

    def seen(self: Any, group: Any, is_last: bool) -> None:
        see(self, group, is_last)
        table = self._wire.table
        held.append(sum(map(len, table.states._pieces)) + len(table.spans) + len(table.events))

    monkeypatch.setattr(prove_file_module._FileProof, "_see", seen)
    most = []
    for lines in (3000, 9000):
        held.clear()
        file = tmp_path / f"{lines}.nc"
        body = (text[1].format(x=n % 97 * 0.2, y=n // 97 * 0.1, s=n) for n in range(lines))
        file.write_text(text[0] + "".join(body) + text[2], "ascii")
        assert prove_file(file, TABLE, dialect=dialect).report["blocks"] >= lines
        most.append(max(held))
    assert most[1] <= 1.2 * most[0] < 2000, most


PEAK = """
import resource, subprocess, sys
words = ["-m", "CNCStepper.cli", "check", sys.argv[1], "--machine", "table-a"]
subprocess.run([sys.executable, *words, "--stock", "120,120,20", "--tool", "flat:6"], check=True)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024)
"""  # a process begins with the peak of the one that started it: a small one stands between


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no getrusage")
def test_memory_does_not_grow_with_the_program(tmp_path: Path) -> None:
    """Twice the lines, twice the table; what is held grows by far less, and 600 MB are never reached."""
    peaks_mb = []
    for rows in (500_000, 1_500_000):
        file = tmp_path / f"{rows}.nc"
        with file.open("w", encoding="ascii") as stream:
            stream.write("G21 G90\nG0 Z5\nG0 X0 Y0\nM3 S9000\nG4 P3\nG1 Z-1 F600\n")
            stream.writelines(f"X{index % 97 * 0.5:.3f} Y{index % 89 * 0.5:.3f}\n" for index in range(rows))
            stream.write("G0 Z5\nM2\n")
        output = subprocess.run([sys.executable, "-c", PEAK, str(file)], capture_output=True, text=True, check=True)
        peaks_mb.append(int(output.stdout.splitlines()[-1]))
    print(f"peaks {peaks_mb} MB")
    assert max(peaks_mb) < 600 and peaks_mb[1] - peaks_mb[0] < 60
