# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process of a lathe's simulation timeline: `python -m CNCStepper.workers.turned_timeline FOLDER NAME`.

FOLDER is one in which the proof of a lathe's program was answered (`job/turning/turned_proof_folder.py`), NAME the
program's. Each line on standard input asks for one thing, in JSON; each is answered by one line on standard output:

    {"at": time_s, "open_deg": 90, "z_mm": -20}   {"at": time_s, "groups": [[name, points, strips], ...],
                                                   "diameter_mm": 24, "bore_mm": 0}   the groups: faces.bin
    {"mesh": time_s}                              {"at": time_s, "mesh": "part.stl"}  in FOLDER
    what cannot be answered                       {"error": {...}}, and the process ends with exit status 1

z_mm null: no diameter is asked for. Chuck, jaws and tailstock are among the groups when open_deg has changed.
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
        from CNCStepper.job.start_state_file import read_start
        from CNCStepper.job.turning.prove_turning import prove_one
        from CNCStepper.job.turning.turned_proof_folder import read_turned_question
        from CNCStepper.job.turning.turned_view import timeline_of

        program, job, machine = read_turned_question(folder)
        self._folder = folder
        proven = prove_one(job, machine, program, name, read_start(folder))
        self._obstacles = proven.verdict.setup.obstacles
        self._timeline = timeline_of(proven)
        self._open_deg: float | None = None

    def to(self, question: dict[str, Any]) -> dict[str, Any]:
        """Return the answer to a question; raises CNCStepperError."""
        return self._mesh(question["mesh"]) if "mesh" in question else self._at(**question)

    def _at(self, at: float, open_deg: float, z_mm: float | None) -> dict[str, Any]:
        from CNCStepper.job.turning.turned_proof_folder import write_groups
        from CNCStepper.job.turning.turned_view import fixture_groups, part_groups

        moment = self._timeline.at(at)
        groups = part_groups(self._timeline, moment, open_deg)
        if open_deg != self._open_deg:
            groups |= fixture_groups(self._obstacles, open_deg)
            self._open_deg = open_deg
        answer = {"at": at, "groups": write_groups(self._folder, groups), "diameter_mm": None, "bore_mm": None}
        if z_mm is not None:
            section = moment.section
            answer |= {"diameter_mm": section.diameter_mm(z_mm), "bore_mm": section.bore_mm(z_mm)}
        return answer

    def _mesh(self, time_s: float) -> dict[str, Any]:
        from CNCStepper.job.proof_folder import MESH
        from CNCStepper.simulation.meshes.turned_mesh import turned_mesh

        turned_mesh(self._timeline.at(time_s).section).save_stl(self._folder / MESH)
        return {"at": time_s, "mesh": MESH}


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
