# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lathe tools as a command line names them."""

import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.tools.turning_tool_text import turning_tool_from_text


@pytest.mark.parametrize(
    ("text", "number", "kind", "words"),
    [
        ("CNMG120408", 0, "turning", "turning CNMG120408"),
        ("2=DNMG 110404", 2, "turning", "turning DNMG 110404"),
        ("16ER 1.5 ISO", 0, "threading", "threading 16ER 1.5 ISO"),
        ("3=boring:CCMT060204", 3, "boring", "boring CCMT060204"),
        ("parting:3", 0, "parting", "parting blade 3 mm"),
        ("4=drill:10.5", 4, "drill", "drill 10.5 mm"),
    ],
)
def test_tools_from_text(text: str, number: int, kind: str, words: str) -> None:
    tool = turning_tool_from_text(text)
    assert (tool.number, tool.kind, tool.words) == (number, kind, words)


@pytest.mark.parametrize("text", ["", "spoon:3", "drill:", "parting:x", "x=drill:3", "QQMG120408", "boring:16ER1.5ISO"])
def test_what_is_no_tool_is_refused(text: str) -> None:
    with pytest.raises(JobError):
        turning_tool_from_text(text)
