# SPDX-License-Identifier: LGPL-2.1-or-later
"""The clock of a simulation: it plays a track of the tip, and seeks to a time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from PySide import QtCore

if TYPE_CHECKING:
    import numpy as np

    from CNCStepper.simulation.tip_track import TipTrack

TICK_MS = 33
MS_PER_S = 1000.0
LINE, MOVE, PULSE, OPERATION = "line", "move", "pulse", "operation"  # what is stepped by


class Player(QtCore.QObject):
    """Where the simulation stands: `time_s`, and `row`, the move under way; at a pulse also the motors' `steps`.

    moved: sent whenever that changes. playing_changed: sent with whether it plays. pulse_wanted: sent with 1 or -1
    to have it stepped to the next pulse or the one before, which the planner alone knows.
    """

    moved = QtCore.Signal()
    pulse_wanted = QtCore.Signal(int)
    playing_changed = QtCore.Signal(bool)

    def __init__(self, moves: TipTrack, parent: Any = None):
        super().__init__(parent)
        self.moves = moves
        self.speed = 1.0
        self.time_s = 0.0
        self.row = 0
        self.steps: tuple[int, ...] = ()
        self.operations_s: Sequence[float] = ()  # when each operation ends, where that is known
        self._passed = QtCore.QElapsedTimer()
        self._timer = QtCore.QTimer(self)
        self._timer.setTimerType(QtCore.Qt.TimerType.PreciseTimer)
        self._timer.setInterval(TICK_MS)
        self._timer.timeout.connect(self._tick)

    @property
    def playing(self) -> bool:
        """Whether time passes."""
        return self._timer.isActive()

    @property
    def line(self) -> int:
        """The line of the program that moves the tool now, from 1; 0 for a program that moves nothing."""
        return int(self.moves.line[self.row]) if len(self.moves) else 0

    def tip_mm(self) -> np.ndarray:
        """Return where the tip is, work coordinates, NaN where it is not known."""
        return self.moves.tip_mm(self.row, self.moves.share_at(self.row, self.time_s))

    def play(self) -> None:
        """Let time pass, from the begin when the end is reached."""
        if not len(self.moves) or self.playing:
            return
        if self.at_end:
            self.seek(0.0)
        self._passed.start()
        self._timer.start()
        self.playing_changed.emit(True)

    def pause(self) -> None:
        """Let time stand still."""
        if self.playing:
            self._timer.stop()
            self.playing_changed.emit(False)

    @property
    def at_end(self) -> bool:
        """Whether the program is done."""
        return self.time_s >= self.moves.duration_s

    def seek(self, time_s: float, steps: Sequence[int] = ()) -> None:
        """Jump to a moment; steps: where the motors stand then, if it is that of a pulse."""
        self.steps = tuple(steps)
        if len(self.moves):
            self.time_s = min(max(time_s, 0.0), self.moves.duration_s)
            self.row = self.moves.row_at(self.time_s)
        self.moved.emit()

    def stand_at_end(self) -> None:
        """Show the end of the program first, or what a person has chosen while all was brought in."""
        if self.time_s:
            self.moved.emit()
        else:
            self.seek(self.moves.duration_s)

    def go_to_row(self, row: int) -> None:
        """Jump to where a move ends."""
        self.steps = ()
        if len(self.moves):
            self.row = row
            self.time_s = float(self.moves.ends_s[row])
        self.moved.emit()

    def go_to_line(self, line: int) -> None:
        """Jump to where a line of the program has taken the tool."""
        if len(self.moves):
            self.go_to_row(self.moves.row_of_line(line))

    def step(self, sense: int, by: str) -> None:
        """Jump to the next (1) end of a line, move or operation, or to the one before (-1); a pulse is asked for."""
        self.pause()
        if by == PULSE:
            self.pulse_wanted.emit(sense)
            return
        if by == OPERATION:
            self._step_by_operation(sense)
            return
        step = self.moves.next_s if sense > 0 else self.moves.before_s
        self.seek(step(self.time_s, by == LINE))

    def _step_by_operation(self, sense: int) -> None:
        ends_s = [0.0, *self.operations_s, self.moves.duration_s]
        later_s = [end_s for end_s in ends_s if (end_s - self.time_s) * sense > 0]
        self.seek(min(later_s, key=lambda end_s: abs(end_s - self.time_s), default=self.time_s))

    def _tick(self) -> None:
        self.seek(self.time_s + self._passed.restart() / MS_PER_S * self.speed)
        if self.at_end:
            self.pause()
