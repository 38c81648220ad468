# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that cuts operations and writes programs for the panels: `python -m CNCStepper.workers.cycle_cutting`.

It knows nothing of FreeCAD. Each line on standard input is a question in JSON; a newer one ends the work on the one
before. Each line on standard output is about the newest:

    {"mark": 3, "compiled": true, "parts": {KEY: PART, ...}}      what is asked; compiled: kernels may be compiled

    {"begun": 3}                                                  before anything else
    {"stage": "fit"}   {"stage": "cut"}   {"stage": "write"}      what is being done
    {"key": KEY, "answer": {"fits": {key: [xy, bulge], ...}}}             of a PART {"fit": lines, "tolerance_mm": 0.01}
    {"key": KEY, "answer": {"figures": {...}, "warnings": [...]}}         of a PART {"cut": job, "machine": machine}:
                                                                          the first operation of the job
    {"key": KEY, "answer": {"time_s": 12.5}}                              of a PART {"time_of": a PART that cuts}: the
                                                                          planned time of what it cuts
    {"key": KEY, "answer": {"texts": [[name, text]], "paths": [text]}}    of a PART {"program": job, "machine": machine,
                                                                          "title": text}: paths are for FreeCAD's Path
    {"key": KEY, "answer": {"figures" ... or "texts" ...}}               of a PART {"turned_cut": job} or
                                                                          {"turned_program": job, "title": text}: a
                                                                          lathe's, as job/turning/turning_transfer.py
    {"key": KEY, "answer": {"written": path}}                             of a PART {"sheet": {...}, "of": a PART of a
                                                                          program}: job/files/program_sheet.py
    {"key": KEY, "answer": {"curves": {...}}}                             of a PART {"text": form, "folder": path}:
                                                                          columns, job/drawings/imported_drawing.py
    {"key": KEY, "answer": {"error": {...}}}                      of a part that is refused
    {"done": 3}                                                   when all parts are answered

When standard input is closed the process ends.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from contextlib import nullcontext
from pathlib import Path
from typing import Any

from CNCStepper.cancellation import interruptible
from CNCStepper.workers.json_lines import NewestQuestion, Outdated, Questions, Work, serve, tell

CUTTING = Work("cut", "the cut", "use larger steps or a smaller depth")
MOST_CUTS = 16  # kept: a program is asked for after its operations


def main() -> int:
    """Answer what standard input asks; return the exit status."""
    return serve(lambda questions: Answers(questions).run(), "cut-fault", CUTTING.doing)


class Answers:
    """The newest question and the cuts that were made last."""

    def __init__(self, questions: Questions):
        self._newest = NewestQuestion(questions)
        self._cuts: list[Any] = []

    def run(self) -> None:
        """Answer for ever."""
        while True:
            question = self._newest.wait()
            try:
                self._answer(question)
            except Outdated:
                continue

    def _answer(self, question: dict[str, Any]) -> None:
        from CNCStepper.kernels import uncompiled

        tell({"begun": question["mark"]})
        slowly = nullcontext() if question["compiled"] else uncompiled(self._newest.look)
        with interruptible(self._newest.look), slowly:
            for key, part in question["parts"].items():
                tell({"key": key, "answer": self._part(part)})
        tell({"done": question["mark"]})

    def _part(self, part: dict[str, Any]) -> dict[str, Any]:
        try:
            work: dict[str, Callable[[dict[str, Any]], dict[str, Any]]] = {
                "fit": self._fits,
                "cut": self._cut,
                "time_of": self._time,
                "sheet": self._sheet,
                "text": self._text,
                "program": self._programs,
                "turned_cut": self._turned_cut,
                "turned_program": self._turned_programs,
            }
            return next(work[key] for key in work if key in part)(part)
        except Outdated:
            raise
        except Exception as error:  # a fault of ours still has to reach the person who waits
            return {"error": CUTTING.refused(error)}

    def _fits(self, part: dict[str, Any]) -> dict[str, Any]:
        from CNCStepper.job.curve_fit_cache import answer_to

        tell({"stage": "fit"})
        return answer_to(part)

    def _text(self, part: dict[str, Any]) -> dict[str, Any]:
        from CNCStepper.job.drawings.packed_curves import packed_curves
        from CNCStepper.job.shape_forms.text_form import TextForm

        tell({"stage": "fit"})
        return {"curves": packed_curves(TextForm.model_validate(part["text"]).curves(Path(part["folder"])))}

    def _cut(self, part: dict[str, Any]) -> dict[str, Any]:
        answer = self._first_cut(part).answer
        return {"figures": answer.figures, "warnings": answer.warnings}

    def _time(self, part: dict[str, Any]) -> dict[str, Any]:
        from CNCStepper.job.cut_transfer import machine_from
        from CNCStepper.job.turning.turning_transfer import job_from, last_time_s

        asked = part["time_of"]
        if "turned_cut" in asked:
            return {"time_s": last_time_s(*job_from(asked["turned_cut"]))}
        return {"time_s": self._first_cut(asked).time_s(machine_from(asked["machine"]))}

    def _sheet(self, part: dict[str, Any]) -> dict[str, Any]:
        from CNCStepper.job.cut_transfer import job_from, machine_from
        from CNCStepper.job.files.program_sheet import write_program_sheet

        tell({"stage": "write"})
        if "turned_program" in part["of"]:
            return self._turned_sheet(part)
        machine = machine_from(part["of"]["machine"])
        job = job_from(part["of"]["program"], part["of"]["machine"])
        times_s = [self._cut_once(cycle, job.setup(cycle)).time_s(machine) for cycle in job.operation]
        return {"written": write_program_sheet(part["sheet"], job, machine, times_s)}

    def _first_cut(self, part: dict[str, Any]) -> Any:
        """Return the cut of the first operation of the job that a part has."""
        from CNCStepper.job.cut_transfer import setting_from

        tell({"stage": "cut"})
        job = setting_from(part["cut"], part["machine"])
        cycle = job.operation[0]
        return self._cut_once(cycle, job.setup(cycle))

    def _programs(self, part: dict[str, Any]) -> dict[str, Any]:
        from CNCStepper.job.cut_transfer import job_from, machine_from, path_text, program_texts

        tell({"stage": "cut"})
        machine = machine_from(part["machine"])
        job = job_from(part["program"], part["machine"])
        ready = tuple(self._cut_once(cycle, job.setup(cycle)) for cycle in job.operation)
        tell({"stage": "write"})
        texts = program_texts(job.model_copy(update={"operation": ready}), machine, part["title"])
        paths = [path_text(job, machine, text, part["title"]) for _, text in texts]
        return {"texts": texts, "paths": paths}

    def _turned_cut(self, part: dict[str, Any]) -> dict[str, Any]:
        from CNCStepper.job.turning.turning_transfer import job_from, last_cut

        tell({"stage": "cut"})
        figures, warnings = last_cut(*job_from(part["turned_cut"]))
        return {"figures": figures, "warnings": warnings}

    def _turned_programs(self, part: dict[str, Any]) -> dict[str, Any]:
        from CNCStepper.job.turning.turning_transfer import job_from, path_text, program_texts

        tell({"stage": "write"})
        job, machine = job_from(part["turned_program"])
        texts = program_texts(job, machine, part["title"])
        return {"texts": texts, "paths": [path_text(job, machine, text, part["title"]) for _, text in texts]}

    def _turned_sheet(self, part: dict[str, Any]) -> dict[str, Any]:
        from CNCStepper.job.files.program_sheet import write_turned_sheet
        from CNCStepper.job.turning.turning_transfer import job_from

        return {"written": write_turned_sheet(part["sheet"], *job_from(part["of"]["turned_program"]))}

    def _cut_once(self, cycle: Any, setup: Any) -> Any:
        from CNCStepper.job.cycle_cache import CycleCache

        found = next((cut for cut in self._cuts if cut.fits(cycle, setup)), None)
        if found is None:
            found = CycleCache(cycle, setup)
            self._cuts = [*self._cuts[1 - MOST_CUTS :], found]
        return found


if __name__ == "__main__":
    sys.exit(main())
