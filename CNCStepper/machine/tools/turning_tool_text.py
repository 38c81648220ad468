# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lathe tools as a command line names them."""

from __future__ import annotations

from pydantic import ValidationError

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.tools.insert_code import insert_of
from CNCStepper.machine.tools.turning_tool import TurningTool

EVERY_NUMBER = 0  # a tool without a number stands for every tool of the program
SIZES = {"drill": "diameter_mm", "parting": "width_mm"}
ADVICE = "write an insert (CNMG120408, 16ER1.5ISO), boring:CCMT060204, parting:3 or drill:10; 2=drill:10 for tool 2"


def turning_tool_from_text(text: str) -> TurningTool:
    """Return the tool of "[NUMBER=]INSERT", "boring:INSERT", "parting:WIDTH" or "drill:DIAMETER"; raises JobError."""
    number, is_numbered, shape = text.rpartition("=")
    kind, has_kind, size = shape.rpartition(":")
    what = Text("'{text}' is no tool of a lathe", text=text[:60])
    try:
        keys = {"number": int(number) if is_numbered else EVERY_NUMBER}
        if kind in SIZES:
            return TurningTool.model_validate(keys | {"kind": kind, SIZES[kind]: float(size)})
        if has_kind and kind not in ("turning", "boring", "threading"):
            raise JobError("tool-text", what, advice=ADVICE)
        usual = "threading" if insert_of(size).shape == "thread" else "turning"
        return TurningTool.model_validate(keys | {"kind": kind or usual, "insert": size})
    except (ValueError, ValidationError) as error:
        if isinstance(error, JobError):
            raise
        raise JobError("tool-text", what, advice=ADVICE) from error
