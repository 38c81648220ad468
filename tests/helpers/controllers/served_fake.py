# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process of a controller whose output is a fake one, played in real time: MACHINE PORT as the real process.

PORT "missing" cannot be had. Another one is a file that gets, at the end, what came of the pulses, as JSON.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from CNCStepper.controllers import families
from CNCStepper.controllers.families import ServedBoard
from CNCStepper.errors import LinkError
from CNCStepper.machine.profile import Machine
from CNCStepper.workers import controller
from helpers.controllers.simulated_board import SimulatedBoard


class _Board(SimulatedBoard):
    def __init__(self, machine: Machine, port: str):
        super().__init__(machine)
        self._file = Path(port)

    def close(self) -> None:
        moving = not self.at_rest
        super().close()
        told = {"place": self.output.position_steps, "commands": [what for _, what in self.output.commands]}
        self._file.write_text(json.dumps(told | {"moving": moving, "on": sorted(self.output.on)}), "utf-8")


def _open(machine: Machine, port: str) -> ServedBoard:
    if port == "missing":
        raise LinkError("port-missing", "there is no port missing", advice="plug it in")
    return _Board(machine, port)


if __name__ == "__main__":
    families.FACTORIES["parport"] = _open
    sys.exit(controller.main(sys.argv[1:]))
