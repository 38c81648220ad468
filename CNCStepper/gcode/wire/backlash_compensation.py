# SPDX-License-Identifier: LGPL-2.1-or-later
"""Takes up the play of the axes in the wire text, for controllers that do not do it themselves.

    G1X10F300                  G1X10F300         going +
    X4              ->         G1X9.95           X turns back: its motor alone crosses the gap, at the move's feed
                               X3.95             and from there on stands beside the tool
    G2X4Y0I5                   an arc is cut into several where an axis turns back

The motors cross the gap no faster than the move goes that follows: where the gap is smaller than was told, or the tool
stands elsewhere than was thought, it moves, and in the work. Only a laser's do so as a rapid, in which its beam is off.
F stays what it was. Words keep their numbers where the motor stands where the tool does, and in incremental moves.
Before a place is stored or named (G92, G10, G28.1, G30.1) the motors go back into the gap, to where the tool stands.
Places of the machine (G28, G30, G53) are gone to as they are written (`backlash_machine_moves.py`). Probes are
refused: where they
end is not known.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Sequence
from math import isnan

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.state.model import Model
from CNCStepper.gcode.syntax.words import Word, words_of
from CNCStepper.gcode.wire.backlash_machine_moves import AsWritten
from CNCStepper.gcode.wire.backlash_words import AXES, Words, crossing
from CNCStepper.gcode.wire.monotonic_split import Piece, arc_pieces, straight_pieces
from CNCStepper.gcode.wire.wire_lines import WireLines
from CNCStepper.gcode.wire.wire_text import WireText, check_wire_line
from CNCStepper.machine.backlash import SAME_MM, Backlash, Motors
from CNCStepper.machine.profile import Machine
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, LINE, RAPID, Chunk

OF_MACHINE = frozenset(("G28", "G30", "G53"))
NAMES_PLACE = frozenset(("G92", "G10", "G28.1", "G30.1"))
TAKES_AXES = frozenset(("G4", "G43", "G43.1", "G43.2", "G52"))  # whose axis words are no move's


def backlash_of(machine: Machine | None, dialect: str | Dialect) -> Backlash | None:
    """Return the play that a sender must take up on a machine; None where there is none, or its controller does."""
    play = Backlash.of(machine) if machine and not dialect_named(dialect).compensates_backlash else None
    return play or None


class BacklashCompensation:
    """Turns the lines of a program, in their order, into those that are sent."""

    def __init__(self, play: Backlash, dialect: Dialect, start: Start | None, file: str):
        if "records" in dialect.front:
            what = Text("in the language of {dialect} no play can be taken up", dialect=dialect.title)
            advice = "set backlash_mm to 0 in the machine profile"
            raise ProgramError("take-up", what, advice=advice, place=Place(file))
        self._play = play
        self._reader = Interpreter(start, dialect, file)
        self._motors = Motors(play, self._reader.model.position)
        self._as_written = AsWritten(self._motors)
        self._file = file
        self._crossed = ""  # the motion of ours that the wire said last, where the program may know another

    def lines(self, line: str, number: int) -> list[str]:
        """Return the lines sent for a line of the wire text that is line `number` of the file."""
        place = Place(self._file, number)
        before = self._reader.model.copy()
        self._reader.line_at(line, number, place)
        made = self._reader.table.take()
        self._reader.table.forget()
        try:
            return list(self._sent(line, words_of(line), before, made[0] if made else None))
        except ProgramError as error:
            raise error.at(place) from None

    def _sent(self, line: str, words: list[Word], before: Model, rows: Chunk | None) -> Iterator[str]:
        names, after = {word.name for word in words}, self._reader.model
        if names & OF_MACHINE:
            yield from self._to_machine({word.letter for word in words}, before, rows)
            yield self._with_motion(line, names)
        elif names & NAMES_PLACE:
            yield from self._into_the_gap(before)
            yield line
        elif rows is None and (names & TAKES_AXES or not any(word.letter in AXES for word in words)):
            yield line
        elif rows is None or rows.kind[0] in (RAPID, LINE):
            self._check_plain(rows)
            pieces = straight_pieces(self._play, before.position, after.position)
            yield from self._moved(words, before, pieces, None, self._feed_mm_min(rows))
        else:
            yield from self._arc(words, before, rows)

    def _to_machine(self, letters: set[str], before: Model, rows: Chunk | None) -> Iterator[str]:
        """Lead the motors of the named axes, or of all, to where the text says; yield the line that goes before."""
        axes = [axis for axis, letter in enumerate(AXES) if letter in letters] or range(len(AXES))
        places = self._places(axes, before, rows)
        ready_mm = self._as_written.ready_mm(before.position, places[0]) if len(places) == 1 else None
        if ready_mm is not None:
            yield self._crossing(before, self._motors.at_mm, ready_mm, self._feed_mm_min(rows))
            places.insert(0, list(ready_mm))
        self._as_written.go(axes, before.position, places)

    def _places(self, axes: Sequence[int], before: Model, rows: Chunk | None) -> list[list[float]]:
        """Return to which places the motors of some axes go in a line: of G28 and G30 with a point between, to two."""
        after, at_mm = self._reader.model, self._motors.at_mm
        ends = [after.position] if rows is None else rows.end.tolist()
        if len(ends) > 1 and not after.absolute:  # that point is as far from the motors as from the tool
            ends[0] = [at + end - begin for at, end, begin in zip(at_mm, ends[0], before.position, strict=True)]
        return [[end[axis] if axis in axes else at for axis, at in enumerate(at_mm)] for end in ends]

    def _with_motion(self, line: str, names: set[str]) -> str:
        """Return a G53 line with its motion, where a move of ours stands between it and the one that it repeats."""
        if not self._crossed or "G53" not in names or names & {"G0", "G1"}:
            return line
        self._crossed = ""
        return f"{MOTION_NAMES[self._reader.model.motion]}{line}"

    def _into_the_gap(self, model: Model) -> Iterator[str]:
        """Yield the rapid by which the motors go to where the tool stands, which it does not notice."""
        stood = self._motors.at_mm
        here = [stands if isnan(tool) else tool for stands, tool in zip(stood, model.position, strict=True)]
        if any(abs(one - other) > SAME_MM for one, other in zip(stood, here, strict=True)):
            yield self._crossing(model, stood, here, None)
        self._motors.at_mm = here

    def _feed_mm_min(self, rows: Chunk | None) -> float | None:
        """Return at which feed a move's play is taken up; None as a rapid."""
        return None if rows is None or rows.kind[0] == RAPID or self._play.beam else float(rows.feed[0])

    def _crossing(self, model: Model, stood_mm, end_mm, feed_mm_min: float | None) -> str:
        """Return the line by which the motors alone go, and note the motion that it leaves on the wire."""
        line = crossing(model, stood_mm, end_mm, feed_mm_min)
        self._crossed = line[:2]
        return line

    def _check_plain(self, rows: Chunk | None) -> None:
        """Refuse a line that makes more than a plain move."""
        model = self._reader.model
        if model.turn is not None or model.motion > ARC_CCW or (rows is not None and len(rows) > 1):
            what = "the play of the axes cannot be taken up within this line"
            advice = "write plain moves, each in a line of its own, in coordinates that are not turned"
            raise ProgramError("take-up", what, advice=advice)

    def _arc(self, words: list[Word], before: Model, rows: Chunk) -> Iterator[str]:
        """Yield the lines of an arc, which is cut where an axis turns back."""
        self._check_plain(rows)
        after = self._reader.model
        if after.state.arc_centres == "absolute":
            what = "the play of the axes cannot be taken up in an arc with an absolute centre"
            raise ProgramError("take-up", what, advice="give I, J and K from the start point of the arc (G91.1)")
        kind, plane, turns = (int(column[0]) for column in (rows.kind, rows.plane, rows.turns))
        centre = tuple(rows.centre[0].tolist())
        pieces = arc_pieces(self._play, before.position, after.position, centre, kind, plane, turns)
        cut_about = centre if len(pieces) > 1 else None
        yield from self._moved(words, before, pieces, cut_about, self._feed_mm_min(rows))

    def _moved(
        self,
        words: list[Word],
        before: Model,
        pieces: list[Piece],
        centre_mm: tuple[float, ...] | None,
        feed_mm_min: float | None,
    ) -> Iterator[str]:
        """Yield the lines of a move: each piece, and before it the line that takes up play."""
        model, motion = before, MOTION_NAMES[self._reader.model.motion]
        writer = Words(words, self._reader.model, pieces, centre_mm)
        moved = {axis for piece in pieces for axis in self._as_written.moved(piece.begin_mm, piece.end_mm)}
        rest_mm = self._as_written.rest_mm(moved) if self._reader.model.motion != RAPID else None
        if rest_mm is not None:
            yield self._crossing(model, self._motors.at_mm, rest_mm, feed_mm_min)
            self._motors.at_mm = list(rest_mm)
        self._as_written.went(range(len(AXES)) if rest_mm is not None else moved)
        for number, piece in enumerate(pieces):
            stood = tuple(self._motors.at_mm)
            taken_up = self._motors.go(piece.begin_mm, piece.end_mm)
            if taken_up is not None:
                yield self._crossing(model, stood, taken_up, feed_mm_min)
                stood = taken_up
            yield writer.line(number, stood, self._motors.at_mm, self._crossed not in ("", motion))
            model, self._crossed = self._reader.model, ""


def with_backlash_compensation(
    wire: WireText, play: Backlash, dialect: Dialect, start: Start | None, file: str
) -> WireText:
    """Return the wire text with what takes up play; `leads` says which of its lines the next one continues.

    A message is told at the last line of those that its line has become, where the program stops.
    """
    writer = BacklashCompensation(play, dialect, start, file)
    lines, numbers, leads = bytearray(), array("i"), bytearray()
    messages: dict[int, str] = {}
    for index, (line, number) in enumerate(zip(wire.lines, wire.file_lines.tolist(), strict=True)):
        sent = writer.lines(line, number)
        for one in sent:
            check_wire_line(one, dialect, Place(file, number))
            lines += f"{one}\n".encode("ascii")
        numbers.extend([number] * len(sent))
        leads += bytes([*[1] * (len(sent) - 1), 0])
        if index in wire.messages:
            messages[len(numbers) - 1] = wire.messages[index]
    flags = np.frombuffer(bytes(leads), bool)
    return WireText(WireLines(bytes(lines)), np.array(numbers, np.int32), messages, flags)
