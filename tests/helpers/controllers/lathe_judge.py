# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lathe that judges what it is sent: it reads the published bytes on its own and moves step by step.

It shares nothing with the controller of the product: waits, records and the line's times are written out again here.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import accumulate

from CNCStepper.controllers.lathe.board import LatheBoard
from CNCStepper.errors import LinkError
from CNCStepper.machine.profile import Machine, load_machine

TICK_S = 135e-6
LIST = [101, 42, 32, 27, 24, 22, 20, 19, 18, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4]
PER_MM = 80.0
BYTE_S = 11 / 9600
WAYS = {"A": (0, -1), "B": (0, 1), "C": (1, -1), "D": (1, 1)}
WAYS |= {slow: WAYS[fast] for slow, fast in zip("EFGH", "ABCD", strict=True)}
WORD = re.compile(r"([A-Z])([-+]?[0-9.]+)")


class LatheJudge:
    """The lathe at the end of a port; places: steps of X and Z. It moves when it is asked where it is."""

    def __init__(self, clock: Callable[[], float], note: str = ""):
        self.note = note
        self.sent = b""
        self.writes: list[tuple[float, bytes]] = []
        self.places = [0, 0]
        self.is_automatic = self.is_over = self.is_cut = False
        self.faults: list[str] = []
        self.ahead_s = self.ahead_bytes = 0.0  # the most that was ever in it
        self.idle_s = 0.0  # that it stood between two records of a program
        self.free_s = 0.0  # when the program's records so far are done
        self._clock, self._there_s = clock, 0.0
        self._chunk = self._number = ""
        self._jog: tuple[str, float] | None = None
        self._feed_mm_s = 0.0
        self._absolute = False
        self._zero = [0, 0]
        self._held: list[tuple[float, int]] = []  # end and bytes of records not done

    # a port

    def write(self, data: bytes) -> None:
        if self.is_cut:
            raise LinkError("link-lost", "the link to the lathe broke: cut")
        self.sent += data
        self.writes.append((self._clock(), data))
        for byte in data.decode("ascii"):
            self._there_s = max(self._there_s, self._clock()) + BYTE_S
            self._hear(byte)

    def check(self) -> None:
        if self.is_cut:
            raise LinkError("link-lost", "the link to the lathe broke: cut")

    def close(self) -> None:
        self.note = "closed"

    # a lathe

    @property
    def mm(self) -> tuple[float, float]:
        """Where X and Z stand once all that was sent is done."""
        return self.places[0] / PER_MM, self.places[1] / PER_MM

    @property
    def moves_by_hand(self) -> bool:
        return self._jog is not None

    def _hear(self, byte: str) -> None:
        if self.is_over:
            self.faults.append(f"{byte} behind M02")
        elif self.is_automatic:
            self._chunk += byte
            if byte == "?":
                self._run(self._chunk)
                self._chunk = ""
        else:
            self._by_hand(byte)

    def _by_hand(self, byte: str) -> None:
        if self._jog:
            if byte == "P":
                self._stop(*self._jog)
            else:
                self.faults.append(f"{byte} while it jogs")
        elif self._number:
            self._number += byte
            if byte == "?":
                self._feed_mm_s, self._number = float(self._number[1:-1]), ""
        elif byte == "I":
            self._number = byte
        elif byte in WAYS:
            self._jog = (byte, self._there_s)
        elif byte == "Y":
            self.is_automatic, self._zero = True, list(self.places)
        elif byte != "P":
            self.faults.append(f"{byte} by hand")

    def _stop(self, byte: str, begin_s: float) -> None:
        self._jog = None
        axis, sense = WAYS[byte]
        after_s, steps = self._there_s - begin_s, 0
        if byte in "ABCD":
            at = 0.0
            while (at := at + LIST[min(steps, 22)] * TICK_S) <= after_s:
                steps += 1
            steps += min(steps, 23)
        else:
            steps = int(after_s / (round(1 / (self._feed_mm_s * PER_MM * TICK_S)) * TICK_S))
        self.places[axis] += sense * steps

    def _run(self, chunk: str) -> None:
        if not re.match(r"[GM]", chunk):
            self.faults.append(f"a chunk does not open with its G word: {chunk}")
        if not chunk.endswith("#?"):
            self.faults.append(f"a record does not end: {chunk}")
        motion, feed = "", 0.0
        for record in chunk[:-1].split("#")[:-1]:
            words = WORD.findall(record)
            for letter, number in words:
                if letter == "G" and int(number) in (90, 91):
                    self._absolute, motion = int(number) == 90, ""
                elif letter == "G":
                    motion, feed = number, 0.0
                self.is_over = self.is_over or (letter, number) == ("M", "02")
            values = {letter: value_of(number) for letter, number in words if letter in "XZF"}
            feed = values.get("F", feed)
            self._move(record, int(motion or -1), feed, values)

    def _move(self, record: str, motion: int, feed_mm_s: float, values: dict[str, float]) -> None:
        ways = [0, 0]
        for axis, letter in enumerate("XZ"):
            if letter in values:
                steps = int((values[letter] * PER_MM + 0.5) // 1)
                ways[axis] = steps - (self.places[axis] - self._zero[axis]) if self._absolute else steps
        count = max(map(abs, ways))
        if count and motion not in (0, 1):
            self.faults.append(f"no motion is in force: {record}")
            return
        if count and motion == 1 and not feed_mm_s:
            self.faults.append(f"G01 without F: {record}")
            return
        waits = [LIST[min(k, count - 1 - k, 22)] for k in range(count)]
        if motion == 1 and count:
            waits = [round(1 / (feed_mm_s * PER_MM * TICK_S))] * count
        if self.free_s and count:
            self.idle_s += max(0.0, self._there_s - self.free_s)
        self.free_s = max(self.free_s, self._there_s) + ([0, *accumulate(waits)][-1]) * TICK_S
        self.places = [place + way for place, way in zip(self.places, ways, strict=True)]
        self._note_held(len(record) + 1)

    def _note_held(self, size: int) -> None:
        now_s = self._clock()
        self._held = [(end_s, held) for end_s, held in self._held if end_s > now_s] + [(self.free_s, size)]
        self.ahead_bytes = max(self.ahead_bytes, sum(held for _, held in self._held))
        begin_s = now_s if len(self._held) < 2 else self._held[0][0]
        self.ahead_s = max(self.ahead_s, self.free_s - (begin_s if len(self._held) < 2 else now_s))


def value_of(number: str) -> float:
    """Return a number, in 1/10000 where it has no point."""
    return float(number) if "." in number else int(number) / 10_000


class LatheBench:
    """A board at a judge, on a clock of their own."""

    def __init__(self, machine: Machine | None = None, note: str = ""):
        self.time_s = 0.0
        self.judge = LatheJudge(lambda: self.time_s, note)
        self.board = LatheBoard(machine or load_machine("mini-lathe"), self.judge)
        self.said = self.board.take_output().decode("ascii")

    def wait(self, seconds: float, step_s: float = 0.0015) -> str:
        """Let time pass as the process of a controller does; return what was said."""
        end_s = self.time_s + seconds
        while self.time_s < end_s:
            self.time_s += step_s
            self.board.advance(step_s)
        said = self.board.take_output().decode("ascii")
        self.said += said
        return said

    def send(self, text: str | bytes, seconds: float = 0.01) -> str:
        """Send lines or real-time bytes; return what was said within a time."""
        self.board.receive(text if isinstance(text, bytes) else text.encode("ascii"))
        return self.wait(seconds)

    def run(self, lines: list[str], limit_s: float = 3000.0, step_s: float = 0.0015) -> None:
        """Send lines as a sender that waits for each `ok`, and wait for the end of the motion."""
        end_s = self.time_s + limit_s
        for line in lines:
            said = self.send(f"{line}\n", step_s)
            while "ok" not in said:
                assert "error" not in said, said
                assert self.time_s < end_s, "no answer"
                said += self.wait(10 * step_s, step_s)
        while self.board.state != "Idle":
            self.wait(20 * step_s, step_s)
            assert self.time_s < end_s, "no end"

    def status(self) -> dict[str, str]:
        """Return the fields of a status; its state as "state"."""
        text = next(line for line in self.send(b"?").splitlines() if line.startswith("<"))
        state, *fields = text[1:-1].split("|")
        return {"state": state} | {name: value for name, _, value in (field.partition(":") for field in fields)}
