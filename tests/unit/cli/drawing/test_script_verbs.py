# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper drawing` and `cncstepper job` with a script: what it draws, and scripts that are ended and named."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import group
from CNCStepper.job.drawings import solid_process, solids
from CNCStepper.job.model import load_job

ROOT = Path(__file__).parents[4]
SCRIPT = ROOT / "examples" / "drawings" / "bracket.py"
TEMPLATE = ROOT / "examples" / "templates" / "sheet-plasma.toml"
CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
CADQUERY = Path(os.environ.get("CNCSTEPPER_CADQUERIES") or CACHE / "cncstepper-cadquery") / "bin" / "python"


def run(verb: str, script: Path, folder: Path) -> Result:
    """Run one of the two verbs on a script."""
    more = ["--template", str(TEMPLATE), "-o", str(folder / "part.toml")] if verb == "job" else []
    return CliRunner().invoke(group, [verb, str(script), *more])


@pytest.mark.slow
@pytest.mark.freecad
def test_what_a_script_draws_is_printed_and_becomes_a_job(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CNCSTEPPER_CADQUERY", str(CADQUERY))
    printed = run("drawing", SCRIPT, tmp_path)
    assert printed.exit_code == 0 and "layer 'outline': 6 closed, 0 open, 372.513 mm" in printed.output
    made = run("job", SCRIPT, tmp_path)
    assert made.exit_code == 0 and "parts: 6 chains" in made.output
    job, _ = load_job(tmp_path / "part.toml")
    assert len(job.operation) == 1 and (tmp_path / "part-bracket.dxf").exists()


@pytest.mark.skipif(os.name != "posix", reason="the limits of memory and files are those of POSIX")
@pytest.mark.parametrize("verb", ["drawing", "job"])
@pytest.mark.parametrize(
    ("script", "code"),
    [
        ("while True: pass", "solid-time"),
        ("kept = bytearray(1 << 33)", "solid-memory"),
        ("open('out.txt', 'w').write('x')", "solid-script"),
    ],
)
def test_a_script_that_does_more_than_draw_is_ended_and_named(
    verb: str, script: str, code: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    modules = tmp_path / "modules"
    (modules / "OCP").mkdir(parents=True)
    for name in ("cadquery.py", "OCP/__init__.py", "OCP/STEPControl.py"):
        (modules / name).write_text("")
    monkeypatch.setenv("PYTHONPATH", str(modules))
    monkeypatch.setenv("CNCSTEPPER_CADQUERY", sys.executable)
    solid_process.cadquery_python.cache_clear()
    (tmp_path / "wild.py").write_text(script, "utf-8")
    monkeypatch.setattr(solids, "LIMIT_S", 3.0)
    refused = run(verb, tmp_path / "wild.py", tmp_path)
    words = f"{refused.output}{refused.exception}"
    assert refused.exit_code == 1 and code in words and "wild.py" in words
    assert sorted(path.name for path in tmp_path.iterdir()) == ["modules", "wild.py"]
