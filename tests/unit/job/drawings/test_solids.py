# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids by CadQuery and by FreeCAD: the same program from file and script, and scripts that are ended."""

from __future__ import annotations

import os
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import pytest

from CNCStepper.cycles.contours.contour_model import Lead
from CNCStepper.drawing.drawing import Drawing
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.errors import JobError, MissingPackage
from CNCStepper.job.drawings import solid_process, solids
from CNCStepper.job.drawings.read_any import read_any_drawing
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job

ROOT = Path(__file__).parents[4]
BRACKET = ROOT / "examples" / "drawings" / "bracket.step"
NO_LEAD = Lead(kind="none")
PLATE = ROOT / "examples" / "jobs" / "plate.toml"
CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
CADQUERY = Path(os.environ.get("CNCSTEPPER_CADQUERIES") or CACHE / "cncstepper-cadquery") / "bin" / "python"
SOON_S = 30.0


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CNCSTEPPER_CADQUERY", str(CADQUERY))


def read(path: Path, height_mm: float | None) -> Drawing:
    reader = solids.read_script if path.suffix == ".py" else read_any_drawing
    return reader(path, ReadOptions(height_mm=height_mm), lambda share: None)


def program(drawing: Drawing) -> str:
    """Return the program that cuts the chains of a drawing as the contour of the example plate is cut."""
    job, machine = load_job(PLATE)
    curves = tuple(chain.curve for chain in drawing.chains)
    own = {"curves": curves, "side": "on", "lead_in": NO_LEAD, "lead_out": NO_LEAD}
    contour = job.operation[-1].model_copy(update=own)
    return make_program(job.model_copy(update={"operation": (contour,)}), machine).program


@pytest.mark.slow
@pytest.mark.freecad
@pytest.mark.parametrize("height_mm", [3.0, None])
def test_a_bracket_gives_one_program_from_step_and_script_with_and_without_freecad(
    height_mm: float | None, engine: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert CADQUERY.exists(), "run 'make setup'"
    by_cadquery, by_script = read(BRACKET, height_mm), read(BRACKET.with_suffix(".py"), height_mm)
    monkeypatch.setenv("CNCSTEPPER_CADQUERY", "none")
    by_freecad = read(BRACKET, height_mm)
    assert len(by_freecad.chains) == 6 and all(chain.curve.closed for chain in by_freecad.chains)
    outline, hole = by_freecad.chains[0].curve, by_freecad.chains[1].curve
    assert outline.area_mm2 == pytest.approx(80 * 50 - (4 - 3.141592653589793) * 64, abs=1e-6)
    assert hole.radii_mm == pytest.approx([2.75, 2.75], abs=1e-9)
    assert program(by_cadquery) == program(by_freecad) == program(by_script)


@pytest.mark.freecad
def test_freecad_reads_a_document_without_what_its_objects_are_made_of(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, script = tmp_path / "peça.FCStd", tmp_path / "make.py"
    script.write_text(
        "import FreeCAD, Part\n"
        "document = FreeCAD.newDocument()\n"
        "box, hole = document.addObject('Part::Box'), document.addObject('Part::Cylinder')\n"
        "box.Length, box.Width, box.Height, hole.Radius = 20, 10, 5, 2\n"
        "hole.Placement.Base = FreeCAD.Vector(10, 5, -1)\n"
        "cut = document.addObject('Part::Cut')\n"
        "cut.Base, cut.Tool = box, hole\n"
        "document.recompute()\n"
        f"document.saveAs({str(path)!r})\n",
        "utf-8",
    )
    command = solid_process._freecad_command()
    home = {"FREECAD_USER_HOME": str(tmp_path)}
    subprocess.run([command, str(script)], stdin=subprocess.DEVNULL, env=os.environ | home, timeout=120, check=False)
    drawing = read(path, 2.0)
    box, hole = (chain.curve for chain in drawing.chains)
    assert box.area_mm2 == pytest.approx(200) and hole.radii_mm[0] == pytest.approx(2)
    assert drawing.chains[0].attributes.layer == "height 2" and drawing.chains[0].attributes.name == "peça"


@pytest.fixture
def stand_in(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder for scripts; `cadquery` is an empty module here, so that a process starts in no time."""
    modules = tmp_path / "modules"
    (modules / "OCP").mkdir(parents=True)
    for name in ("cadquery.py", "OCP/__init__.py", "OCP/STEPControl.py"):
        (modules / name).write_text("")
    monkeypatch.setenv("PYTHONPATH", str(modules))
    monkeypatch.setenv("CNCSTEPPER_CADQUERY", sys.executable)
    solid_process.cadquery_python.cache_clear()
    return tmp_path


def refused(folder: Path, script: str, limit_s: float = SOON_S) -> JobError:
    path = folder / "part.py"
    path.write_text(script, "utf-8")
    before = time.monotonic()
    with pytest.raises(JobError) as refusal:
        solids.read_script(path, ReadOptions(), lambda share: None, limit_s)
    assert time.monotonic() - before < SOON_S + limit_s and refusal.value.place and refusal.value.advice
    return refusal.value


@pytest.mark.skipif(os.name != "posix", reason="the limits of memory and files are those of POSIX")
@pytest.mark.parametrize(
    ("script", "code", "why"),
    [
        ("open('out.txt', 'w')", "solid-script", "writes a file: out.txt"),
        ("import pathlib; pathlib.Path('a').write_text('b')", "solid-script", "writes a file: a"),
        ("import os; os.open('a', os.O_CREAT | os.O_WRONLY)", "solid-script", "writes a file"),
        ("import os; os.remove(__file__)", "solid-script", "removes a file"),
        ("import os; os.fork()", "solid-script", "starts a process"),
        ("import subprocess; subprocess.run(['true'])", "solid-script", "starts a program: true"),
        ("import os; os.system('true')", "solid-script", "starts a program"),
        ("import socket; socket.create_connection(('127.0.0.1', 9))", "solid-script", "opens a connection"),
        ("kept = bytearray(1 << 33)", "solid-memory", "more memory"),
        ("raise ValueError('no width')", "solid-script", "ValueError: no width"),
        ("def", "solid-file", "SyntaxError"),
        ("box = 1", "solid-script", "shows no solid"),
        ("import os; os._exit(3)", "solid-ended", "status 3"),
        ("import os; os.write(1, b'x' * 9)\nraise SystemExit", "solid-script", "shows no solid"),
    ],
)
def test_a_script_that_does_more_than_draw_is_ended_with_the_reason(
    stand_in: Path, script: str, code: str, why: str
) -> None:
    error = refused(stand_in, script)
    assert error.code == code and why in error.what and error.advice == "correct the script"
    assert (stand_in / "part.py").exists()


def test_a_script_that_loops_is_ended(stand_in: Path) -> None:
    error = refused(stand_in, "while True: pass", limit_s=1.0)
    assert error.code == "solid-time" and error.limit == "1 s"


def test_a_script_that_prints_for_ever_is_ended(stand_in: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(solid_process, "MOST_OUTPUT_BYTES", 1_000_000)
    assert refused(stand_in, "import os\nwhile True: os.write(1, b'x' * 65536)").code == "solid-large"


def test_a_script_is_no_drawing_that_a_document_may_name(stand_in: Path) -> None:
    (stand_in / "part.py").write_text("")
    with pytest.raises(JobError, match=r"'\.py'"):
        read_any_drawing(stand_in / "part.py", ReadOptions())
    with pytest.raises(JobError, match="no Python script"):
        solids.read_script(BRACKET, ReadOptions(), lambda share: None)


def test_without_a_program_that_reads_solids_the_refusal_names_both(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CNCSTEPPER_CADQUERY", "none")
    monkeypatch.setenv("CNCSTEPPER_FREECADCMD", "none")
    with pytest.raises(MissingPackage, match="CadQuery or FreeCAD") as refusal:
        read(BRACKET, 3.0)
    assert "CNCSTEPPER_CADQUERY" in refusal.value.advice and "CNCSTEPPER_FREECADCMD" in refusal.value.advice
    with pytest.raises(MissingPackage, match="CadQuery or build123d") as refusal:
        solids.read_script(BRACKET.with_suffix(".py"), ReadOptions(), lambda share: None)
    assert refusal.value.advice == "set CNCSTEPPER_CADQUERY to a Python that has CadQuery"


def test_documents_that_unpack_to_too_much_or_are_none_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(solids, "MOST_UNPACKED_BYTES", 40_000_000)
    path = tmp_path / "bomb.FCStd"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive, archive.open("Document.xml", "w") as member:
        for _ in range(41):
            member.write(bytes(1_000_000))
    assert path.stat().st_size < 100_000
    with pytest.raises(JobError, match="unpacks to too much"):
        read(path, None)
    path.write_bytes(b"no archive")
    with pytest.raises(JobError, match="not a FreeCAD document"):
        read(path, None)
    (tmp_path / "empty.step").write_bytes(b"")
    with pytest.raises(JobError, match="empty"):
        read(tmp_path / "empty.step", None)
