# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compensates the backlash of the axes in the wire text, for controllers that do not do it themselves.

    G1X10F300                  G1X10F300         going +
    X4              ->         G1X9.95           X turns back: its motor alone crosses the gap, at the move's feed
                               X3.95             and from there on stands beside the tool
    G2X4Y0I5                   an arc is cut into several where an axis turns back

The motors cross the gap no faster than the move goes that follows: where the gap is smaller than was told, or the tool
stands elsewhere than was thought, it moves, and in the work. Only a laser's do so as a rapid, in which its beam is off.
F stays what it was. Words keep their numbers where the motor stands where the tool does, and in incremental moves.
Before a place is stored or named (G92, G10, G28.1, G30.1) the motors go back into the gap, to where the tool stands.
Places of the machine (G28, G30, G53) are gone to as they are written. Probes are refused: where they
end is not known.

Lines that go to a place of the machine (G28, G30, G53): they are sent as written, since beyond it travel may end.

text      A ───────────► P
motors    A ─► ────────► P    what is left of the gaps first, where several axes move: so the tool goes straight
tool      A ──────────► T     short of P by the play, where its axis goes against its true sense
next feed move          T►P   begins with the motors' way on by the play, unless it leads this axis alone

The words of moves with the motors ahead of the tool (`backlash_compensation.py`).

A move that stays whole keeps its words, but for the ends that lie elsewhere; of one that is cut, the first piece has
the words that act before a move, the last one those that act after it.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterable, Iterator, Sequence, Set
from math import isnan

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.syntax.words import Word, words_of
from CNCStepper.gcode.wire.monotonic_split import Piece, arc_pieces, straight_pieces
from CNCStepper.gcode.wire.wire_text import WireLines, WireText, check_wire_line
from CNCStepper.machine.backlash import Backlash, Motors
from CNCStepper.machine.profile import Machine
from CNCStepper.state import Start
from CNCStepper.tolerances import SAME_SUM_MM
from CNCStepper.toolpath import ARC_CCW, LINE, PLANE_AXES, PLANE_NAMES, RAPID, Chunk

Vector = tuple[float, ...]


class AsWritten:
    """Follows the motors along such lines, and which axes have left their tool short of the place."""

    def __init__(self, motors: Motors):
        self._motors, self._play = motors, motors.play
        self._short: dict[int, float] = {}  # by axis: how far the motor is ahead of the tool, which is not at its place

    def ready_mm(self, position_mm: Sequence[float], first_mm: Sequence[float]) -> Vector | None:
        """Return the motor positions at which the tool starts with them; None when they are there.

        position_mm: of the tool, as programmed. first_mm: to which the motors go first.
        """
        at_mm = self._motors.at_mm
        ready = list(at_mm)
        for axis in (moved := self.moved(at_mm, first_mm)):
            ahead_mm = self._ahead_mm(axis, position_mm)
            if len(moved) > 1 and not isnan(ahead_mm):
                sense = self._play.sense(axis, at_mm[axis], first_mm[axis])
                place = at_mm[axis] - ahead_mm + self._play.ahead_mm(axis, sense)
                ready[axis] = min(place, first_mm[axis]) if sense > 0 else max(place, first_mm[axis])
        return tuple(ready) if any(abs(one - at) > SAME_SUM_MM for one, at in zip(ready, at_mm, strict=True)) else None

    def go(self, axes: Iterable[int], position_mm: Sequence[float], places_mm: Iterable[Sequence[float]]) -> None:
        """Let the motors of some axes go from place to place, the tool being at its programmed position."""
        places = list(places_mm)
        for axis in axes:
            ahead_mm, at_mm = self._ahead_mm(axis, position_mm), self._motors.at_mm[axis]
            for place in places:
                ahead_mm = self._after(axis, ahead_mm, place[axis] - at_mm)
                at_mm = place[axis]
            self._motors.at_mm[axis] = at_mm
            self._short.pop(axis, None)
            if abs(ahead_mm) > SAME_SUM_MM and not isnan(at_mm):
                self._short[axis] = ahead_mm

    def rest_mm(self, moved: Set[int]) -> Vector | None:
        """Return where the motors go before a feed move to bring the tool to its programmed position; None where it is.

        moved: the axes that the move leads; one that it leads alone comes to its way by itself.
        """
        if not self._short.keys() - (moved if len(moved) == 1 else set()):
            return None
        ready = list(self._motors.at_mm)
        for axis in self._short:
            ready[axis] += self._play.ahead_mm(axis, -self._play.true_sense[axis])
        return tuple(ready)

    def went(self, axes: Iterable[int]) -> None:
        """Note that the backlash of some axes is compensated, or that their next move compensates it."""
        for axis in axes:
            self._short.pop(axis, None)

    def moved(self, begin_mm: Sequence[float], end_mm: Sequence[float]) -> set[int]:
        """Return the axes that make steps between two places, of which none may be unknown."""
        ways = enumerate(zip(begin_mm, end_mm, strict=True))
        return {axis for axis, way in ways if not any(map(isnan, way)) and self._play.sense(axis, *way)}

    def _ahead_mm(self, axis: int, position_mm: Sequence[float]) -> float:
        """Return how far a motor is ahead of its tool; NaN where that is unknown."""
        return self._short.get(axis, self._motors.at_mm[axis] - position_mm[axis])

    def _after(self, axis: int, ahead_mm: float, way_mm: float) -> float:
        """Return the same after a way; from a place that nobody knows the tool may be as short as it can."""
        if isnan(ahead_mm) or isnan(way_mm):
            return self._play.ahead_mm(axis, -self._play.true_sense[axis])
        return self._play.ahead_after(axis, ahead_mm, way_mm)


AXES, CENTRES = "XYZ", "IJK"
STOPS = frozenset(("M0", "M1", "M2", "M30", "M60"))  # they are executed after the move of their line
DECIMALS = {"mm": 5, "inch": 6}  # at least, of a number that changes: a hundredth of a step, or less
OF_ARCS = (*CENTRES, "R", "P")
MOTIONS = frozenset(MOTION_NAMES)


def crossing(model: Model, stood_mm: Sequence[float], end_mm: Sequence[float], feed_mm_min: float | None = None) -> str:
    """Return the line that takes the motors from elsewhere to `end_mm`, in the modes of `model`.

    feed_mm_min: None is a rapid.
    """
    if model.turn is not None:
        what = "backlash cannot be compensated in rotated coordinates"
        raise ProgramError("take-up", what, advice="turn the program instead")
    moved = [
        axis for axis, pair in enumerate(zip(stood_mm, end_mm, strict=True)) if abs(pair[0] - pair[1]) > SAME_SUM_MM
    ]
    places = "".join(AXES[axis] + place_text(model, axis, stood_mm, end_mm) for axis in moved)
    if feed_mm_min is None:
        return f"G0{places}"
    way_mm = math.dist(*zip(*((stood_mm[axis], end_mm[axis]) for axis in moved), strict=True))
    return f"G1{places}{_feed_word(model, feed_mm_min, way_mm)}"


def place_text(model: Model, axis: int, stood_mm: Sequence[float], end_mm: Sequence[float]) -> str:
    """Return the number that moves the motor of an axis from its last position to its end.

    Ways are those between places that are rounded themselves, so that what the digits leave out never adds up.
    """
    if model.absolute:
        return number_text((end_mm[axis] - model.offset[axis]) / model.scale, model)
    digits = DECIMALS[model.state.units]
    stood, end = (round(place[axis] / model.scale, digits) for place in (stood_mm, end_mm))
    return number_text(end - stood, model)


def _feed_word(model: Model, feed_mm_min: float, way_mm: float) -> str:
    """Return the F word of a way at this feed, nothing where this feed is in force."""
    mode, feed = model.state.feed_mode, feed_mm_min / model.scale
    if mode == "inverse_time":
        feed = feed_mm_min / way_mm
    elif mode == "per_turn":
        feed /= model.state.spindle_rpm
    elif feed_mm_min == model.state.feed_mm_min:
        return ""
    return f"F{number_text(feed, model)}"


class Words:
    """Writes the pieces of one line, in their order.

    model: as it is after the line. centre_mm: of an arc that is cut, None for any other line.
    """

    def __init__(self, words: list[Word], model: Model, pieces: list[Piece], centre_mm: Sequence[float] | None):
        self._model, self._pieces, self._centre_mm = model, pieces, centre_mm
        self._codes = [word for word in words if word.letter in "GM" and word.name not in STOPS]
        self._stops = [word for word in words if word.name in STOPS]
        self._ends = [word for word in words if word.letter in AXES]
        self._others = [word for word in words if word.letter not in ("G", "M", *AXES)]

    def line(self, number: int, stood_mm: Sequence[float], motors_mm: Sequence[float], says_motion: bool) -> str:
        """Return the line of a piece, in which the motors go from `stood_mm` to `motors_mm`.

        says_motion: it must name its motion, since another one is modal on the wire.
        """
        first, last = number == 0, number == len(self._pieces) - 1
        codes = self._codes if first else []
        words = [word.text for word in codes]
        if (says_motion or not first) and not any(word.name in MOTIONS for word in codes):
            words.append(MOTION_NAMES[self._model.motion])
        if self._centre_mm is None:
            words += [self._end(word, motors_mm[AXES.index(word.letter)]) for word in self._ends]
        else:
            words += self._arc_words(self._pieces[number], stood_mm, motors_mm, self._centre_mm)
        words += [self._other(word, number) for word in self._others if first or self._is_shared(word)]
        return "".join([*words, *(word.text for word in self._stops if last)])

    def _end(self, word: Word, motor_mm: float) -> str:
        """Return an axis word with the motor's position."""
        ahead_mm = motor_mm - self._pieces[-1].end_mm[AXES.index(word.letter)]
        if math.isnan(ahead_mm) or abs(ahead_mm) <= SAME_SUM_MM or not self._model.absolute:
            return word.text
        places = len(word.number.partition(".")[2])
        return word.letter + number_text(float(word.number) + ahead_mm / self._model.scale, self._model, places)

    def _arc_words(self, piece: Piece, stood_mm, motors_mm, centre_mm) -> list[str]:
        """Return end and centre of a piece of an arc."""
        model = self._model
        one, two, normal = PLANE_AXES[PLANE_NAMES.index(model.state.plane)]
        named = [one, two] + [normal] * any(word.letter == AXES[normal] for word in self._ends)
        ends = [AXES[axis] + place_text(model, axis, stood_mm, motors_mm) for axis in named]
        arms = [(axis, (centre_mm[axis] - piece.begin_mm[axis]) / model.scale) for axis in (one, two)]
        return ends + [CENTRES[axis] + number_text(arm, model) for axis, arm in arms]

    def _is_shared(self, word: Word) -> bool:
        """Whether every piece needs a word: F, where it belongs to its line's move."""
        return word.letter == "F" and self._model.state.feed_mode == "inverse_time"

    def _other(self, word: Word, number: int) -> str:
        if self._centre_mm is not None and word.letter in OF_ARCS:
            return ""
        share = self._pieces[number].share
        if self._is_shared(word) and share < 1.0:
            return "F" + number_text(float(word.number) / share, self._model)
        return word.text


def number_text(value: float, model: Model, places: int = 0) -> str:
    """Return a number with its last digits trimmed, fine enough for the unit that is in force."""
    text = f"{value:.{max(DECIMALS[model.state.units], places)}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


OF_MACHINE = frozenset(("G28", "G30", "G53"))
NAMES_PLACE = frozenset(("G92", "G10", "G28.1", "G30.1"))
TAKES_AXES = frozenset(("G4", "G43", "G43.1", "G43.2", "G52"))  # whose axis words are no move's


def backlash_of(machine: Machine | None, dialect: str | Dialect) -> Backlash | None:
    """Return the play that a sender must take up on a machine; None where there is none, or its controller does.

    dialect: of the program; what counts is the language of the lines that are sent of it.
    """
    if machine is None:
        return None
    sent = machine.wire_language(dialect if isinstance(dialect, str) else dialect.name)
    return None if dialect_named(sent).compensates_backlash else Backlash.of(machine) or None


class BacklashCompensation:
    """Turns the lines of a program, in their order, into those that are sent."""

    def __init__(self, play: Backlash, dialect: Dialect, start: Start | None, file: str):
        if "records" in dialect.front:
            what = Text("backlash cannot be compensated in the dialect {dialect}", dialect=dialect.title)
            advice = "set backlash_mm to 0 in the machine profile"
            raise ProgramError("take-up", what, advice=advice, place=Place(file))
        self._play, self._dialect = play, dialect
        self._reader = Interpreter(start, dialect, file)
        self._motors = Motors(play, self._reader.model.position)
        self._as_written = AsWritten(self._motors)
        self._file = file
        self._crossed = ""  # the motion of our last inserted line, where the program may have another in force

    def wire(self, wire: WireText) -> WireText:
        """Return the lines sent for the next lines of a program; `leads` marks lines that the next one continues.

        A message is told at the last line of those that its line has become, where the program stops.
        """
        lines, numbers, leads = bytearray(), array("i"), bytearray()
        messages: dict[int, str] = {}
        for index, (line, number) in enumerate(zip(wire.lines, wire.file_lines.tolist(), strict=True)):
            sent = self.lines(line, number)
            for one in sent:
                check_wire_line(one, self._dialect, Place(self._file, number))
                lines += f"{one}\n".encode("ascii")
            numbers.extend([number] * len(sent))
            leads += bytes([*[1] * (len(sent) - 1), 0])
            if index in wire.messages:
                messages[len(numbers) - 1] = wire.messages[index]
        flags = np.frombuffer(bytes(leads), bool)
        return WireText(WireLines(bytes(lines)), np.array(numbers, np.int32), messages, flags)

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
        """Lead the motors of the named axes, or of all, to the programmed position; yield the line that goes before."""
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
        """Yield the rapid that moves the motors to the tool's position; the tool does not move."""
        stood = self._motors.at_mm
        here = [stands if isnan(tool) else tool for stands, tool in zip(stood, model.position, strict=True)]
        if any(abs(one - other) > SAME_SUM_MM for one, other in zip(stood, here, strict=True)):
            yield self._crossing(model, stood, here, None)
        self._motors.at_mm = here

    def _feed_mm_min(self, rows: Chunk | None) -> float | None:
        """Return the feed at which a move's backlash is crossed; None for a rapid."""
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
            what = "backlash cannot be compensated within this line"
            advice = "write plain moves, each in a line of its own, in coordinates that are not turned"
            raise ProgramError("take-up", what, advice=advice)

    def _arc(self, words: list[Word], before: Model, rows: Chunk) -> Iterator[str]:
        """Yield the lines of an arc, which is cut where an axis turns back."""
        self._check_plain(rows)
        after = self._reader.model
        if after.state.arc_centres == "absolute":
            what = "backlash cannot be compensated in an arc with an absolute centre"
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
        """Yield the lines of a move: each piece, and before it the line that crosses the backlash."""
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
    """Return the wire text with the lines that cross backlash, as `BacklashCompensation.wire` does."""
    return BacklashCompensation(play, dialect, start, file).wire(wire)
