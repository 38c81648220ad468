# SPDX-License-Identifier: LGPL-2.1-or-later
"""The grammar of one line, checked once for each shape.

The *shape* of a line is its text without the numbers of all words but G and M ("G1XYF" for "G1 X2 Y3 F100"). All
that can be said without those numbers (modal groups, missing and unused words, who uses the axis words) is
decided at the shape's first line and kept as a `Plan`; further lines cost two regular expressions.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import (
    ALL_AXES,
    ARC_WORDS,
    AXES,
    CENTRE_WORDS,
    FLOW,
    MOTION_NAMES,
    NO_MOTION,
    ORDER,
    POLAR,
    RS274,
    SPINDLE,
    WORDS_THAT_ACT,
    Code,
)
from CNCStepper.gcode.syntax.words import NUMBER, Word
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID

PLAIN_NUMBER = re.compile(f"(?<=[A-FH-LN-Z]){NUMBER}")  # the number of any word but G and M
ALWAYS_ALLOWED = frozenset("FSTN")
MOTIONS = ["G0", "G1", "G2", "G3"]
MOST_NAMED = 9  # words of a language that a refusal lists
NEVER_SIMPLE = frozenset(("S", "T", *ALL_AXES[3:], *POLAR))  # words with which a line takes the general way
SIMPLE_MOTIONS = (RAPID, LINE, ARC_CW, ARC_CCW)
MOST_PLANS = 4096  # hostile text can have endless shapes; then the plans are forgotten


@dataclass(frozen=True, slots=True)
class Plan:
    """What a line of one shape does.

    slots: letter -> place among the line's plain numbers. codes: in order of execution, the motion's own code
    included. motion: the kind of move made, or NO_MOTION. moves: it has axis (or arc) words for that motion.
    axes: places of X, Y, Z, -1 where absent. further: some of A B C U V W are there. polar: @ or ^ are. machine: G53.
    simple: nothing but a motion, its words, F and N.
    """

    slots: dict[str, int]
    codes: tuple[Code, ...]
    motion: int
    moves: bool
    axes: tuple[int, int, int]
    machine: bool
    simple: bool
    feed: int
    number: int
    further: bool = False
    polar: bool = False

    def has(self, letters: str) -> bool:
        """Whether one of `letters` is among the words."""
        return any(letter in self.slots for letter in letters)


class Grammar:
    """Reads lines of one dialect; keeps the plan of every shape, by the modal motion in force."""

    def __init__(self, dialect: Dialect):
        self.dialect = dialect
        self._plans: dict[int, dict[str, Plan]] = {motion: {} for motion in range(len(MOTION_NAMES))}

    def plans(self, motion: int) -> dict[str, Plan]:
        """Return the plans by shape that hold while `motion` is modal."""
        return self._plans[motion]

    def plan(self, words: list[Word], motion: int) -> Plan:
        """Return the plan of a line's words while `motion` is modal; raises ProgramError."""
        shape = "".join(word.text if word.letter in "GM" else word.letter for word in words)
        plans = self._plans[motion]
        if shape not in plans:
            if len(plans) >= MOST_PLANS:
                plans.clear()
            plans[shape] = self._plan(words, motion)
        return plans[shape]

    def _plan(self, words: list[Word], motion: int) -> Plan:
        slots = self._slots(words)
        codes = self._codes(words)
        codes, moving, moves = self._with_motion(codes, slots, motion)
        self._check_words(codes, slots)
        machine = any(code.name == "G53" for code in codes)
        if machine and moving not in (RAPID, LINE):
            raise ProgramError("machine-move", "G53 needs a G0 or G1 move", value="G53", advice="add G0 or G1")
        acting = [WORDS_THAT_ACT[letter] for letter in "FST" if letter in slots]
        return Plan(
            slots=slots,
            codes=tuple(sorted([*codes, *acting], key=lambda code: ORDER.index(code.step))),
            motion=moving,
            moves=moves,
            axes=tuple(slots.get(axis, -1) for axis in AXES),  # type: ignore[arg-type]
            machine=machine,
            simple=moves and not machine and all(map(self._is_simple, codes)) and not NEVER_SIMPLE & {*slots},
            feed=slots.get("F", -1),
            number=slots.get("N", -1),
            further=not {*ALL_AXES[3:]}.isdisjoint(slots),
            polar=not {*POLAR}.isdisjoint(slots),
        )

    @staticmethod
    def _is_simple(code: Code) -> bool:
        return code.group == "motion" and not code.sets and not code.act and code.motion in SIMPLE_MOTIONS

    def _slots(self, words: list[Word]) -> dict[str, int]:
        """Return letter -> place among the plain numbers, each letter known and once."""
        slots: dict[str, int] = {}
        for position, word in enumerate(words):
            if word.letter in "GM":
                continue
            if word.letter not in self.dialect.letters:
                self._require_no_refused_code(words)
                raise self._refused(
                    word.letter,
                    Text("{dialect} has no word {letter}", dialect=self.dialect.title, letter=word.letter),
                    "unknown-word",
                )
            if word.letter in slots:
                what, advice = Text("{letter} is twice on the line", letter=word.letter), "write it once"
                raise ProgramError("repeated-word", what, value=word.letter, advice=advice)
            if word.letter == "N" and self.dialect.line_number_first and position:
                advice = "write it first, or leave it out"
                raise ProgramError("line-number", "the N word must be the first of its line", value="N", advice=advice)
            slots[word.letter] = len(slots)
        return slots

    def _require_no_refused_code(self, words: list[Word]) -> None:
        """Raise ProgramError for a code that the dialect refuses by name: a strange word may belong to it."""
        for word in words:
            if word.name in self.dialect.refused and word.letter in "GM":
                self._unknown(word.name)

    def _codes(self, words: list[Word]) -> list[Code]:
        """Return the codes of the G and M words, each known and alone in its modal group."""
        codes: dict[str, Code] = {}
        for word in words:
            if word.letter not in "GM":
                continue
            code = self.dialect.codes.get(word.name) or self._unknown(word.name)
            if code.group in codes:
                if self.dialect.cancel_yields and NO_MOTION in (code.motion, codes[code.group].motion):
                    codes[code.group] = code if code.motion != NO_MOTION else codes[code.group]
                    continue
                what = Text(
                    "{code} and {code2} may not share a line: they set the same mode",
                    code=codes[code.group].name,
                    code2=code.name,
                )
                raise ProgramError("modal-conflict", what, value=word.name, advice="write them on two lines")
            codes[code.group] = code
        self._check_together([code.name for code in codes.values()])
        return list(codes.values())

    def _check_together(self, names: list[str]) -> None:
        """Refuse too many M codes, and codes that use a word in two ways."""
        most, count = self.dialect.most_m_codes, sum(name.startswith("M") for name in names)
        if most and count > most:
            what = Text("a line holds {count} M codes", count=count)
            raise ProgramError("m-codes-many", what, limit=str(most), advice="write them on two lines")
        for name in names:
            for other in self.dialect.conflicts.get(name, ()):
                if other in names:
                    what = Text(
                        "{name} and {other} may not share a line: they use the same word", name=name, other=other
                    )
                    raise ProgramError("modal-conflict", what, value=name, advice="write them on two lines")

    def _unknown(self, name: str) -> Code:
        """Say why a code is refused."""
        if name in FLOW and name not in self.dialect.refused:
            raise ProgramError(
                "not-supported",
                Text("{name} {what}", name=name, what=FLOW[name]),
                value=name,
                advice="expand it into plain moves",
            )
        what = Text("{dialect} does not accept {name}", dialect=self.dialect.title, name=name)
        raise self._refused(name, what, "refused-code" if name in RS274 else "unknown-code")

    def _refused(self, name: str, what: str, code: str) -> ProgramError:
        advice = self.dialect.refused.get(name, "take it out")
        known = sorted(self.dialect.letters) if code == "unknown-word" else sorted(self.dialect.codes)
        return ProgramError(code, what, value=name, limit=_named(known), advice=advice)

    def _with_motion(self, codes: list[Code], slots: dict[str, int], modal: int) -> tuple[list[Code], int, bool]:
        """Return the codes with the motion that the axis words belong to, its kind, and whether it moves."""
        users = [code for code in codes if code.axes]
        if len(users) > 1:
            what: str = Text(
                "{user} and {user2} would both use the axis words", user=users[0].name, user2=users[1].name
            )
            raise ProgramError("axis-conflict", what, value=users[1].name, advice="write them on two lines")
        explicit = next((code for code in codes if code.motion is not None), None)
        has_axes = any(axis in slots for axis in ALL_AXES + POLAR)
        has_centre = any(letter in slots for letter in CENTRE_WORDS)
        if users and users[0].group != "motion":
            if has_axes and explicit and users[0].act == "tool_length" and self.dialect.cancel_takes_no_axes:
                what = "a line with G80 takes no axis words, nor those of G43.1"
                raise ProgramError("axis-unused", what, value=_first_axis(slots), advice="write them on two lines")
            if has_axes and self.dialect.axes_need_motion and (explicit or modal == NO_MOTION):
                what = Text(
                    "while G80 is in force {dialect} takes no axis words, nor those of {user}",
                    dialect=self.dialect.title,
                    user=users[0].name,
                )
                raise ProgramError("axis-unused", what, value=_first_axis(slots), advice="write a line G0 before it")
            return codes, NO_MOTION, False
        if users:
            arc = users[0].motion in (ARC_CW, ARC_CCW)
            return codes, users[0].motion or RAPID, has_axes or arc
        if explicit:  # G80
            if has_axes:
                what = "G80 leaves no motion for the axis words"
                advice = "write them on a line of their own, with G0 or G1"
                raise ProgramError("axis-unused", what, value=_first_axis(slots), advice=advice)
            return codes, NO_MOTION, False
        repeats_arc = has_centre and modal in (ARC_CW, ARC_CCW) and self.dialect.centre_repeats_arc
        if has_axes or repeats_arc:
            return [*codes, self._repeated(slots, modal)], modal, True
        machine = self.dialect.machine_word_alone and any(code.name == "G53" for code in codes)
        return codes, modal if machine else NO_MOTION, False

    def _repeated(self, slots: dict[str, int], modal: int) -> Code:
        """Return the code of the modal motion that coordinates alone repeat."""
        code = self.dialect.motion_code(modal)
        if code is None or modal == NO_MOTION:
            raise self._no_motion(_first_axis(slots))
        if modal not in self.dialect.repeats:
            what = Text("coordinates alone may not follow {motion_name}", motion_name=MOTION_NAMES[modal])
            raise ProgramError("no-motion", what, value=_first_axis(slots), advice="write the motion word again")
        return replace(code, sets={}, needs="")  # only the word itself, not its repetition, sets modes

    def _no_motion(self, word: str) -> ProgramError:
        what = "there is no motion that the coordinates could belong to"
        motions = [name for name in MOTIONS if name in self.dialect.codes]
        if motions == MOTIONS:
            return ProgramError("no-motion", what, value=word, advice="write G0, G1, G2 or G3")
        return ProgramError("no-motion", what, value=word, limit=_named(motions), advice="write the motion word again")

    def _check_words(self, codes: list[Code], slots: dict[str, int]) -> None:
        """Refuse missing and unused words."""
        allowed = set(ALWAYS_ALLOWED) | ({SPINDLE} if "S" in slots else set())
        for code in codes:
            allowed |= set(code.takes) | _axis_letters(code)
            for letter in code.needs:
                if letter not in slots:
                    limit = Text("{letter} above 0", letter=letter) if letter == "F" else ""
                    raise ProgramError(
                        "missing-word",
                        Text("{code} needs a {letter} word", code=code.name, letter=letter),
                        value=code.name,
                        limit=limit,
                        advice=Text("add {letter}", letter=letter),
                    )
            if code.axes == "must" and not any(axis in slots for axis in ALL_AXES + POLAR):
                raise ProgramError(
                    "missing-axis", Text("{code} needs X, Y or Z", code=code.name), value=code.name, advice="add one"
                )
        for letter in slots:
            if letter not in allowed:
                what = Text("no code on this line uses the word {letter}", letter=letter)
                raise ProgramError("unused-word", what, value=letter, advice="take it out or add its code")


def _named(words: list[str]) -> str:
    """Return a list of a language's words where it has few: the limit of a refusal."""
    return ", ".join(words) if len(words) <= MOST_NAMED else ""


def _axis_letters(code: Code) -> set[str]:
    """Return the axis words that a code takes; polar ones are for motion only."""
    return set(ALL_AXES + POLAR * (code.group == "motion")) if code.axes else set()


def _first_axis(slots: dict[str, int]) -> str:
    return next((letter for letter in slots if letter in ALL_AXES + POLAR + ARC_WORDS), "")
