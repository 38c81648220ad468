# SPDX-License-Identifier: LGPL-2.1-or-later
"""The material where the player stands: the tool moves on at once, the material follows as soon as it is known.

At the end of the program the finished part is shown, the one that was proven, and nothing is asked.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from PySide import QtCore

from CNCStepper.workbench.services import messages
from CNCStepper.workbench.simulation.player import Player
from CNCStepper.workbench.simulation.timeline_client import Tiles, TimelineClient

if TYPE_CHECKING:
    from CNCStepper.workbench.proving.proof_process import ProofResult
    from CNCStepper.workbench.simulation.scene import Scene

AT_ONCE_S = 0.01  # of one turn of the window's events


class Material(QtCore.QObject):
    """Shows the remaining stock in the scene; `end` ends it. shown: sent when the scene shows an asked moment."""

    shown = QtCore.Signal()

    def __init__(self, player: Player, scene: Scene, result: ProofResult, parent: Any = None):
        super().__init__(parent)
        self._player, self._scene = player, scene
        self.moments = TimelineClient(result, self)
        self.moments.tiles.connect(messages.guarded(self._take))
        self.moments.pulse.connect(messages.guarded(self._go_to_pulse))
        self.moments.failed.connect(messages.guarded(self._fall_back))
        self._pulses: list[int] = []  # the senses of the steps that are still to be made
        self._bits: Iterator[None] = iter(())
        self._loader = QtCore.QTimer(self)
        self._loader.setInterval(0)
        self._loader.timeout.connect(messages.guarded(self._load_on))
        player.moved.connect(messages.guarded(self.follow))
        player.pulse_wanted.connect(messages.guarded(self._want_pulse))
        self.moments.want(0.0)  # so that all tiles are there when a person begins to play

    @property
    def waiting(self) -> bool:
        """Whether the scene still shows another moment."""
        return self.moments.waiting or self._loader.isActive()

    def follow(self) -> None:
        """Show the material where the player stands."""
        if self._player.at_end:
            self._scene.show_finished()
        else:
            self.moments.want(self._player.time_s)

    def end(self) -> None:
        """Ask and show nothing any more."""
        self._loader.stop()
        self._pulses.clear()
        self.moments.end()

    def _take(self, tiles: Tiles) -> None:
        self._bits = self._scene.change_tiles(tiles)
        self._loader.start()

    def _load_on(self) -> None:
        """Bring in what can be brought in at once; when all is there, show it and ask on."""
        begun_s = time.perf_counter()
        while next(self._bits, self) is None:
            if time.perf_counter() - begun_s > AT_ONCE_S:
                return
        self._loader.stop()
        if not self._player.at_end:
            self._scene.show_tiles()
        self.moments.go_on()
        self.shown.emit()

    def _fall_back(self) -> None:
        """Show what is known without the process."""
        self._pulses.clear()
        self._scene.show_finished()

    def _want_pulse(self, sense: int) -> None:
        self._pulses.append(sense)
        if len(self._pulses) == 1:
            self.moments.want_pulse(self._player.time_s, sense)

    def _go_to_pulse(self, time_s: float | None, steps: list[int] | None) -> None:
        """Let the player stand at a pulse, and step on from there as often as was asked meanwhile."""
        if time_s is None or steps is None:
            self._pulses.clear()
        else:
            self._pulses = self._pulses[1:]
            self._player.seek(time_s, steps)
        if self._pulses:
            self.moments.want_pulse(self._player.time_s, self._pulses[0])
        self.moments.go_on()
