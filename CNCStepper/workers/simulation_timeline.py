# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process of the simulation timeline: `python -m CNCStepper.workers.simulation_timeline FOLDER`.

FOLDER is one in which a proof was answered (`proof_folder`). Each line on standard input asks for one thing, in JSON;
each is answered by one line on standard output, in the same order:

    {"at": time_s}                    {"at": time_s, "tiles": [[number, faces], ...]}    the faces: tiles.bin
    {"pulse": time_s, "sense": 1}     {"pulse": time_s, "steps": [x, y, z]}, both null where no pulse follows
    {"mesh": time_s}                  {"at": time_s, "mesh": "part.stl"}                 in FOLDER
    what cannot be answered           {"error": {...}}, and the process ends with exit status 1

tiles.bin holds the corners of all faces and then their colours (`coloured_faces.DrawnFaces`), of those tiles alone that
differ from the last answer's; at first that is every tile. It is written before its line, and not again before the
next question. When standard input is closed nobody asks any more, and the process ends at once.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.workers.json_lines import Questions, serve, tell


def main(arguments: list[str]) -> int:
    """Answer what standard input asks of the folder `arguments[0]`; return the exit status."""

    def answer(questions: Questions) -> None:
        answers = Answers(Path(arguments[0]))
        while True:
            tell(answers.to(questions.get()))

    return serve(answer, "timeline-fault", "the timeline")


class Answers:
    """The timeline of a proven program and the answers sent about it."""

    def __init__(self, folder: Path):
        from CNCStepper.simulation.meshes.changed_tiles import ChangedTiles
        from CNCStepper.simulation.meshes.mesh_faces import step_of
        from CNCStepper.simulation.views.coloured_faces import height_range_mm

        self._folder = folder
        self._timeline = _timeline(folder)
        finished = self._timeline.at(self._timeline.duration_s)
        self._range_mm = height_range_mm(finished)
        self._relief = ChangedTiles(finished.part.grid, step_of(finished))
        self._told_all = False

    def to(self, question: dict[str, Any]) -> dict[str, Any]:
        """Return the answer to a question; raises CNCStepperError."""
        asked: dict[str, Callable[..., dict[str, Any]]] = {"at": self._at, "pulse": self._pulse, "mesh": self._mesh}
        for kind, answer in asked.items():
            if kind in question:
                return answer(float(question[kind]), **{k: v for k, v in question.items() if k != kind})
        what, advice = "nothing is known that could be asked so", Text("use one of: {known}", known=", ".join(asked))
        raise CNCStepperError("timeline-question", what, value=str(question), advice=advice)

    def _at(self, time_s: float) -> dict[str, Any]:
        from CNCStepper.job.proof_folder import TILES
        from CNCStepper.simulation.views.coloured_faces import drawn

        changed = self._relief.take(self._timeline.at(time_s).part)
        numbers = changed if self._told_all else range(len(self._relief))
        self._told_all = True
        tiles = [drawn(self._relief.faces(number), self._range_mm) for number in numbers]
        with (self._folder / TILES).open("wb") as file:
            file.writelines(array.tobytes() for arrays in zip(*tiles, strict=True) for array in arrays)
        return {"at": time_s, "tiles": [[number, len(tile.rgba)] for number, tile in zip(numbers, tiles, strict=True)]}

    def _pulse(self, time_s: float, sense: int) -> dict[str, Any]:
        timeline = self._timeline
        pulse = timeline.next_pulse(time_s) if sense > 0 else timeline.pulse_before(time_s)
        return {"pulse": pulse and pulse.time_s, "steps": pulse and list(pulse.position_steps)}

    def _mesh(self, time_s: float) -> dict[str, Any]:
        from CNCStepper.job.proof_folder import MESH
        from CNCStepper.simulation.meshes.stl_mesh import mesh_of

        mesh_of(self._timeline.at(time_s)).save_stl(self._folder / MESH)
        return {"at": time_s, "mesh": MESH}


def _timeline(folder: Path) -> Any:
    from CNCStepper.job.proof_folder import MOVES, proven_file, read_dialect, read_question
    from CNCStepper.job.start_state_file import read_start
    from CNCStepper.job.wire_round_trip import wire_round_trip
    from CNCStepper.simulation.removal.timeline import Timeline
    from CNCStepper.simulation.tip_track import TipTrack

    program, job, machine = read_question(folder)
    start, file = job.started(read_start(folder), machine), proven_file(folder)
    _, motors, toolpath = wire_round_trip(program, machine, read_dialect(folder) or machine.language(), file, start)
    ends_s = TipTrack.load(folder / MOVES).ends_s
    return Timeline(toolpath, ends_s, job.tools, job.stock.stock(), machine=machine, motors=motors)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
