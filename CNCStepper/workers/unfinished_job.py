# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that summarizes the unfinished job: `python -m CNCStepper.workers.unfinished_job`.

Each line on standard input asks once, in JSON; each is answered by one line on standard output, in the same order:

    {"port": "COM3", "programs": [FILE, ...]}   of the machine at a port, of any for ""; FILE: what it may have cut

    {"job": {"told": [[name, words], ...],      what is certain of it, as `cncstepper resume` tells it
             "file": "Plate.nc",                its program, or the one that it was a restart of
             "sha256": "1c29...",               that program's fingerprint
             "line": 43}}                       its first line that is not certainly cut; 0 where there is none
    {"job": null}                               every job was cut to its end
    {"refused": {...}}                          as `error_to_json`; the process lives on

Reading the path of a long program takes long, which is why no window does it itself.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper.control.journal.store import latest_unfinished, unfinished_at
from CNCStepper.control.journal.summary import begun_as, check_ended, summary_of, why_no_line
from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.workers.json_lines import Questions, serve, tell

if TYPE_CHECKING:
    from CNCStepper.control.journal.progress_interval import ProgressInterval
    from CNCStepper.control.journal.replay import JobReplay


def main() -> int:
    """Answer what standard input asks; return the exit status."""

    def answer(questions: Questions) -> None:
        while True:
            tell(answered(questions.get()))

    return serve(answer, "unfinished-fault", "the reading of the last job")


def answered(question: dict[str, Any]) -> dict[str, Any]:
    """Return the answer to a question, refused ones too."""
    from CNCStepper.control.session.status import error_to_json

    try:
        return {"job": _job(**question)}
    except CNCStepperError as error:
        return {"refused": error_to_json(error)}


def unfinished(port: str) -> JobReplay | None:
    """Return the last job of the machine at a port where it did not end; of any machine without a port."""
    return unfinished_at(port) if port else latest_unfinished()


def job_summary(story: JobReplay, reached: ProgressInterval | None = None) -> Iterator[tuple[str, str]]:
    """Yield what is known of a job: a short name, and the words."""
    yield from begun_as(story)
    yield from summary_of(story, reached)
    if story.first_program and not why_no_line(story):
        yield (
            "restart",
            Text(
                "it was a restart itself: the first line not certainly cut is the program's {story}",
                story=line_of(story),
            ),
        )
    if why_not := why_no_line(story):
        yield "restart", why_not


def line_of(story: JobReplay) -> int:
    """Return the program's first line that is not certainly cut; 0 where the job names none."""
    _, _, line, _ = story.restarted
    return 0 if why_no_line(story) else line


def reached_in(story: JobReplay, programs: Sequence[str]) -> ProgressInterval | None:
    """Return where on its path a job was; None where its program is in none of these files, nor in its own."""
    from CNCStepper.control.journal.progress_interval import progress_interval
    from CNCStepper.control.journal.replay import text_sent

    text = text_sent(story, _texts(programs)) if story.first_line else None
    return None if text is None else progress_interval(story, text)


def _job(port: str, programs: Sequence[str]) -> dict[str, Any] | None:
    story = unfinished(port)
    if story is None:
        return None
    check_ended(story)
    file, sha256, _, _ = story.restarted
    return {
        "told": list(job_summary(story, reached_in(story, programs))),
        "file": file,
        "sha256": sha256,
        "line": line_of(story),
    }


def _texts(files: Sequence[str]) -> Iterator[str]:
    for file in files:
        with suppress(FileNotFoundError):  # its document was closed meanwhile
            yield Path(file).read_bytes().decode("utf-8")


if __name__ == "__main__":
    sys.exit(main())
