# SPDX-License-Identifier: LGPL-2.1-or-later
"""Emits the blocks of a program: words in their modal order, nothing repeated, every line checked.

It holds the machine's state after each line: position in counts of the last digit, motion, feed, plane.

Comments that are safe on any wire: plain ASCII without the bytes that controllers act upon.

The grid of numbers that a text can hold: lengths as whole counts of its last digit.

The writer works on this grid, so that it has the machine's exact position after each line.
"""

from __future__ import annotations

import textwrap
import unicodedata
from dataclasses import dataclass
from functools import cached_property
from math import ceil, floor, hypot
from typing import TypeVar

import numpy as np

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, Writing
from CNCStepper.gcode.dialects.codes import AXES, MOTION_NAMES, PLANE_CODES
from CNCStepper.gcode.writer.write_options import Notes
from CNCStepper.tolerances import SAME_COUNT, SAME_SHARE
from CNCStepper.toolpath import LINE, PLANE_AXES, RAPID, XY, ZX
from CNCStepper.units import MM_PER_INCH

COMMENT_WIDTH = 76
_LETTERS = str.maketrans(
    {
        "ß": "ss",
        "æ": "ae",
        "Æ": "AE",
        "œ": "oe",
        "Œ": "OE",
        "ø": "o",
        "Ø": "O",
        "đ": "d",
        "Đ": "D",
        "ł": "l",
        "Ł": "L",
        "ı": "i",
        "°": " deg",
        "×": "x",
        "÷": "/",
        "µ": "u",
        "±": "+/-",
        "–": "-",
        "—": "-",
        "‘": "'",
        "’": "'",
        "“": '"',
        "”": '"',
        "…": "...",
        "(": "[",
        ")": "]",
        "!": ".",
        "?": ".",
        "~": "-",
        "$": "S",
        ";": ",",
        "%": " percent",
        "\t": " ",
    }
)


def ascii_text(text: str) -> str:
    """Return `text` in printable ASCII without ! ? ~ $ ; % and parentheses; what has no likeness becomes "_"."""
    plain = unicodedata.normalize("NFKD", unicodedata.normalize("NFC", text).translate(_LETTERS)).translate(_LETTERS)
    letters = (character for character in plain if not unicodedata.combining(character))
    return " ".join("".join(letter if " " <= letter <= "\x7e" else "_" for letter in letters).split())


def comment_lines(text: str) -> list[str]:
    """Return `text` as lines of a comment, without the dialect's comment delimiters."""
    return textwrap.wrap(ascii_text(text), COMMENT_WIDTH)


Lengths = TypeVar("Lengths", float, np.ndarray)


@dataclass(frozen=True)
class Grid:
    """units: "mm" or "inch" of the text; decimals: digits after the point. trims: without trailing zeros."""

    units: str
    decimals: int
    trims: bool = False

    @cached_property
    def unit_mm(self) -> float:
        """One unit of the text in mm."""
        return MM_PER_INCH if self.units == "inch" else 1.0

    @cached_property
    def counts(self) -> int:
        """How many counts of the last digit one unit of the text has."""
        return 10**self.decimals

    @property
    def step_mm(self) -> float:
        """The last digit in mm."""
        return self.unit_mm / self.counts

    def exact(self, length_mm: Lengths) -> Lengths:
        """Return a length, or an array of them, in counts of the last digit, not rounded."""
        return length_mm / self.unit_mm * self.counts

    def count(self, length_mm: float) -> int:
        """Return a length in whole counts of the last digit."""
        return round(self.exact(length_mm))

    def text(self, count: int) -> str:
        """Return a length as text with all its decimals, or without trailing zeros; there is no -0."""
        sign = "-" if count < 0 else ""
        whole, rest = divmod(abs(count), self.counts)
        text = f"{sign}{whole}.{rest:0{self.decimals}d}"
        return _trimmed(text) if self.trims else text

    def short(self, length_mm: float) -> str:
        """Return a length (a feed) as text without trailing zeros."""
        return _trimmed(self.text(self.count(length_mm)))


def _trimmed(number: str) -> str:
    return number.rstrip("0").rstrip(".") if "." in number else number


def near_step(count: int | None, step_counts: float) -> int | None:
    """Return a place at most a quarter of a step from the nearest whole step; both in counts, steps of 0 move nothing.

    Then the increment between two such places, rounded to whole steps, is the one between their nearest steps.
    """
    if count is None or not step_counts:
        return count
    whole, quarter = round(count / step_counts) * step_counts, step_counts / 4
    return min(max(count, ceil(whole - quarter + SAME_COUNT)), floor(whole + quarter - SAME_COUNT))


CENTRES = "IJK"
MOST_FEED_ERROR = 0.005  # relative
CUT_FEED = "F#<_hal[plasmac.cut-feed-rate]>"  # the feed of QtPlasmaC's material
SYNCHRONISED = "G33"
LEAD_DECIMALS = 6  # a lead adds up over all turns
Counts = list[int | None]


class BlockEmitter:
    """The lines written so far and the modal words in force; `at` is None on axes never written.

    step_counts: a step of X, Y and Z in counts where increments are rounded to steps one by one; else 0.
    notes: what was written differently. number: the last N word. lead_mm: a turn, of the next move if it follows the
    spindle, else 0.
    """

    def __init__(self, dialect: Dialect, writing: Writing, grid: Grid):
        self.dialect = dialect
        self.writing = writing
        self.grid = grid
        self.notes = Notes()
        self.lines: list[str] = []
        self.own_comments: set[str] = set()
        self.at: Counts = [None, None, None]
        self._codes = [dialect.motion_code(kind) for kind in range(len(MOTION_NAMES))]
        self._feeds: dict[float, str] = {}  # the F words written so far, mm/min
        self._own_axes = [axis for axis in range(3) if AXES[axis] in dialect.letters]
        self._number = 0
        self._motion = ""
        self._feed = f"F{grid.short(dialect.default_feed_mm_min)}" if dialect.feed_is_setting else ""
        self._plane = ZX if dialect.is_lathe else XY
        self._stale: set[int] = set()  # axes whose next word is written even where nothing changes
        self._cycle = ""
        self._cut_feed_mm_min, self._share = 0.0, "Q0"
        self._distance = "absolute"
        self.distance = "absolute"  # of the moves to come
        self.x_factor = 2 if dialect.diameter else 1  # of X words: 2 where they are diameters
        self.incremental = False  # coordinates are given from where the machine is
        self.step_counts = (0.0, 0.0, 0.0)
        self.turn_rpm = 0.0  # F is in mm a turn at this speed; 0: a minute
        self.lead_mm = 0.0

    @property
    def has_just_started(self) -> bool:
        """Whether the last line has switched on what cuts."""
        return bool(self.lines) and self.lines[-1].startswith("M3")

    @property
    def in_cycle(self) -> bool:
        """Whether the last line is a block of a canned cycle."""
        return bool(self._cycle)

    def text(self) -> str:
        """Return the program."""
        marks = self.writing.opens, self.writing.closes
        return "".join(f"{line}\n" for line in (marks[0], *self.lines, marks[1]) if line)

    def line(self, *words: str) -> None:
        """Write words as one block; raises ProgramError where it is longer than the controller's buffer."""
        spelled = words if self.writing.code_digits == 1 else map(self._spelled, words)
        self._block(" ".join(word for word in spelled if word))

    def _block(self, text: str, comment: str = "") -> None:
        if not text:
            return
        self.end_cycle()
        line = f"{self._next_number()}{text}{comment}{self.writing.block_end}"
        limit = self.dialect.line_limit
        if limit and len(line) >= limit:
            what = "a line does not fit the controller's buffer"
            advice = "make the message in it shorter"
            raise ProgramError("line-too-long", what, value=line, limit=f"{limit - 1} characters", advice=advice)
        self.lines.append(line)

    def _next_number(self) -> str:
        step = self.writing.number_step
        if not step:
            return ""
        self._number = self._number + step if self._number + step <= self.dialect.largest_line_number else step
        return f"N{self._number} "

    def _spelled(self, word: str) -> str:
        """Return a G or M word with as many digits as the dialect's codes have."""
        if word[:1] in ("G", "M") and self.writing.code_digits == 2 and len(word.partition(".")[0]) == 2:
            return f"{word[0]}0{word[1:]}"
        return word

    def raw(self, comment: str) -> None:
        """Write a comment unchanged; nothing where the dialect has none."""
        if self.writing.comment:
            self.end_cycle()
            end = self.writing.block_end
            self.lines.append(self.writing.comment.format(comment.replace("#", "No.") if end else comment) + end)

    def comment(self, text: str, own: bool = False) -> None:
        """Write a comment; one that the writer itself has written is not repeated."""
        for line in comment_lines(text):
            if own or line not in self.own_comments:
                self.raw(line)
            if own:
                self.own_comments.add(line)

    def message(self, text: str) -> None:
        """Write a message to the operator."""
        for line in comment_lines(f"MSG, {text}"):
            self.raw(line if line.startswith("MSG,") else f"MSG, {line}")

    def stop(self, code: str, message: str = "") -> None:
        """Write a pause with its message on the same line."""
        text = ascii_text(message)[: COMMENT_WIDTH - 8]
        form = self.writing.comment
        self._block(self._spelled(code), f" {form.format(f'MSG, {text}')}" if text and form else "")
        self.forget()

    def forget(self) -> None:
        """Let the next move write all its words, since the machine may have been moved."""
        self._motion, self._stale = "", set(self._own_axes)
        if not self.dialect.feed_is_setting:  # else no operator changes it meanwhile
            self._feed = ""

    def forget_feed(self) -> None:
        """Let the next cut write its F, since a lead is in force as one."""
        self._feed = ""

    def begin_at(self, at: Counts) -> None:
        """Set the machine's position at the program's begin; the first move names its axes all the same."""
        is_known = self.dialect.starts_at_work_zero and not any(at)  # zero, or an axis that the language lacks
        self.at = list(at)
        self._stale = set() if is_known else {axis for axis in self._own_axes if at[axis] is not None}

    def without_y(self) -> None:
        """Write no Y from here on, as the machine has none: it stays at 0."""
        self._own_axes = [axis for axis in self._own_axes if axis != 1]
        self._stale.discard(1)
        self.at[1] = 0

    def move(self, kind: int, end: Counts, feed_mm_min: float = 0.0, nowhere: bool = False) -> None:
        """Write a straight move; where it leads nowhere only if `nowhere`."""
        if any(self.step_counts):
            end = [near_step(count, step) for count, step in zip(end, self.step_counts, strict=True)]
        if not (nowhere or self._axes(end)):
            return
        changes = self._distance_word(kind)
        axes = self._axes(end)
        if not axes and nowhere:
            axes = [self._axis(axis, count) for axis in self._own_axes if (count := end[axis]) is not None][:1]
        thread = self._codes[MOTION_NAMES.index(SYNCHRONISED)]
        if axes and self.lead_mm and kind == LINE and thread:
            self._motion = thread.name
            self.line(thread.name, *axes, self._lead_word(end))
            self._arrive(end)
        elif axes:
            self._bring_feed(kind, feed_mm_min)
            word = changes or self._motion_word(kind)
            self.line(word, *axes, self._feed_word(kind, feed_mm_min, opens=bool(word)))
            self._arrive(end)

    def arc(self, kind: int, end: Counts, offset: tuple[int, int], plane: int, feed_mm_min: float, turns: int) -> None:
        """Write an arc with its centre at begin + `offset`; the words of its plane are written always."""
        self.select_plane(plane)
        self._bring_feed(kind, feed_mm_min)
        self._distance_word(kind)
        first, second, _ = PLANE_AXES[plane]
        self._stale |= {first, second}
        axes = self._axes(end)
        centres = sorted(zip((first, second), offset, strict=True))
        words = [f"{CENTRES[axis]}{self.grid.text(count + self._centre_origin(axis))}" for axis, count in centres]
        word = self._motion_word(kind) or self._name(kind)  # an arc always has its motion word
        self.line(word, *axes, *words, f"P{turns}" if turns > 1 else "", self._feed_word(kind, feed_mm_min))
        self._arrive(end)

    def _lead_word(self, end: Counts) -> str:
        """Return the travel a turn: K along the path, or F along the axis that moves farther, which is a feed too."""
        lead = self.lead_mm / self.grid.unit_mm
        if self.dialect.lead_word == "K":
            return f"K{_trimmed(f'{lead:.{LEAD_DECIMALS}f}')}"
        way = [abs((end[axis] or 0) - (self.at[axis] or 0)) for axis in (0, 2)]
        self._feed = ""
        lead *= max(way) / (hypot(*way) or 1.0)
        slack = lead / max(*way, 1)  # by which the last digit of the end changes
        digits = next((d for d in range(LEAD_DECIMALS) if abs(round(lead, d) - lead) <= slack), LEAD_DECIMALS)
        return f"F{self.with_point(_trimmed(f'{lead:.{digits}f}'))}"

    def with_point(self, number: str) -> str:
        """Return a number with its point, where the dialect wants one in each."""
        return number + "." * (self.writing.pointed and "." not in number)

    def _centre_origin(self, axis: int) -> int:
        """Return where I, J, K count from: the begin of the arc, or the work zero."""
        return (self.at[axis] or 0) if self.dialect.arc_centres == "absolute" else 0

    def thread(self, name: str, words: list[str], end: tuple[int, int, int]) -> None:
        """Write a threading cycle, which leads to `end`."""
        self._motion = name
        self.line(name, *words)
        self._arrive([*end])

    def cycle_feed(self, feed_mm_min: float) -> str:
        """Return F of a cycle's cuts where it is not in force, else nothing."""
        return self._feed_word(LINE, feed_mm_min)

    def profile_cycle(self, name: str, words: list[str], end: tuple[int, int, int]) -> None:
        """Write a cycle along a profile, which leads to `end`."""
        self.line(name, *words)
        self._motion = ""
        self._arrive([*end])

    def coordinate(self, axis: int, count: int) -> str:
        """Return the word of an absolute coordinate."""
        return f"{AXES[axis]}{self.grid.text(count * (self.x_factor if axis == 0 else 1))}"

    def canned(self, name: str, words: list[str], feed_mm_min: float, end: tuple[int, int, int]) -> None:
        """Write a block of the canned cycle `name`, which leads to `end`."""
        self.select_plane(XY)
        self._motion, self._cycle = name, ""  # this line does not leave the cycle
        self.line(*words, self._feed_word(LINE, feed_mm_min))
        self._cycle = name
        self._arrive([*end])

    def end_cycle(self) -> None:
        """Leave the canned cycle in force, if there is one; every other line does so before it is written."""
        cycle, self._cycle = self._cycle, ""
        if cycle:
            self._motion = "" if self._motion == cycle else self._motion  # a move's line has its own word already
            self.line("G80")

    def begin_in(self, plane: int) -> None:
        """Let a plane be in force that the header has selected."""
        self._plane = plane

    def use_turn_feed(self, rpm: float) -> None:
        """Write the feeds to come in mm a turn at a speed, or in mm a minute where it is 0."""
        if rpm != self.turn_rpm:
            self._feed = self._feed if rpm and self.turn_rpm else ""
            self.turn_rpm = rpm
            self._feeds.clear()

    def select_plane(self, plane: int) -> None:
        """Write the plane word where it is not in force."""
        if plane != self._plane:
            self.line(PLANE_CODES[plane])
            self._plane = plane

    def has_plane(self, plane: int) -> bool:
        """Whether arcs can be written in this plane."""
        return (plane == XY and not self.dialect.is_lathe) or PLANE_CODES[plane] in self.dialect.codes

    def _axes(self, end: Counts) -> list[str]:
        """Return the coordinates that must be written; an axis that the dialect lacks stays where it is."""
        at, stale, own = self.at, self._stale, self._own_axes
        due = [
            axis
            for axis, count in enumerate(end)
            if count is not None and (count != at[axis] or axis in stale)
            if axis in own or (at[axis] is not None and not self.dialect.plasma)
        ]
        if due and self.writing.whole_ends:
            due = sorted({*due, *self._own_axes})
            end = [stays if count is None else count for count, stays in zip(end, at, strict=True)]
        return [self._axis(axis, count) for axis in due if (count := end[axis]) is not None]

    def _axis(self, axis: int, count: int) -> str:
        letter = AXES[axis]
        if letter not in self.dialect.letters:
            what = Text("{dialect} has no axis {letter}", dialect=self.dialect.title, letter=letter)
            value = f"{letter}{self.grid.text(count)}"
            raise ProgramError("axes", what, value=value, advice="lay the work in its axes")
        origin = (self.at[axis] or 0) if self.incremental or self._distance == "incremental" else 0
        return f"{letter}{self.grid.text((count - origin) * (self.x_factor if axis == 0 else 1))}"

    def _name(self, kind: int) -> str:
        if kind == LINE and self._distance == "incremental":
            return "G91"
        code = self._codes[kind]
        return code.name if code else MOTION_NAMES[kind]

    def _distance_word(self, kind: int) -> str:
        """Bring G90 or G91 into force, where these are words for straight feeds; return the one that the move takes."""
        if self.distance == self._distance:
            return ""
        self._distance = self.distance
        self._motion = self._name(LINE)
        if kind == LINE:
            return self._motion
        self.line(self._motion)
        return ""

    def _motion_word(self, kind: int) -> str:
        name = self._name(kind)
        if name == self._motion and kind in self.dialect.repeats:
            return ""
        self._motion = name
        return name

    def _feed_word(self, kind: int, feed_mm_min: float, opens: bool = False) -> str:
        """Return F where it is not in force; `opens`: the block names its motion, which may need F."""
        if self._cut_feed_mm_min or (kind == RAPID and not (self.writing.rapid_feed and feed_mm_min > 0)):
            return ""
        word = self._feeds.get(feed_mm_min) or self._spelled_feed(feed_mm_min)
        code = self._codes[kind]
        if word == self._feed and not (opens and code and "F" in code.needs):
            return ""
        self._feed = word
        return word

    def use_cut_feed(self, feed_mm_min: float) -> None:
        """Take feeds from QtPlasmaC's material, which cuts with `feed_mm_min`; 0: from F words."""
        self._cut_feed_mm_min, self._feed = feed_mm_min, ""
        if feed_mm_min:
            self._feed = CUT_FEED
            self.line(CUT_FEED)

    def share_feed(self, share: float) -> None:
        """Write with which share of the feed in force the next moves run, where another one is."""
        word = "Q0" if share >= 1.0 else f"Q{_trimmed(f'{100 * share:.3f}')}"
        if word != self._share:
            self._share = word
            self.line("M67", "E3", word)

    def _bring_feed(self, kind: int, feed_mm_min: float) -> None:
        """Write feed and share of a move where the material has the feeds; one above its feed is said by F."""
        if kind == RAPID or not self._cut_feed_mm_min:
            return
        share = feed_mm_min / self._cut_feed_mm_min
        word = CUT_FEED if 0 < share <= 1 + SAME_SHARE else self._spelled_feed(feed_mm_min)
        if word != self._feed:
            self._feed = word
            self.line(word)
        self.share_feed(1.0 if share >= 1 - SAME_SHARE else share)

    def _spelled_feed(self, feed_mm_min: float) -> str:
        """Return a feed as a word; raises ProgramError for none, and for one that the digits cannot hold."""
        unit_mm_min = self.turn_rpm or self.dialect.feed_unit_mm_min
        number = self.grid.short(feed_mm_min / unit_mm_min)
        if number in ("", "0") or not feed_mm_min > 0:
            raise ProgramError(
                "no-feed",
                "a cutting move has no feed",
                value=Text("{feed_mm_min:g} mm/min", feed_mm_min=feed_mm_min),
                advice="raise the feed",
            )
        self._check_feed(float(number) * self.grid.unit_mm * unit_mm_min, feed_mm_min)
        word = self._feeds[feed_mm_min] = f"F{self.with_point(number)}"
        return word

    def _check_feed(self, written_mm_min: float, feed_mm_min: float) -> None:
        """Raise ProgramError where the digits that the dialect has make another feed."""
        if abs(written_mm_min - feed_mm_min) > MOST_FEED_ERROR * feed_mm_min:
            what = Text(
                "the digits of {dialect} cannot hold this feed: F would be {written_mm_min:.4g} mm/min",
                dialect=self.dialect.title,
                written_mm_min=written_mm_min,
            )
            limit = f"{100 * MOST_FEED_ERROR:g} % off"
            advice = "write the program in mm, or choose a higher feed"
            raise ProgramError(
                "feed-digits",
                what,
                value=Text("{feed_mm_min:g} mm/min", feed_mm_min=feed_mm_min),
                limit=limit,
                advice=advice,
            )

    def _arrive(self, end: Counts) -> None:
        self.at = [count if count is not None else at for count, at in zip(end, self.at, strict=True)]
        self._stale -= {axis for axis, count in enumerate(end) if count is not None}
