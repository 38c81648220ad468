# SPDX-License-Identifier: LGPL-2.1-or-later
"""The worker of the program editor, in the process of the test."""

from __future__ import annotations

from pathlib import Path
from queue import SimpleQueue
from typing import Any

from CNCStepper.machine.profile import load_machine
from CNCStepper.workers.program_editor import Answers

TEXT = "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F200\nG1 X40\nG2 X60 Y20 J20\nG1 X\nG0 Z5 (up)\nM2\n"


class Here:
    """The worker in this process, asked and heard in turn."""

    def __init__(self, folder: Path, text: str = TEXT):
        (folder / "machine.json").write_text(load_machine("table-a").model_dump_json(), encoding="utf-8")
        (folder / "program.nc").write_text(text, encoding="utf-8")
        self.questions: SimpleQueue[dict[str, Any]] = SimpleQueue()
        self.told: list[dict[str, Any]] = []
        self.answers = Answers(folder, self.questions, self.told.append)
        self.folder = folder
        self.put({"as": {"dialect": "grbl", "file": "", "machine": True}}, {"text": "program.nc", "mark": 1})

    def put(self, *questions: dict[str, Any]) -> None:
        for question in questions:
            self.questions.put(question)

    def on_message(self, steps: int = 1) -> list[dict[str, Any]]:
        """Let it work and return what it told meanwhile."""
        self.told.clear()
        for _ in range(steps):
            self.answers.step()
        return list(self.told)
