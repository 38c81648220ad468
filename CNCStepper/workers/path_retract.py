# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that leads a held job back along its cut for a window: `python -m CNCStepper.workers.path_retract`.

Each line on standard input asks for one thing, in JSON, of the job that the service of the file "service" runs; each is
answered by one line on standard output, in the same order:

    {"service": FILE, "find": true}         where on its cut the tool stands; nothing moves
    {"service": FILE, "back_mm": 5.0}       held where it moves, then back by so much, and proven before
    {"service": FILE, "line": 42}           back to where line 42 of the program begins
    {"service": FILE, "entry": true}        back to the last entry into the work
    {"service": FILE, "forward_mm": 2.0}    forward again, as far as the program was cut at most
    {"service": FILE, "aside": true}        nowhere, outputs off: after it the machine can be jogged
    {"service": FILE, "resume": true}       cut from here to the program's end

    {"line": 12, "behind_mm": 5.0, "doubt": ""}     the tool stands there; doubt: what to say of the place, if anything
    {"resumed": true}                               the job goes on
    {"refused": {...}}                              as `error_to_json`; the process lives on

When standard input is closed nobody asks any more, and the process ends at once; the machine goes on to where it goes.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError, JobError, Text
from CNCStepper.workers.json_lines import Questions, serve, tell


def main() -> int:
    """Answer what standard input asks; return the exit status."""

    def answer(questions: Questions) -> None:
        while True:
            tell(answered(questions.get()))

    return serve(answer, "back-fault", "the retract along the cut")


def answered(question: dict[str, Any]) -> dict[str, Any]:
    """Return the answer to a question, refused ones too."""
    from CNCStepper.control.session.status import error_to_json

    try:
        return _answer(**question)
    except CNCStepperError as error:
        return {"refused": error_to_json(error)}


def _answer(service: str, **request: Any) -> dict[str, Any]:
    from CNCStepper.control.service.connection_session import ConnectionSession
    from CNCStepper.recovery.retract.retract_client import RetractClient

    with ConnectionSession.attach(Path(service)) as session:
        back = RetractClient(session)
        if "find" in request:
            return _place(back.held())
        back.hold()
        held = back.held()
        if "resume" in request:
            back.go(held.rest())
            return {"resumed": True}
        back.go(held.aside() if "aside" in request else held.along(_target(held, **request)))
        back.wait_for_leg()
        return _place(back.held())


def _target(held: Any, **request: Any) -> Any:
    """Return the requested place."""
    ways: dict[str, Callable[[Any], Any]] = {
        "back_mm": held.back_by,
        "line": held.back_to_line,
        "entry": lambda _: held.back_to_entry(),
        "forward_mm": held.forward_by,
    }
    for kind, way in ways.items():
        if kind in request:
            return way(request[kind])
    advice = Text("use one of: {known}", known=", ".join(ways))
    raise JobError("back-question", "nothing is known that could be asked so", value=str(request), advice=advice)


def _place(held: Any) -> dict[str, Any]:
    return {"line": held.file_line(held.place), "behind_mm": held.behind_mm, "doubt": held.doubt}


if __name__ == "__main__":
    sys.exit(main())
