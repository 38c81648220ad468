# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program text named by a journal, if its file still holds what was sent."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from CNCStepper.control.journal.replay import JobReplay
from CNCStepper.control.program.certificate import digest_of_text
from CNCStepper.gcode.syntax.text_format import decoded


def text_sent(story: JobReplay, texts: Iterable[str] = ()) -> str | None:
    """Return the text that was sent, found among these texts or in its file; None where neither is it any more."""
    sha256, file = story.header["program_sha256"], Path(story.header["file"])
    if (found := next((text for text in texts if digest_of_text(text) == sha256), None)) is not None:
        return found
    try:
        text = decoded(file.read_bytes())[0]
    except OSError:  # gone, or not to be read by whoever asks
        return None
    return text if not sha256 or digest_of_text(text) == sha256 else None
