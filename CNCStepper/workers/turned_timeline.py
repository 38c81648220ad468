# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process of a lathe's simulation timeline: `python -m CNCStepper.workers.turned_timeline FOLDER NAME`.

FOLDER is one in which the proof of a lathe's program was answered (`job/turning/turning_proof_folder.py`), NAME the
program's. Each line on standard input asks for one thing, in JSON; each is answered by one line on standard output:

    {"at": time_s, "open_deg": 90, "z_mm": -20}   {"at": time_s, "groups": [[name, points, strips], ...],
                                                   "diameter_mm": 24, "bore_mm": 0}   the groups: faces.bin
    {"mesh": time_s}                              {"at": time_s, "mesh": "part.stl"}  in FOLDER
    what cannot be answered                       {"error": {...}}, and the process ends with exit status 1

z_mm null: no diameter is asked for. Chuck, jaws and tailstock are among the groups when open_deg has changed; tools,
and "operations_s" (when each operation ends), are in the first answer.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from CNCStepper.workers.json_lines import Questions, serve, tell


def main(arguments: list[str]) -> int:
    """Answer what standard input asks of the folder `arguments[0]`; return the exit status."""

    def answer(questions: Questions) -> None:
        answers = Answers(Path(arguments[0]), arguments[1])
        while True:
            tell(answers.to(questions.get()))

    return serve(answer, "timeline-fault", "the timeline")


class Answers:
    """The timeline of a proven program and the answers sent about it."""

    def __init__(self, folder: Path, name: str):
        from CNCStepper.job.proof_folder import read_program
        from CNCStepper.job.start_state_file import read_start
        from CNCStepper.job.turning.turned_view import timeline_of
        from CNCStepper.job.turning.turning_proof_folder import prove_question

        program, machine = read_program(folder)
        self._folder = folder
        self._proven = prove_question(folder, program, machine, name, read_start(folder))
        self._timeline = timeline_of(self._proven)
        self._open_deg: float | None = None

    def to(self, question: dict[str, Any]) -> dict[str, Any]:
        """Return the answer to a question; raises CNCStepperError."""
        return self._mesh(question["mesh"]) if "mesh" in question else self._at(**question)

    def _at(self, at: float, open_deg: float, z_mm: float | None) -> dict[str, Any]:
        from CNCStepper.job.turning.turned_groups_file import write_groups
        from CNCStepper.job.turning.turned_view import fixture_groups, operation_ends_s, part_groups, tool_groups

        moment, setup = self._timeline.at(at), self._proven.verdict.setup
        groups, more = part_groups(self._timeline, moment, open_deg), {}
        if self._open_deg is None:
            groups |= tool_groups(setup.tools)
            more["operations_s"] = operation_ends_s(self._proven)
        if open_deg != self._open_deg:
            groups |= fixture_groups(setup, open_deg)
            self._open_deg = open_deg
        section = moment.section
        read = (section.diameter_mm(z_mm), section.bore_mm(z_mm)) if z_mm is not None else (None, None)
        sizes = write_groups(self._folder, groups)
        return {"at": at, "groups": sizes, "diameter_mm": read[0], "bore_mm": read[1], **more}

    def _mesh(self, time_s: float) -> dict[str, Any]:
        from CNCStepper.job.proof_folder import MESH
        from CNCStepper.simulation.meshes.turned_mesh import turned_mesh

        turned_mesh(self._timeline.at(time_s).section).save_stl(self._folder / MESH)
        return {"at": time_s, "mesh": MESH}


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
