# SPDX-License-Identifier: LGPL-2.1-or-later
"""The seven steps of the tour, and which of them is next by what a person has done: no Qt, no FreeCAD.

Nobody is led by the hand: a step is done when it is seen to be done, by whatever way, and those before it then are no
longer waited for.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from CNCStepper.workbench.services.translation import later

JOB, DRAWING, OPERATION, SIMULATION, CONNECTION, CUT, DONE = (
    "job",
    "drawing",
    "operation",
    "simulation",
    "connection",
    "cut",
    "done",
)


@dataclass(frozen=True)
class Step:
    """A step: its key, title and text, and the command whose button stands beside it ("": none)."""

    key: str
    title: str
    text: str
    command: str = ""


STEPS = (
    Step(
        JOB,
        later("Job"),
        later("Make a job: it holds the machine, the size of the stock and the tools. OK takes what is proposed."),
        "CNCStepper_NewJob",
    ),
    Step(
        DRAWING,
        later("Drawing"),
        later(
            "Draw what is to be cut: a text, a shape, a sketch, a freehand line, or import a drawing. OK when it fits."
        ),
        "CNCStepper_Text",
    ),
    Step(
        OPERATION,
        later("Operation"),
        later(
            "Select the drawing in the tree, then choose how it is cut: engrave it, clear it as a pocket, or cut along "
            "its contour. OK when the depth is right."
        ),
        "CNCStepper_Engrave",
    ),
    Step(
        SIMULATION,
        later("Simulation"),
        later("Look at the cut part before it is cut, and at what the checks have found. Then close the panel."),
        "CNCStepper_Simulate",
    ),
    Step(
        CONNECTION,
        later("Connection"),
        later("Send it. Leave the port on 'Virtual grbl (no machine)' and press Connect: nothing can break."),
        "CNCStepper_Send",
    ),
    Step(
        CUT,
        later("Cut"),
        later("Answer the question for the work zero with Start. On the virtual machine the path is free."),
    ),
    Step(DONE, later("Done"), later("Watch it cut. Hold stops the feed and Resume goes on; Stop ends it.")),
)
END = later("Your first part is cut. A real machine goes the same road: set it up under Machines first.")


class Tour:
    """How far a person is; `place` counts the steps that are done."""

    def __init__(self) -> None:
        self.place = 0

    @property
    def step(self) -> Step | None:
        """The step that is next, None at the end."""
        return STEPS[self.place] if self.place < len(STEPS) else None

    def look(self, seen: Collection[str]) -> bool:
        """Take the keys of what is seen now; return whether the tour goes on by it. It never goes back."""
        reached = max((number for number, step in enumerate(STEPS, 1) if step.key in seen), default=0)
        if reached <= self.place:
            return False
        self.place = reached
        return True
