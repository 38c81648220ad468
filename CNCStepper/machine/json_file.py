# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON files that hold one object."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError, Place


def read_json(path: Path) -> dict[str, Any]:
    """Return the object of a JSON file; raises JobError naming the file where it holds none."""
    try:
        content = json.loads(path.read_text("utf-8-sig"))
    except ValueError as error:  # JSONDecodeError and UnicodeDecodeError are both
        raise JobError("json", f"not a JSON file: {error}", place=Place(str(path))) from error
    if not isinstance(content, dict):
        raise JobError("json", "the file holds no object", place=Place(str(path)))
    return content
