# SPDX-License-Identifier: LGPL-2.1-or-later
"""The script in the README does what it says."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

README = Path(__file__).parents[2] / "README.md"


def test_the_script_in_the_readme_saves_a_program(
    document: object, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = re.search(r"```python\n(.*?)```", README.read_text("utf-8"), re.DOTALL)
    assert script
    monkeypatch.chdir(tmp_path)
    exec(script.group(1), {})
    assert (tmp_path / "pocket.nc").read_text("ascii").endswith("M2\n")
