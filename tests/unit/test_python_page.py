# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of docs/reference/python.md run, are short, and use the whole public interface."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import CNCStepper

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "reference" / "python.md").read_text("utf-8")
EXAMPLES = dict(re.findall(r"^## (.+?)$.*?```python\n(.*?)```", PAGE, re.MULTILINE | re.DOTALL))
PORT = "socket://127.0.0.1:2217"


def run(code: str, folder: Path) -> str:
    """Run an example in a process of its own, in a folder that has the examples' files; return what it prints."""
    shutil.copytree(ROOT / "examples", folder / "examples", dirs_exist_ok=True)
    done = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
@pytest.mark.parametrize("title", [title for title, code in EXAMPLES.items() if PORT not in code])
def test_an_example_runs(title: str, tmp_path: Path) -> None:
    run(EXAMPLES[title], tmp_path)


@pytest.mark.slow
def test_the_example_of_a_send_cuts_its_program(tmp_path: Path) -> None:
    (code,) = (code for code in EXAMPLES.values() if PORT in code)
    command = [sys.executable, "-m", "CNCStepper.cli", "virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "20"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as virtual:
        try:
            assert virtual.stdout
            (port,) = re.findall(r"socket://[\w.:]+", virtual.stdout.readline())
            assert run(code.replace(PORT, port), tmp_path).startswith("done")
        finally:
            virtual.terminate()


def test_there_are_ten_short_examples_of_all_names() -> None:
    assert len(EXAMPLES) == 10
    assert all(len(code.splitlines()) < 15 for code in EXAMPLES.values())
    imported = re.findall(r"^from CNCStepper import (.+)$", "\n".join(EXAMPLES.values()), re.MULTILINE)
    assert {name for names in imported for name in names.split(", ")} == set(CNCStepper.__all__)


def test_nothing_is_loaded_before_it_is_used() -> None:
    code = "import sys, CNCStepper; print([m for m in sys.modules if m.startswith('CNCStepper.')], dir(CNCStepper))"
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert printed.startswith("[] ") and all(repr(name) in printed for name in CNCStepper.__all__)


def test_an_unknown_name_is_refused() -> None:
    with pytest.raises(AttributeError, match="no attribute 'Jobs'"):
        _ = CNCStepper.Jobs
