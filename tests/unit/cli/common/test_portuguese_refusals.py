# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bad programs and bad job files are refused in Portuguese: no function word of English is left in a refusal."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from CNCStepper.cli.common.language import OVERRIDE
from CNCStepper.job.model import load_job
from helpers.cli.command_line import called

ROOT = Path(__file__).parents[4]
PROGRAMS = sorted((ROOT / "tests" / "bad").glob("*.nc"))
DIALECT = re.compile(r"; expect \S+ \d+:\d+ ?([^ |]*)")
QUOTED = re.compile(r"'[^']*'|\"[^\"]*\"|\([^)]*\)|\[[^\]]*\]|\w+ = |\w+[._][\w.]+")  # values, codes, keys
ENGLISH = re.compile(
    r"\b(the|is|are|of|and|with|an|to|must|not|in|from|for|than|which|be|has|have|write|only|it|this|by|should|there|"
    r"give|take|its|number|value|limit)\b"
)
JOB = """\
machine = "table-b"
material = "aluminium-6061"
clearance_mm = 5.0
retract_mm = 2.0

[stock]
form = "box"
size_mm = [60.0, 40.0, 10.0]
origin = "top-left-front"

[[tool]]
number = 1
shape = "flat"
diameter_mm = 6.0

[[operation]]
cycle = "circular_pocket"
centre_mm = [30.0, 20.0]
radius_mm = 10.0
depth_mm = 4.0
stepdown_mm = 2.0
stepover_mm = 2.0
tool = 1
"""
CHANGES = [
    ("clearance_mm = 5.0", 'clearance_mm = "high"'),
    ("clearance_mm = 5.0", "clearance_mm = 5e9"),
    ("clearance_mm = 5.0", "clearence_mm = 5.0"),
    ('material = "aluminium-6061"', "material = 5"),
    ('material = "aluminium-6061"', 'units = "furlong"'),
    ('machine = "table-b"', ""),
    ('machine = "table-b"', 'machine = "table-z"'),
    ('form = "box"', 'form = "round"'),
    ("size_mm = [60.0, 40.0, 10.0]", "size_mm = [60.0, 40.0]"),
    ("size_mm = [60.0, 40.0, 10.0]", 'size_mm = "large"'),
    ("size_mm = [60.0, 40.0, 10.0]", ""),
    ("[stock]", "stock = 3\n[stock2]"),
    ("number = 1", "number = 1.5"),
    ("number = 1", "number = true"),
    ('shape = "flat"', 'shape = "heart"'),
    ('shape = "flat"', ""),
    ("diameter_mm = 6.0", "diameter_mm = -6.0"),
    ("diameter_mm = 6.0", ""),
    ('cycle = "circular_pocket"', 'cycle = "hole"'),
    ('cycle = "circular_pocket"', ""),
    ("centre_mm = [30.0, 20.0]", "centre_mm = [30.0]"),
    ("centre_mm = [30.0, 20.0]", "centre_mm = [30.0, 20.0, 1.0]"),
    ("depth_mm = 4.0", ""),
    ("depth_mm = 4.0", "depth_mm = 0.0"),
    ("tool = 1", "tool = 7"),
    ("tool = 1", 'tool = "flat"'),
]


def refused(words: list[str], monkeypatch: pytest.MonkeyPatch, language: str) -> str:
    """Return what the command line says of a refusal in a language."""
    monkeypatch.setenv(OVERRIDE, language)
    monkeypatch.setenv("LANGUAGE", "")  # which the command sets
    result = called(*words)
    assert result.returncode, words
    return "\n".join(line for line in (result.stdout + result.stderr).splitlines() if line.strip())


def english_in(text: str, *names: object) -> list[str]:
    """Return the English words of a text; names: of files in it."""
    for name in names:
        text = text.replace(str(name), "")
    return ENGLISH.findall(QUOTED.sub("", text))


@pytest.mark.parametrize("program", PROGRAMS[::10], ids=lambda path: path.stem)
def test_a_bad_program_is_refused_in_portuguese(program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    copy = shutil.copy(program, tmp_path / "p.nc")
    dialect = DIALECT.match(program.read_text("utf-8").splitlines()[-1])
    assert dialect
    words = ["check", str(copy), "--machine", "table-b", "--dialect", dialect[1] or "grbl"]
    said, english = (refused(words, monkeypatch, language) for language in ("pt", "en"))
    assert english_in(said, copy) == [], said
    same = set(said.splitlines()) & set(english.splitlines())
    assert not same, same


def test_the_job_without_a_change_is_taken(tmp_path: Path) -> None:
    job = tmp_path / "job.toml"
    job.write_text(JOB, "utf-8")
    assert load_job(job)[0].operation


@pytest.mark.parametrize(("old", "new"), CHANGES, ids=lambda text: text)
def test_a_bad_job_file_is_refused_in_portuguese(
    old: str, new: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    job = tmp_path / "job.toml"
    assert old in JOB
    job.write_text(JOB.replace(old, new, 1), "utf-8")
    words = ["run", str(job), "--out", str(tmp_path / "out")]
    said, english = (refused(words, monkeypatch, language) for language in ("pt", "en"))
    assert english_in(said, job) == [], said
    assert said != english
