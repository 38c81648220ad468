# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lathe jobs: opened, edited, saved and exported; the document makes the same program as the job file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import pytest

from CNCStepper.errors import JobError
from CNCStepper.job.turning.make_turning import make_turning
from CNCStepper.job.turning.prove_turning import prove_turning
from CNCStepper.job.turning.turning_job import load_turning_job
from CNCStepper.job.turning.turning_proof_folder import read_turned_answer
from CNCStepper.workbench import api
from CNCStepper.workbench.document.job_files import export_job, open_job
from CNCStepper.workbench.features.base import edit, problem_of, values
from CNCStepper.workbench.features.turning.turning_operation import TURNING_OPERATIONS
from CNCStepper.workbench.restart import open_restart
from CNCStepper.workbench.templates.turning_template import TurningBeginning, save
from CNCStepper.workers.proof import answer

ROOT = Path(__file__).parents[2]
SHAFT = ROOT / "examples" / "jobs" / "lathe-shaft.toml"
JOBS = sorted((ROOT / "examples" / "jobs").glob("lathe-*.toml"))


def programs_of(path: Path, title: str) -> list[str]:
    job, machine = load_turning_job(path)
    return [program.program for program in make_turning(job, machine, title)]


def texts(job: Any) -> list[str]:
    return [text for _, text in job.Proxy.programs(job)]


def opened(document: Any, path: Path) -> Any:
    job, notes = open_job(document, path)
    document.recompute()
    assert notes == []
    assert not [problem_of(each) for each in (*job.Tools, *job.Operations, job) if problem_of(each)]
    return job


@pytest.mark.parametrize("path", JOBS, ids=lambda path: path.stem)
def test_a_job_file_gives_its_own_programs_and_comes_out_again(document: Any, path: Path, tmp_path: Path) -> None:
    job = opened(document, path)
    assert texts(job) == programs_of(path, job.Label)
    assert api.program_text(job) == texts(job)[0]
    export_job(job, tmp_path / "out.toml")
    assert programs_of(tmp_path / "out.toml", job.Label) == texts(job)


def begun(document: Any) -> tuple[Any, TurningBeginning]:
    job = api.new_lathe_job(document)
    api.add_tool(job)
    return job, TurningBeginning(job)


def state(job: Any) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    found = values(job)
    kept = {key: found[key] for key in TurningBeginning.KEYS} | {"machine": Path(job.Machine).resolve()}
    return kept, [values(tool) for tool in job.Tools]


@pytest.mark.parametrize("path", JOBS, ids=lambda path: path.stem)
def test_a_new_job_begins_with_the_template_of_another(document: Any, path: Path, tmp_path: Path) -> None:
    other, template = opened(document, path), tmp_path / "torno ç.toml"
    save(other, template)
    job, beginning = begun(document)
    usual = state(job)
    beginning.take(str(template))
    assert state(job) == state(other) != usual
    document.recompute()
    assert not any(map(problem_of, (job, *job.Tools)))
    beginning.take("")
    assert state(job) == usual
    edit(job, stock_length_mm=97)
    edit(job.Tools[0], nose_radius_mm=0.7)
    beginning.take(str(template))
    assert (float(job.Length), float(job.Diameter)) == (97, float(other.Diameter))
    assert [tool.Number for tool in job.Tools[:1]] == [1] and len(job.Tools) == 1 + len(other.Tools)


def test_a_lathe_s_template_names_its_machine_s_file_wherever_the_document_lies(document: Any, tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    machine = tmp_path / "a" / "own.toml"
    machine.write_bytes((ROOT / "examples" / "machines" / "mini-lathe-index.toml").read_bytes())
    document.saveAs(str(tmp_path / "a" / "one.FCStd"))
    job, _ = begun(document)
    edit(job, machine="own.toml")
    save(job, tmp_path / "b" / "torno.toml")
    document.saveAs(str(tmp_path / "two.FCStd"))
    other, beginning = begun(document)
    beginning.take(str(tmp_path / "b" / "torno.toml"))
    assert Path(other.Machine) == machine


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ('machine = "mini-lathe"', 'machine = "wire-table"', "X and Z"),
        ("[stock]", "[stock", "toml"),
        ("diameter_mm = 55", "diameter_mm = -55", "diameter_mm"),
        ("number = 2", "number = 1", "number"),
        ("length_mm = 130", "length_mm = 130\nthickness_mm = 3", "thickness_mm"),
    ],
)
def test_a_template_that_cannot_be_used_changes_nothing(
    document: Any, tmp_path: Path, old: str, new: str, why: str
) -> None:
    template = tmp_path / "torno.toml"
    save(opened(document, SHAFT), template)
    text = template.read_text("utf-8").replace(".0\n", "\n")
    assert old in text
    template.write_text(text.replace(old, new), "utf-8")
    job, beginning = begun(document)
    before, names = state(job), [each.Name for each in document.Objects]
    with pytest.raises(JobError, match=why):
        beginning.take(str(template))
    assert (state(job), [each.Name for each in document.Objects]) == (before, names)


def test_a_saved_lathe_job_opens_with_the_same_program(document: Any, tmp_path: Path) -> None:
    job = opened(document, JOBS[-1])
    before, name = texts(job), job.Name
    document.saveAs(str(tmp_path / "lathe.FCStd"))
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(str(tmp_path / "lathe.FCStd"))
    job = again.getObject(name)
    assert api.program_text(job) == before[0]
    again.recompute()
    for each in job.Operations:
        each.touch()
    again.recompute()
    assert texts(job) == before


def test_the_program_of_a_lathe_is_not_restarted_in_its_middle(document: Any) -> None:
    with pytest.raises(JobError, match="cannot be restarted in its middle"):
        open_restart(opened(document, JOBS[0]), lambda *_: None)


CHANGES = {
    "turn_face": {"to_diameter_mm": 20.0},
    "turn_rough": {"ap_mm": 1.25},
    "turn_finish": {"feed_mm_rev": 0.15},
    "turn_taper": {"begin_chamfer_mm": 0.5},
    "turn_groove": {"width_mm": 4.0},
    "turn_part": {"peck_mm": 2.0},
    "turn_drill": {"depth_mm": 22.0},
    "turn_bore": {"stock_to_leave_mm": 0.2},
    "turn_thread": {"spring_passes": 3},
}


def whole(document: Any) -> Any:
    """A job with every cycle; LinuxCNC's machine takes all of them in one program."""
    machine = str(ROOT / "examples" / "machines" / "mini-lathe-index.toml")
    job = api.new_lathe_job(document, machine=machine, stock_diameter_mm=40, stock_length_mm=80)
    turning = api.add_tool(job, insert="CNMG 120408")
    blade = api.add_tool(job, kind="parting", width_mm=2.0, reach_mm=30)
    drill = api.add_tool(job, kind="drill", diameter_mm=10)
    bar = api.add_tool(job, kind="boring", insert="CCMT 060204", bar_mm=6, smallest_bore_mm=9)
    threading = api.add_tool(job, kind="threading", insert="16ER 1.5 ISO", spindle_rpm=90)
    outside = api.add_profile(document, ["30; 0", "30; -30", "38; -40"])
    inside = api.add_profile(document, ["16; 0", "16; -15"])
    api.add_operation(job, "turn_face", tool=turning)
    api.add_operation(job, "turn_rough", outside, tool=turning)
    api.add_operation(job, "turn_finish", outside, tool=turning)
    api.add_operation(job, "turn_drill", tool=drill)
    api.add_operation(job, "turn_bore", inside, tool=bar, ap_mm=0.5)
    api.add_operation(job, "turn_thread", tool=threading, thread="M30x1.5", length_mm=15, pull_out_mm=1)
    api.add_operation(job, "turn_groove", tool=blade, z_mm=-25, width_mm=3, diameter_mm=26, top_diameter_mm=30)
    api.add_operation(job, "turn_part", tool=blade, z_mm=-45)
    api.add_operation(job, "turn_taper", tool=turning, diameter_mm=20, end_diameter_mm=28, length_mm=15)
    document.recompute()
    return job


@pytest.mark.parametrize("cycle", TURNING_OPERATIONS)
def test_each_operation_is_edited_and_the_change_is_undone(document: Any, cycle: str) -> None:
    document.UndoMode = 1
    job = whole(document)
    assert not [problem_of(each) for each in (*job.Operations, job) if problem_of(each)]
    before = texts(job)
    operation = next(each for each in job.Operations if cycle == each.Proxy.CYCLE)
    document.openTransaction("edit")
    edit(operation, **CHANGES[cycle])
    document.commitTransaction()
    document.recompute()
    assert texts(job) != before
    document.undo()
    document.recompute()
    assert texts(job) == before


def test_a_refusal_is_said_at_its_operation(document: Any) -> None:
    job = whole(document)
    bore = job.Operations[4]
    job.Operations[3].Active = False
    document.recompute()
    assert "no hole" in problem_of(bore)
    assert "operation " not in problem_of(bore)
    with pytest.raises(JobError, match="no hole"):
        api.program_text(job)


def test_x_as_radius_changes_the_program_and_not_the_part(document: Any) -> None:
    job = opened(document, JOBS[0])
    before = job.Proxy.read_back(job, api.program_text(job)).table().end[:, :3]
    edit(job, x_is="diameter", start_x_mm=2 * float(job.StartX))
    document.recompute()
    after = job.Proxy.read_back(job, api.program_text(job)).table().end[:, :3]
    assert after == pytest.approx(before, abs=1e-3)


def test_a_job_without_what_it_needs_says_so(document: Any) -> None:
    job = api.new_lathe_job(document)
    with pytest.raises(JobError, match="bore_mm"):
        edit_and_check(job, stock_form="tube", stock_bore_mm=80)
    with pytest.raises(JobError, match="axes X and Z"):
        api.new_lathe_job(document, machine="wire-table")
    api.add_tool(job)
    api.add_operation(job, "turn_rough")
    document.recompute()
    assert "has no profile" in problem_of(job.Operations[0])


def edit_and_check(job: Any, **values: Any) -> None:
    edit(job, **values)
    job.Proxy.check(job)


def proven(job: Any, tmp_path: Path) -> Any:
    """Return the answer of the proof of a job's program, as the process that proves gives it."""
    job.Proxy.proof_question(job, job)(tmp_path, api.program_text(job))
    answer(tmp_path, job.Label)
    return read_turned_answer(tmp_path)


def test_the_proof_of_the_document_is_that_of_the_job_file(document: Any, tmp_path: Path) -> None:
    job = opened(document, SHAFT)
    core, machine = load_turning_job(SHAFT)
    made = make_turning(core, machine, job.Label)
    proofs = list(prove_turning(core, machine, made, tmp_path))
    assert job.ProgramParts == len(proofs) == 3
    for part, wanted in enumerate(proofs, start=1):
        edit(job, part=part)
        document.recompute()
        folder = tmp_path / f"{part}"
        folder.mkdir()
        found = proven(job, folder)
        assert found.report["profile"] == wanted.proof.report["profile"]
        assert [one.code for one in found.findings] == [one.code for one in wanted.proof.findings]
        assert found.send_file.is_file() and not found.refused
        assert max(ring[:, 1].max() for ring in found.rings) == pytest.approx(27.5)


def test_a_gouge_in_an_edited_program_is_found(document: Any, tmp_path: Path) -> None:
    job = opened(document, JOBS[0])
    edited = api.edit_program(job, api.program_text(job).replace("G01", "G00"))
    document.recompute()
    job.Proxy.proof_question(job, edited)(tmp_path, api.program_text(edited))
    answer(tmp_path, edited.Label)
    assert read_turned_answer(tmp_path).refused
