# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's jogs: bytes, ways, and that every one is released."""

from __future__ import annotations

import random

import pytest

from CNCStepper.control.protocol.grbl.firmware import LATHE
from helpers.controllers.lathe_judge import LatheBench

STEP_MM = 1 / 80


@pytest.mark.parametrize(
    ("line", "sent"),
    [
        ("$J=G91G21X-1F120", b"I2.0000?EP"),
        ("$J=G91G21X1F60", b"I1.0000?FP"),
        ("$J=G91G21Z-1F60", b"I1.0000?GP"),
        ("$J=G91G21Z1F60", b"I1.0000?HP"),
        ("$J=G91X-5F2000", b"AP"),
        ("$J=G91X5F2000", b"BP"),
        ("$J=G91Z-5F2000", b"CP"),
        ("$J=G91Z5F2000", b"DP"),
        ("$J=G91G20X-.1F4.7244", b"I2.0000?EP"),
    ],
)
def test_a_jog_is_one_byte_and_its_release(line: str, sent: bytes) -> None:
    bench = LatheBench()
    assert bench.send(f"{line}\n").endswith("ok\r\n") and bench.judge.moves_by_hand
    bench.wait(3.0)
    assert bench.judge.sent == sent and not bench.judge.moves_by_hand and bench.board.state == "Idle"
    assert bench.judge.faults == []


def test_the_way_is_the_one_asked_for_and_its_reckoning_the_lathes_own() -> None:
    seed = random.randrange(10**9)
    print("seed", seed)
    dice = random.Random(seed)
    seen = set()
    for number in range(48):
        bench = LatheBench()
        ways_mm = (0.02, 0.1, 0.2) if number & 1 else (0.4, 1.0, 6.0)
        axis, way_mm = dice.choice("XZ"), (-1 if number & 2 else 1) * dice.choice(ways_mm)
        feed = 1400 if number & 4 else dice.choice((30, 120))
        bench.send(f"$J=G91{axis}{way_mm:.3f}F{feed}\n")
        bench.wait(abs(way_mm) / feed * 60 + 1.0)
        seen.add((feed == 1400, abs(way_mm) < 0.3, way_mm < 0))
        assert bench.board.state == "Idle" and bench.judge.faults == []
        reckoned = bench.board.places_mm[0], bench.board.places_mm[2]
        steps = 4 if feed == 1400 else 0  # a step lasts 0.5 ms there, and this clock counts in 1.5 ms
        asked = way_mm if axis == "X" else 0.0, way_mm if axis == "Z" else 0.0
        for there, wanted, known in zip(bench.judge.mm, asked, reckoned, strict=True):
            assert abs(there - wanted) <= (steps + 1) * STEP_MM and abs(there - known) <= steps * STEP_MM + 1e-9
    assert len(seen) == 8


@pytest.mark.parametrize("byte", [b"\x85", b"!", b"\x18", b"\x84"])
@pytest.mark.parametrize("feed", [120, 2000])
def test_whatever_ends_a_jog_releases_it_at_once(byte: bytes, feed: int) -> None:
    bench = LatheBench()
    bench.send(f"$J=G91X-50F{feed}\n$J=G91Z-50F{feed}\n", 0.4)
    assert bench.status()["state"] == "Jog"
    bench.send(byte, 0.002)
    assert bench.judge.sent.endswith(b"P") and not bench.judge.moves_by_hand
    bench.wait(0.2)
    assert bench.board.state == "Idle" and bench.judge.sent.count(b"P") == 1
    assert bench.judge.mm[0] == pytest.approx(bench.board.places_mm[0], abs=4 * STEP_MM if feed == 2000 else 1e-9)
    assert bench.judge.mm[0] < -0.3


@pytest.mark.parametrize("ends", ["close", "come_to_rest"])
def test_a_controller_that_ends_releases_its_jog(ends: str) -> None:
    bench = LatheBench()
    bench.send("$J=G91X-50F120\n", 0.4)
    assert bench.judge.moves_by_hand and not bench.board.at_rest
    getattr(bench.board, ends)()
    assert bench.judge.sent.endswith(b"P") and not bench.judge.moves_by_hand


def test_pieces_of_a_held_jog_are_one_move() -> None:
    bench = LatheBench()
    for _ in range(8):
        bench.send("$J=G91X-0.1F60\n", 0.05)
    bench.wait(2.0)
    assert bench.judge.sent == b"I1.0000?EP" and bench.judge.mm[0] == pytest.approx(-0.8)


def test_a_held_jog_that_is_faster_than_the_lathe_plans_no_more_than_a_second_ahead() -> None:
    bench = LatheBench()
    for _ in range(40):  # each an ok later, as a sender does it
        said = bench.send("$J=G91X-1F600\n", 0.0)
        while "ok" not in said:
            said = bench.wait(0.05)
        if bench.time_s > 3.0:
            break
    at_mm = bench.judge.writes[-1][0], bench.board.places_mm[0]
    bench.wait(5.0)  # nobody cancels
    assert bench.board.state == "Idle" and bench.judge.sent == b"I2.2046?EP" and at_mm[1] < -3.0
    assert at_mm[1] - 2.2046 * 1.6 < bench.judge.mm[0] < at_mm[1]
    assert bench.said.count("the lathe jogs at up to") == 1


def test_jogs_that_wait_are_answered_and_not_made_when_one_is_cancelled() -> None:
    bench = LatheBench()
    said = bench.send("$J=G91X-9F120\n" * 5, 0.3)
    assert said.count("ok") == 1
    assert bench.send(b"\x85", 1.0).count("ok") == 4
    assert bench.judge.sent == b"I2.0000?EP" and bench.board.state == "Idle" and bench.board.quiet


def test_another_way_waits_for_the_release() -> None:
    bench = LatheBench()
    bench.send("$J=G91X-1F120\n$J=G91Z-1F120\n$J=G91X1F60\n")
    bench.wait(4.0)
    assert bench.judge.sent == b"I2.0000?EPGPI1.0000?FP" and bench.judge.faults == []
    assert bench.judge.mm == pytest.approx((0.0, -1.0)) and bench.board.places_mm == pytest.approx((0.0, 0.0, -1.0))


@pytest.mark.parametrize(
    ("line", "error"),
    [("X1Z1F60", 16), ("Y1F60", 16), ("X1", 22), ("F60", 26), ("X1X1F60", 25), ("X1F60M3", 16)],
)
def test_a_jog_that_the_lathe_cannot_make_is_refused(line: str, error: int) -> None:
    bench = LatheBench()
    assert f"error:{error}\r\n" in bench.send(f"$J=G91{line}\n") and bench.judge.sent == b""


def test_why_a_diagonal_jog_is_refused_is_said_in_the_lathes_own_words() -> None:
    assert "one axis, X or Z" in LATHE.error(16).meaning


def test_a_feed_beyond_the_motors_start_is_the_slower_one_and_said() -> None:
    bench = LatheBench()
    assert "[MSG:the lathe jogs at up to 132 mm/min" in bench.send("$J=G91X-1F600\n", 1.0)
    assert bench.judge.sent.startswith(b"I2.2046?E")


def test_an_absolute_jog_counts_from_the_zero_that_was_set_by_hand() -> None:
    bench = LatheBench()
    bench.send("$J=G91X-2F120\n", 2.0)
    assert "ok" in bench.send("G10L20P1X10Z5\n")
    bench.send("$J=G90X9F120\n", 2.0)
    status = bench.status()
    assert bench.judge.mm[0] == pytest.approx(-3.0) and status["WCO"] == "-12.000,0.000,-5.000"
    assert status["MPos"] == "-3.000,0.000,0.000"


def test_nothing_is_sent_before_somebody_asks() -> None:
    bench = LatheBench(note="the port is opened 8N1")
    bench.send("$I\n$$\n$#\n$G\n\n?", 1.0)
    assert bench.judge.sent == b"" and "[MSG:the port is opened 8N1]" in bench.said
    assert "[FIRMWARE:CNCStepper lathe]" in bench.said
    for what in ("hold", "stop", "override", "resume"):
        assert f"[CANNOT:{what}]" in bench.said
