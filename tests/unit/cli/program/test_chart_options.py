# SPDX-License-Identifier: LGPL-2.1-or-later
"""`check`, `time` and `send` of a program without F: by material and thickness, by the profile, or refused."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from CNCStepper.control.program.certificate import Certificate
from CNCStepper.machine.cut_charts import cut_data_for
from helpers.cli.command_line import called, command, forked

PROGRAM = "G21 G90\nG0 X10 Y10\nM3 S1000\nG4 P0.3\nG1 X110\nY60\nM5\nG0 X0 Y0\nM2\n"
STEEL = ("--material", "mild-steel", "--thickness", "3")
CHART = """
[[cut]]
process = "oxyfuel"
material = "mild-steel"
thickness_mm = 3
feed_mm_min = 600
kerf_mm = 1
"""


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "part.nc"
    path.write_text(PROGRAM, encoding="ascii")
    return path


def steel_feed_mm_min() -> float:
    return cut_data_for("plasma", "mild-steel", 3.0).feed_mm_min


def seconds(printed: str) -> float:
    return float(printed.splitlines()[-1])


def test_without_a_feed_it_is_refused(program: Path) -> None:
    for verb in ("check", "time"):
        done = called(verb, program, "--machine", "torch-table")
        assert done.returncode != 0
        assert "no feed" in done.stdout + done.stderr


def test_time_takes_the_charts_feed_and_tells_it(program: Path, tmp_path: Path) -> None:
    done = called("time", program, "--machine", "torch-table", *STEEL)
    assert done.returncode == 0, done.stderr
    feed = steel_feed_mm_min()
    assert f"takes {feed:g} mm/min (plasma, mild-steel 3 mm" in done.stdout
    spelled = tmp_path / "spelled.nc"
    spelled.write_text(PROGRAM.replace("G1 X110", f"G1 X110 F{feed:g}"), encoding="ascii")
    same = called("time", spelled, "--machine", "torch-table")
    assert seconds(done.stdout) == pytest.approx(seconds(same.stdout), abs=1e-6)


@pytest.mark.parametrize("verb", ["check", "send"])
def test_a_file_for_linuxcnc_is_refused_with_the_f_that_it_needs(verb: str, program: Path, tmp_path: Path) -> None:
    """LinuxCNC reads the file itself: without an F in it, it would cut with the feed of the program before."""
    from CNCStepper.machine.profile import load_machine

    content = load_machine("torch-table").model_dump(mode="json") | {"controller": "linuxcnc"}
    profile = tmp_path / "linuxcnc.json"
    profile.write_text(json.dumps(content), encoding="utf-8")
    port = ("--port", "socket://127.0.0.1:9", "--zero-confirmed") if verb == "send" else ()
    done = called(verb, program, "--machine", profile, *STEEL, *port)
    assert done.returncode != 0
    told = " ".join((done.stdout + done.stderr).split())
    if verb == "send":
        assert "--to grbl" in told  # no lines are sent in that language; converted, it names the feed
        return
    assert f"write F{steel_feed_mm_min():g} into the file" in told, told
    assert "part.nc:5" in told


def test_process_consumable_and_chart_choose_the_row(program: Path, tmp_path: Path) -> None:
    chart = tmp_path / "own.toml"
    chart.write_text(CHART, encoding="ascii")
    own = called("time", program, "--machine", "torch-table", *STEEL, "--process", "oxyfuel", "--chart", chart)
    assert "takes 600 mm/min (oxyfuel" in own.stdout
    other = called("time", program, "--machine", "torch-table", *STEEL, "--consumable", "85A")
    assert f"takes {cut_data_for('plasma', 'mild-steel', 3.0, '85A').feed_mm_min:g} mm/min" in other.stdout


def test_the_profile_says_what_a_program_without_f_takes(program: Path, tmp_path: Path) -> None:
    from CNCStepper.machine.profile import load_machine

    content = load_machine("torch-table").model_dump(mode="json") | {"feed_mm_min": 1000}
    profile = tmp_path / "own.json"
    profile.write_text(json.dumps(content), encoding="utf-8")
    slow = called("time", program, "--machine", profile)
    fast = called("time", program, "--machine", profile, *STEEL)
    assert seconds(slow.stdout) > 9.0 > seconds(fast.stdout)


@pytest.mark.parametrize(
    ("options", "status", "told"),
    [
        (("--material", "mild-steel"), 2, "go together"),
        (("--thickness", "3"), 2, "go together"),
        (("--material", "glass", "--thickness", "3"), 1, "glass"),
        (("--material", "mild-steel", "--thickness", "300"), 1, "300"),
        (("--process", "laser", *STEEL), 1, "does not cut by laser"),
        (("--process", "milling", *STEEL), 2, "milling"),
    ],
)
def test_half_of_the_options_and_what_the_chart_lacks_are_refused(
    options: tuple[str, ...], status: int, told: str, program: Path
) -> None:
    done = called("check", program, "--machine", "torch-table", *options)
    assert done.returncode == status, done.stdout + done.stderr
    assert told in done.stdout + done.stderr


def test_a_machine_without_charts_says_so(program: Path) -> None:
    done = called("time", program, "--machine", "table-a", *STEEL)
    assert done.returncode == 2
    assert "no process with a cut chart" in done.stderr


def test_a_certificate_holds_the_feed(program: Path, tmp_path: Path) -> None:
    certificate = tmp_path / "part.certificate.json"
    done = called("check", program, "--machine", "torch-table", *STEEL, "--certificate", certificate)
    assert done.returncode == 0, done.stdout + done.stderr
    assert Certificate.read(certificate).dialect == f"grbl:feed={steel_feed_mm_min():g}"


@pytest.fixture
def torch() -> Iterator[str]:
    """A running virtual grbl of the torch table: its port."""
    words = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "20", "--machine", "torch-table")
    process = subprocess.Popen(command(*words), stdout=subprocess.PIPE, encoding="utf-8", preexec_fn=forked(*words))
    assert process.stdout
    said = process.stdout.readline()
    yield "socket://" + re.split("socket://", said.strip())[-1]
    process.terminate()
    process.wait(10)


@pytest.mark.slow
def test_it_is_sent_with_the_charts_feed(program: Path, torch: str, tmp_path: Path) -> None:
    given = ("--port", torch, "--machine", "torch-table", "--zero-confirmed")
    sent = called("send", program, *given, *STEEL)
    assert sent.returncode == 0, sent.stdout + sent.stderr
    assert f"takes {steel_feed_mm_min():g} mm/min" in sent.stdout
    certificate = tmp_path / "part.certificate.json"
    called("check", program, "--machine", "torch-table", *STEEL, "--certificate", certificate)
    again = called("send", program, *given, "--certificate", certificate)
    assert again.returncode == 0, again.stdout + again.stderr
    other = called(
        "send", program, *given, "--certificate", certificate, "--material", "mild-steel", "--thickness", "4"
    )
    assert other.returncode == 1
    assert "another process, material, thickness" in other.stderr and "thickness_mm = 4.0" in other.stderr
