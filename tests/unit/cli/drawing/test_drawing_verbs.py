# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper drawing` and `cncstepper job` as a stranger uses them."""

from __future__ import annotations

import json
from pathlib import Path

import ezdxf
import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import group, main
from CNCStepper.job.model import load_job

ROOT = Path(__file__).parents[4]
GASKET = ROOT / "examples" / "drawings" / "gasket.dxf"
TEMPLATES = ROOT / "examples" / "templates"


def run(*arguments: object) -> Result:
    return CliRunner().invoke(group, [str(argument) for argument in arguments])


@pytest.fixture
def faulty(tmp_path: Path) -> Path:
    document = ezdxf.new(units=ezdxf.units.MM)
    space = document.modelspace()
    corners = [(0, 0), (100, 0), (100, 50), (0.2, 50)]
    for begin, end in zip(corners, [*corners[1:], (0, 0)], strict=True):
        space.add_line(begin if begin != (0.2, 50) else (0, 50), end, dxfattribs={"layer": "CUT"})
    space.add_line((20, 0), (60, 0), dxfattribs={"layer": "CUT"})
    space.add_point((3, 3), dxfattribs={"layer": "CUT"})
    document.saveas(tmp_path / "peça.dxf")
    return tmp_path / "peça.dxf"


def test_the_drawing_is_printed_listed_and_drawn(tmp_path: Path) -> None:
    result = run("drawing", GASKET, "--json", tmp_path / "a" / "chains.json", "--picture", tmp_path / "g.svg")
    assert result.exit_code == 0, result.output
    assert "DXF, unit 1 mm" in result.output and "7 closed, 0 open" in result.output
    rows = json.loads((tmp_path / "a" / "chains.json").read_text("utf-8"))
    assert len(rows) == 7 and rows[0]["closed"] and rows[0]["area_mm2"] > 20_000
    assert set(rows[0]) >= {"layer", "colour", "name", "closed", "length_mm", "area_mm2", "box_mm"}
    assert "CNCStepper" in (tmp_path / "g.svg").read_text("utf-8")


def test_problems_are_printed_with_their_places_and_mended_only_on_request(faulty: Path, tmp_path: Path) -> None:
    result = run("drawing", faulty, "--picture", tmp_path / "p.png")
    assert "problem: gaps: 1" in result.output and "problem: stretches drawn twice: 1" in result.output
    assert "X40.000 Y0.000, 40 mm" in result.output and "left out: POINT" in result.output
    assert "mended" not in result.output and (tmp_path / "p.png").stat().st_size > 10_000
    mended = run("drawing", faulty, "--mend", "-o", tmp_path / "m.dxf")
    assert "mended: gaps were closed: 1" in mended.output and "problem:" not in mended.output
    assert "1 closed, 0 open, 300 mm" in mended.output
    assert run("drawing", tmp_path / "m.dxf", "--mend", "-o", tmp_path / "m.dxf").exit_code == 1  # its own input


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [("x.dxf", "no drawing", "dxf-file"), ("x.xyz", "", "drawing-format")],
)
def test_a_refusal_is_one_sentence_and_exit_1(
    tmp_path: Path, name: str, content: str, code: str, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    (tmp_path / name).write_text(content)
    monkeypatch.setattr("sys.argv", ["cncstepper", "drawing", str(tmp_path / name)])
    with pytest.raises(SystemExit) as end:
        main()
    told = capsys.readouterr()
    assert end.value.code == 1 and f"[{code}]" in told.err and name in told.err and not told.out


def test_an_output_of_another_format_is_refused(tmp_path: Path) -> None:
    result = run("drawing", GASKET, "-o", tmp_path / "x.pdf")
    assert result.exit_code == 1 and result.exception is not None and ".dxf" in str(result.exception)


def test_a_template_makes_a_job_file(tmp_path: Path) -> None:
    job = tmp_path / "jobs" / "gasket.toml"
    result = run("job", GASKET, "--template", TEMPLATES / "sheet-plasma.toml", "-o", job, "--thickness", 3)
    assert result.exit_code == 0, result.output
    assert "parts: 7 chains" in result.output and "stock 230 x 150 x 3 mm" in result.output
    loaded, machine = load_job(job)
    assert len(loaded.operation[0].curves) == 7 and machine.process("plasma")


def test_what_no_rule_takes_is_printed_and_refused_when_strict(faulty: Path, tmp_path: Path) -> None:
    template = TEMPLATES / "sheet-plasma.toml"
    words = ("job", faulty, "--template", template, "-o", tmp_path / "j.toml")
    text = template.read_text("utf-8").replace("mend = ", "# ")
    (tmp_path / "plain.toml").write_text(text.replace("closed = true", 'layer = "x"'), encoding="utf-8")
    refused = run("job", faulty, "--template", tmp_path / "plain.toml", "-o", tmp_path / "j.toml", "--strict")
    assert refused.exit_code == 1 and "no rule" in str(refused.exception) and not (tmp_path / "j.toml").exists()
    assert run(*words).exit_code == 0
    assert "made by CNCStepper" in (tmp_path / "j.toml").read_text("utf-8").splitlines()[0]
    assert run(*words).exit_code == 0, "our own job file is replaced without asking"
