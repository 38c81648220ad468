# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every pass of a program cut the other way round: what was climb milling is conventional, and the other way.

    before   G0 to A    plunge    A -> B -> C    retract
    after    G0 to C    plunge    C -> B -> A    retract

Order of passes, plunges, spindle, coolant and beam stay where they are; each row keeps its feed. Refused is what would
be unsafe: a ramp (it would enter at full depth), rapids that are not above all cuts with the tool running, passes that
meet one way round only.

A reversed program is read again: its passes must be the old ones from end to begin, and all else as it was.

old    travel ──► A   plunge   A -> B -> C   lift        rows of a pass: AB BC
new    travel ──► C   plunge   C -> B -> A   lift                        CB BA

Writes a program with reversed passes: new lines for them, other ends of the rapids to them, the rest kept.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from math import isnan

import numpy as np

from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import AXES, MOTION_NAMES, PLANE_CODES
from CNCStepper.gcode.edit.cutting_passes import Pass, Rows, passes_of
from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.line_edits import CENTRES
from CNCStepper.gcode.edit.line_states import Meaning, Source, require_straight
from CNCStepper.gcode.edit.line_tokens import Edit, Token, changed, comment_spans
from CNCStepper.gcode.edit.verification import same_events, same_modes
from CNCStepper.gcode.edit.word_values import MOST_DECIMALS, decimals_of, dialect_decimals, number_text
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.motion.arc_lengths import ways_of
from CNCStepper.state import Start
from CNCStepper.tolerances import SAME_ARC_RAD, SAME_SUM_MM
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, PLANE_AXES, PLANE_NAMES, Toolpath
from CNCStepper.units import UNIT_MM

CENTRE_MM = 0.005  # by which rounding may move the centre of an arc
COMMENTS = ("comment", "message")  # stay with their lines


def require_reversed(source: Source, rows: Rows, passes: Sequence[Pass], edited: Edited) -> None:
    """Raise ProgramError where the new text is not the old one with its passes turned round."""
    new = interpret(edited.text, source.start, source.dialect, source.file)
    good = len(new) == len(source.toolpath) and same_events(source.toolpath, new, COMMENTS)
    if not (good and _same_rows(source.toolpath, new, rows, passes)):
        what = "the changed program would make other moves"
        raise source.refusal(1, "edit-differs", what, advice="please report it, with the program")


def _same_rows(old: Toolpath, new: Toolpath, rows: Rows, passes: Sequence[Pass]) -> bool:
    """Return whether every row is the one that it must be: `was` names the old row that each is the way of."""
    table, before = new.table(), rows.table
    was = np.arange(len(before))
    turned = np.zeros(len(before), bool)
    for one in passes:
        was[one.first : one.last] = np.arange(one.first, one.last)[::-1]
        turned[one.first : one.last] = True
    arcs = before.kind[was] >= ARC_CW
    kinds = np.where(turned & arcs, 5 - before.kind[was].astype(int), before.kind[was])
    feeds, wanted = table.feed, before.feed[was]
    if not ((table.kind == kinds) & (np.abs(feeds - wanted) <= 1e-9 * wanted) & same_modes(old, new)).all():
        return False
    begins, ends, centres = (points - new.offsets_mm()[:, :3] for points in _points(new))
    heights = np.isclose(ends[:, 2], rows.end[:, 2], atol=SAME_SUM_MM, equal_nan=True)
    to_begin = (np.abs(ends[:, :2] - rows.begin[was, :2]) <= SAME_SUM_MM).all(axis=1)
    from_end = (np.abs(begins[:, :2] - rows.end[was, :2]) <= SAME_SUM_MM).all(axis=1)
    about = (np.abs(centres - rows.centre[was])[:, :2] <= CENTRE_MM).all(axis=1) | ~arcs
    places = np.where(turned, to_begin & from_end & about & _same_angles(old, new, was), heights)
    return bool(places.all())


def _same_angles(old: Toolpath, new: Toolpath, was: np.ndarray) -> np.ndarray:
    """Return the rows that go through the angle of the old one, the other way round."""
    one, other = (ways_of(path.table(), *_points(path)[:2]) for path in (old, new))
    small = one.radius_mm[was] * SAME_ARC_RAD < CENTRE_MM
    return small | (np.abs(one.sweep_rad[was] + other.sweep_rad) <= SAME_ARC_RAD)


def _points(path: Toolpath) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    return path.begins()[:, :3], path.table().end[:, :3], path.table().centre


IN_A_PASS = frozenset("NXYZIJKRPF")
CODES_IN_A_PASS = frozenset(("G0", "G1", "G2", "G3", *PLANE_CODES))


class Rewriter:
    """Goes through the lines; at: where the new program stands in X and Y (work mm, None: unknown or as the old one).

    motion, feed, plane: what is in force in the new text, "" or None where it is what the old one has.
    """

    def __init__(self, source: Source, rows: Rows, passes: list[Pass]):
        self.source = source
        self.rows = rows
        self.travels = {rows.line[one.travel]: one for one in passes if one.travel is not None}
        self.firsts = {rows.line[one.first]: one for one in passes}
        self.lines: list[str] = []
        self.origins: list[int] = []
        self.at: dict[int, float] = {}
        self.motion: str | None = None
        self.feed: float | None = None
        self.plane: int | None = None
        self.blank = " " if any(" " in text.strip() for _, text, meaning in source if meaning) else ""
        self.decimals, self.fewest = self._digits()

    def edited(self) -> Edited:
        """Return the whole new program."""
        number, count = 1, len(self.source.meanings)
        while number <= count:
            one = self.firsts.get(number)
            if one is not None:
                number = self._pass(one)
            else:
                self._kept(number)
                number += 1
        return self.source.lines.edited(self.lines, self.origins)

    # lines that stay

    def _kept(self, number: int) -> None:
        """Write a line outside the passes, with the words that the new order needs."""
        text, meaning = self.source.lines.lines[number - 1], self.source.meanings[number - 1]
        tokens = self.source.tokens(number) if meaning else []
        if meaning is None or not tokens:
            self._add(text, number)
            return
        edits = self._owed(number, meaning, tokens)
        if number in self.travels:
            edits += self._to_begin(self.travels[number], number, meaning, tokens)
        else:
            self._follow(number, meaning, tokens)
        self._add(changed(text, edits) if edits else text, number)

    def _owed(self, number: int, meaning: Meaning, tokens: list[Token]) -> list[Edit]:
        """Return motion, plane and feed words that the line relies on, where others are in force now."""
        names = {token.name for token in tokens}
        words: list[str] = []
        moves = self._rows_of(number)
        if self.plane is not None:
            wanted = PLANE_NAMES.index(meaning.plane)
            words += [PLANE_CODES[wanted]] if wanted != self.plane and not names & {*PLANE_CODES} else []
            self.plane = None
        if names & {*MOTION_NAMES}:
            self.motion = None
        elif self.motion is not None and moves:
            words.append(self._motion_word(meaning.motion))
            self.motion = None
        if "F" in names:
            self.feed = None
        elif self.feed is not None and not self.rows.rapid[moves].all():
            old = self._old_feed(number)
            words += [] if old == self.feed else [self._feed_word(old, meaning)]
            self.feed = None if old != self.feed else self.feed
        at = next((token.begin for token in tokens if token.letter != "N"), tokens[-1].last)
        return [(at, at, "".join(word + self.blank for word in words))] if words else []

    def _to_begin(self, one: Pass, number: int, meaning: Meaning, tokens: list[Token]) -> list[Edit]:
        """Return the edits that let a rapid lead to the new begin of its pass."""
        words = {token.letter: token for token in tokens}
        names = {token.name for token in tokens}
        if (
            len(self._rows_of(number)) != 1
            or names & {"G53", "G28", "G30"}
            or any(words[a].number is None for a in AXES[:2] if a in words)
        ):
            what = "the rapid that leads to a contour must lead to another place, and cannot be changed"
            raise self.rows.refusal(one.travel or 0, "reverse-travel", what, "write a G0 with numbers before it")
        edits: list[Edit] = []
        for axis in (0, 1):
            wanted = float(self.rows.end[one.last - 1, axis])
            at = self._at(axis, number)
            if not meaning.absolute and at != at:
                what = "where this rapid begins is not known"
                raise self.rows.refusal(one.travel or 0, "reverse-travel", what, "move there with G90 first")
            if AXES[axis] in words or not abs(wanted - at) <= SAME_SUM_MM:
                edits.append(self._axis_edit(axis, wanted if meaning.absolute else wanted - at, meaning, words))
            self.at[axis] = wanted
        return edits

    def _axis_edit(self, axis: int, value_mm: float, meaning: Meaning, words: dict[str, Token]) -> Edit:
        token = words.get(AXES[axis])
        text = self._number(value_mm / UNIT_MM[meaning.units], token.written if token else "")
        if token is not None:
            return token.first, token.last, text
        other = words.get(AXES[1 - axis]) or words.get("Z")
        assert other is not None  # a rapid that moves in X or Y has a word for it
        if axis == 0:
            return other.begin, other.begin, f"X{text}{self.blank}"
        return other.last, other.last, f"{self.blank}Y{text}"

    def _at(self, axis: int, number: int) -> float:
        meaning = self.source.meanings[number - 1]
        old = meaning.begin[axis] if meaning else float("nan")
        return self.at.get(axis, old)

    def _follow(self, number: int, meaning: Meaning, tokens: list[Token]) -> None:
        """Note where a kept line leads the new program."""
        words = {token.letter: token for token in tokens}
        rows = self._rows_of(number)
        if not rows:
            return
        machine = {token.name for token in tokens} & {"G53", "G28", "G30"}
        for axis in (0, 1):
            if axis not in self.at or (AXES[axis] not in words and not machine):
                continue
            if meaning.absolute or machine:
                del self.at[axis]
            else:
                self.at[axis] += float(self.rows.end[rows[-1], axis] - self.rows.begin[rows[0], axis])

    # passes

    def _pass(self, one: Pass) -> int:
        """Write a pass backwards; return the line after it."""
        first, last = self.rows.line[one.first], self.rows.line[one.last - 1]
        row = one.last - 1
        before = self.source.meanings[first - 1]
        assert before is not None  # it made a row
        self.motion = self.motion if self.motion is not None else self._motion_before(first)
        self.feed = self.feed if self.feed is not None else self._feed_before(first)
        self.plane = self.plane if self.plane is not None else self._plane_before(first)
        for number in range(last, first - 1, -1):
            rows = self._rows_of(number)
            self._check_line(number, rows)
            if rows:
                self._row(row, number)
                row -= 1
            elif not self.source.tokens(number):
                self._add(self.source.lines.lines[number - 1], number)
        for axis in (0, 1):
            self.at[axis] = float(self.rows.begin[one.first, axis])
        return last + 1

    def _check_line(self, number: int, rows: list[int]) -> None:
        tokens = self.source.tokens(number)
        codes = {token.name for token in tokens if token.letter in "GM"}
        odd = any(token.letter not in IN_A_PASS and token.letter != "G" for token in tokens)
        if odd or len(rows) > 1 or codes - CODES_IN_A_PASS or any(token.number is None for token in tokens):
            what = "this line is in the part that is to be reversed, and is not only a move"
            text = self.source.lines.lines[number - 1].strip()
            raise self.source.refusal(number, "reverse-line", what, value=text[:40], advice="put it before the way")

    def _row(self, row: int, number: int) -> None:
        """Write one row from its end to its begin, with its line's comments."""
        rows, meaning = self.rows, self.source.meanings[number - 1]
        assert meaning is not None
        kind, unit_mm = int(rows.table.kind[row]), UNIT_MM[meaning.units]
        turned = {LINE: LINE, ARC_CW: ARC_CCW, ARC_CCW: ARC_CW}[kind]
        plane = int(rows.table.plane[row])
        words = [PLANE_CODES[plane]] if kind != LINE and plane != self.plane else []
        self.plane = plane if kind != LINE else self.plane
        name = MOTION_NAMES[turned]
        words += [self._motion_word(name)] if name != self.motion else []
        self.motion = name
        begin, end = rows.end[row], rows.begin[row]
        in_plane = PLANE_AXES[plane][:2] if kind != LINE else ()
        for axis in (0, 1, 2):
            if axis in in_plane or abs(end[axis] - begin[axis]) > SAME_SUM_MM:
                value = end[axis] if meaning.absolute else end[axis] - begin[axis]
                words.append(AXES[axis] + self._number(value / unit_mm))
        words += self._arc_words(row, number, meaning, in_plane)
        feed = float(rows.table.feed[row])
        if meaning.inverse_time:
            words += ["F" + token.written for token in self.source.tokens(number) if token.letter == "F"]
        elif feed != self.feed:
            words.append(self._feed_word(feed, meaning))
            self.feed = feed
        text = self.source.lines.lines[number - 1]
        words += [text[first:last] for first, last in comment_spans(text)]
        self._add((self.blank or "").join(words), number)

    def _arc_words(self, row: int, number: int, meaning: Meaning, in_plane: tuple[int, ...]) -> list[str]:
        tokens = {token.letter: token for token in self.source.tokens(number)}
        if not in_plane:
            return []
        turns = [f"P{tokens['P'].written}"] if "P" in tokens else []
        if "R" in tokens:
            return [f"R{tokens['R'].written}", *turns]
        begin, centre = self.rows.end[row], self.rows.centre[row]
        values = {axis: centre[axis] - (0.0 if meaning.absolute_centres else begin[axis]) for axis in sorted(in_plane)}
        return [CENTRES[axis] + self._number(value / UNIT_MM[meaning.units]) for axis, value in values.items()] + turns

    # what is in force

    def _rows_of(self, number: int) -> list[int]:
        return list(range(self.source.firsts[number - 1], self.source.firsts[number]))

    def _motion_before(self, number: int) -> str:
        before = next((one for one in reversed(self.source.meanings[: number - 1]) if one), None)
        return before.motion if before else ""

    def _plane_before(self, number: int) -> int:
        before = next((one for one in reversed(self.source.meanings[: number - 1]) if one), None)
        return PLANE_NAMES.index(before.plane) if before else 0

    def _feed_before(self, number: int) -> float:
        row = self.source.firsts[number - 1]
        before = self.rows.source.toolpath.states[int(self.rows.table.state[row - 1])] if row else None
        return before.feed_mm_min if before else 0.0

    def _old_feed(self, number: int) -> float:
        return self.rows.state(self._rows_of(number)[-1]).feed_mm_min

    def _motion_word(self, name: str) -> str:
        code = self.source.dialect.motion_code(MOTION_NAMES.index(name))
        return code.name if code else name

    def _feed_word(self, feed_mm_min: float, meaning: Meaning) -> str:
        return "F" + number_text(feed_mm_min / UNIT_MM[meaning.feed_units], MOST_DECIMALS)

    def _number(self, value: float, like: str = "") -> str:
        least = self.fewest if self.fewest == self.decimals else 0
        return number_text(value, max(self.decimals, 1), decimals_of(like) if like else least, like)

    def _digits(self) -> tuple[int, int]:
        found = [
            decimals_of(token.written)
            for number, _, meaning in self.source
            if meaning
            for token in self.source.tokens(number)
            if token.letter in "XYZIJKR" and token.number is not None
        ]
        units = next((meaning.units for meaning in self.source.meanings if meaning), "mm")
        return max(found, default=dialect_decimals(self.source.dialect, units)), min(found, default=0)

    def _add(self, line: str, number: int) -> None:
        self.lines.append(line)
        self.origins.append(number)


def reverse(text: str, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = "") -> Edited:
    """Return the program with each of its passes cut backwards; raises ProgramError where that would be unsafe."""
    require_straight(text, dialect_named(dialect), file)
    source = Source(text, dialect, start, file)
    rows = Rows(source)
    passes = passes_of(rows)
    if not passes:
        advice = "give a program that cuts along X and Y"
        raise source.refusal(1, "reverse-nothing", "the program cuts along no way at one height", advice=advice)
    _check(rows, passes)
    edited = Rewriter(source, rows, passes).edited()
    require_reversed(source, rows, passes, edited)
    return edited


def _check(rows: Rows, passes: list[Pass]) -> None:
    for one in passes:
        if any(meaning.compensated for meaning in _meanings(rows, one)):
            what = "the tool's radius is compensated along this way (G41, G42)"
            raise rows.refusal(one.first, "reverse-compensation", what, "write the path of the tool's centre")
        if np.isnan(rows.begin[one.first : one.last, :2]).any():
            what = "where this way begins is not known"
            raise rows.refusal(one.first, "reverse-unknown", what, "write a rapid to its begin")
    for before, after in itertools.pairwise([None, *passes]):
        _check_meeting(rows, before, after)
    _check_rapids(rows, passes)


def _meanings(rows: Rows, one: Pass):
    found = (rows.source.meanings[rows.line[row] - 1] for row in range(one.first, one.last))
    return (meaning for meaning in found if meaning)


def _check_meeting(rows: Rows, before: Pass | None, after: Pass | None) -> None:
    """Refuse a pass to which no rapid leads and that does not begin where the one before ends, backwards too."""
    if after is None or after.travel is not None:
        return
    begin = rows.end[after.last - 1, :2]
    there = rows.begin[before.first, :2] if before else None
    if there is None or (np.abs(begin - there) > SAME_SUM_MM).any():
        what = "no rapid leads to this way, and backwards it does not begin where the one before ends"
        raise rows.refusal(after.first, "reverse-apart", what, "lift the tool between them")


def _check_rapids(rows: Rows, passes: list[Pass]) -> None:
    """Refuse rapids with the tool running that are not above every cut: other places lie under them now."""
    heights = np.concatenate([rows.end[one.first : one.last, 2] for one in passes])
    deepest = float(np.nanmax(heights)) if not np.isnan(heights).all() else float("nan")
    for row in np.flatnonzero(rows.rapid & rows.flat).tolist():
        begin, end = float(rows.begin[row, 2]), float(rows.end[row, 2])
        height = end if isnan(begin) else min(begin, end)
        if rows.state(row).spindle_turns and not height > deepest and not _before(row, passes):
            what = "a rapid with the tool running is not above all cuts"
            raise rows.refusal(row, "reverse-rapid", what, "raise the tool first, or switch it off")


def _before(row: int, passes: list[Pass]) -> bool:
    """Whether a rapid comes before the first pass: nothing has been cut, and its height is not known perhaps."""
    return row < passes[0].first and passes[0].travel != row
