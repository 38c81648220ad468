# SPDX-License-Identifier: LGPL-2.1-or-later
"""A backup of a controller's settings: a text of lines `$number=value`, each with its name as a comment.

; settings of grbl 1.1h.20190830 at /dev/ttyUSB0
$100=80 ; X: steps per mm, 1/mm

What `$$` prints and what other senders save is read too: of a line all behind its value is a comment.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from CNCStepper.atomic_file import write_whole
from CNCStepper.control.settings.setting_names import setting_name
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import read_input
from CNCStepper.safe_text import printable
from CNCStepper.word_pattern import DECIMAL

MOST_BYTES = 200_000
_LINE = re.compile(rf"\$([0-9]{{1,4}})\s*=\s*({DECIMAL})(?=\s|[;(]|$)")
_COMMENT = re.compile(r"(?:[;(#].*)?")
_TEXT_SETTING = re.compile(r"\$[\w/]+\s*=.*")  # of a firmware that has settings with texts


def settings_text(settings: Mapping[int, float], of: str) -> str:
    """Return a backup as text; of: whose settings they are, for its first line."""
    lines = [f"; settings of {printable(of, 200)}"]
    for number, value in sorted(settings.items()):
        words = ", ".join(part for part in setting_name(number) if part)
        lines.append(f"{setting_line(number, value)} ; {words}" if words else setting_line(number, value))
    return "\n".join(lines) + "\n"


def setting_line(number: int, value: float) -> str:
    """Return the line that sets a setting; grbl keeps three decimals of most."""
    return f"${number}={value:.10g}"


def write_settings(path: Path, settings: Mapping[int, float], of: str) -> None:
    """Write a backup, whole or not at all."""
    write_whole(path, settings_text(settings, of).encode("utf-8"))


def read_settings(path: Path) -> dict[int, float]:
    """Return the settings of a backup; raises JobError naming the line that is none, or where there is none at all."""
    found: dict[int, float] = {}
    text = read_input(path, MOST_BYTES).decode("utf-8-sig", "replace")
    for number, line in enumerate(map(str.strip, text.splitlines()), 1):
        setting = _LINE.match(line)
        if setting:
            found[int(setting[1])] = float(setting[2])
        elif not _COMMENT.fullmatch(line) and not _TEXT_SETTING.fullmatch(line):
            raise JobError(
                "settings-line",
                Text("this is no setting: {line}", line=printable(line, 60)),
                advice="write each setting as $number=value, as $$ prints it",
                place=Place(str(path), number),
            )
    if not found:
        what = "the file holds no settings of a controller"
        raise JobError("settings-none", what, advice="save one with a backup", place=Place(str(path)))
    return found
