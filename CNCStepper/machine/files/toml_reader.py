# SPDX-License-Identifier: LGPL-2.1-or-later
"""TOML files: job files and machine profiles, read in bounded time whatever their content.

JSON files that hold one object.
"""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import MOST_TEXT_BYTES, read_input
from CNCStepper.safe_text import printable

MOST_BYTES = 4_000_000  # tomllib reads some 2 MB a second; points by the thousand belong into a file of their own
DEEPEST_KEY = 100  # parts of a dotted key: tomllib's time grows with their square
_PART = r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')"""
_DEEP_KEY = re.compile(rf"""(?<![\w"'.-])(?:{_PART}[ \t]*\.[ \t]*){{{DEEPEST_KEY}}}""")


def read_toml(path: Path) -> dict[str, Any]:
    """Return the content of a TOML file; raises JobError naming the file and line."""
    place = Place(str(path))
    try:
        text = read_input(path, MOST_BYTES).decode("utf-8-sig")
        if deep := _DEEP_KEY.search(text):
            line = text.count("\n", 0, deep.start()) + 1
            raise _too_deep(Place(place.file, line))
        return tomllib.loads(text)
    except RecursionError as error:
        raise _too_deep(place) from error
    except ValueError as error:  # no TOML, no UTF-8, or a number of thousands of digits
        if isinstance(error, JobError):
            raise
        what = Text("not a TOML file: {error}", error=printable(str(error), 300))
        advice = "correct that, or name a TOML file"
        raise JobError("toml", what, place=place, advice=advice) from error


def _too_deep(place: Place) -> JobError:
    what = "tables or lists are nested too deeply"
    return JobError("toml-nested", what, limit=f"{DEEPEST_KEY}", advice="write flatter tables", place=place)


def read_json(path: Path, most_bytes: int = MOST_TEXT_BYTES) -> dict[str, Any]:
    """Return the object of a JSON file; raises JobError naming the file where it holds none."""
    place = Place(str(path))
    try:
        content = json.loads(read_input(path, most_bytes).decode("utf-8-sig"))
    except RecursionError as error:
        advice = "write them flatter"
        raise JobError("json", "objects or lists are nested too deeply", place=place, advice=advice) from error
    except ValueError as error:  # no JSON, no UTF-8, or a number of thousands of digits
        if isinstance(error, JobError):
            raise
        what = Text("not a JSON file: {error}", error=printable(str(error), 300))
        advice = "correct that, or name a JSON file"
        raise JobError("json", what, place=place, advice=advice) from error
    if not isinstance(content, dict):
        raise JobError("json", "the file holds no object", place=place, advice="write its keys and values in braces")
    return content
