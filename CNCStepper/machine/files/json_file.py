# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON files that hold one object."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import MOST_TEXT_BYTES, read_input
from CNCStepper.safe_text import printable


def read_json(path: Path, most_bytes: int = MOST_TEXT_BYTES) -> dict[str, Any]:
    """Return the object of a JSON file; raises JobError naming the file where it holds none."""
    place = Place(str(path))
    try:
        content = json.loads(read_input(path, most_bytes).decode("utf-8-sig"))
    except RecursionError as error:
        raise JobError("json", "objects or lists are nested too deeply", place=place) from error
    except ValueError as error:  # no JSON, no UTF-8, or a number of thousands of digits
        if isinstance(error, JobError):
            raise
        raise JobError(
            "json", Text("not a JSON file: {error}", error=printable(str(error), 300)), place=place
        ) from error
    if not isinstance(content, dict):
        raise JobError("json", "the file holds no object", place=place)
    return content
