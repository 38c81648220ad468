# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records on their way to the mini-lathe: chunks, pace, places, and what a hold and a stop can do."""

from __future__ import annotations

import random

import pytest

from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.machine.lathe_link import LatheLink
from CNCStepper.machine.profile import load_machine
from helpers.controllers.lathe_judge import LatheBench

RAPIDS = "N30 G00 X-10. # N40 Z-50. # N50 X5000 Z50. #\nM02 #\n"
FEEDS = "N30 G01X-10. F1. # N40 Z-50. # N50 X5000 Z50. F2500 #\nM02 #\n"


def wire(program: str) -> list[str]:
    return list(prepare(program, "mini-lathe").lines)


def bench_of(**link: float) -> LatheBench:
    machine = load_machine("mini-lathe")
    return LatheBench(machine.model_copy(update={"link": LatheLink(**link)}))


@pytest.mark.parametrize("program", [RAPIDS, FEEDS], ids=["rapids", "feeds"])
def test_the_published_records_go_out_as_they_stand(program: str) -> None:
    bench = LatheBench()
    bench.run(wire(program), step_s=0.01)
    records = "".join(wire(program))
    assert bench.judge.sent.decode("ascii").replace("?", "") == f"Y{records}"
    assert bench.judge.sent.startswith(b"YG0") and bench.judge.sent.endswith(b"M02#?")
    assert bench.judge.sent.count(b"M02") == 1 and bench.judge.is_over
    assert bench.judge.mm == (-9.5, 0.0) and bench.board.places_mm == (-9.5, 0.0, 0.0)
    assert bench.judge.faults == [] and bench.said.count("automatic mode") == 1
    assert bench.said.index("automatic mode") < bench.said.index("ok")


def test_short_records_are_gathered_in_chunks_that_open_with_their_g_word() -> None:
    bench = bench_of(slower=0.0)
    bench.run(wire("G01 Z-.1 F1. # Z-.1 # Z-.1 # Z-.1 #\n" * 10))
    chunks = bench.judge.sent.decode("ascii")[1:].split("?")[:-1]
    assert len(chunks) > 3 and any(chunk.count("#") > 2 for chunk in chunks)
    assert all(chunk.startswith("G01") and chunk.endswith("#") for chunk in chunks)
    assert bench.judge.mm == (0.0, pytest.approx(-4.0)) and bench.judge.faults == []


def test_the_lathe_holds_no_more_than_the_profile_allows_and_is_never_late() -> None:
    seed = random.randrange(10**9)
    print("seed", seed)
    dice = random.Random(seed)
    long = soon = 0
    for number in range(6):
        ways_mm = (0.2, 0.4) if number % 2 else (0.2, 0.5, 3.0)
        ahead_s, ahead_bytes = dice.choice((2.0, 4.0) if number % 2 else (0.5, 2.0, 4.0)), dice.choice((64, 128, 300))
        lines, longest_s = [], 0.0
        for _ in range(40):
            way_mm, feed = dice.choice(ways_mm), dice.choice((0.5, 1.0, 2.0))
            lines.append(f"G01Z{dice.choice('+-')}{way_mm}F{feed}#".replace("+", ""))
            longest_s = max(longest_s, way_mm / feed)
        bench = bench_of(ahead_s=ahead_s, ahead_bytes=ahead_bytes, slower=0.0)
        bench.run(lines, step_s=0.005)
        long, soon = long + (longest_s > ahead_s), soon + (longest_s <= ahead_s)
        assert bench.judge.ahead_bytes <= ahead_bytes
        assert bench.judge.ahead_s <= max(ahead_s, longest_s + 0.3) + 0.1
        assert bench.judge.idle_s < 0.01 and bench.judge.faults == []
        x, z = bench.judge.mm
        assert bench.board.places_mm == pytest.approx((x, 0.0, z))
    assert long and soon


def test_places_on_the_way_follow_the_lathe() -> None:
    bench = bench_of(slower=0.0)
    bench.send("G01X-2.Z-1.F1.#\n", 1.0)
    x, _, z = bench.board.places_mm
    assert x == pytest.approx(-1.0, abs=0.05) and z == pytest.approx(x / 2, abs=0.02)
    status = bench.status()
    assert status["state"] == "Run" and float(status["Left"]) == pytest.approx(1.0, abs=0.1)
    assert status["FS"].startswith("67,")  # the longer axis has the feed of 60
    assert status["Queue"] == "1"  # the line is answered, and under way
    bench.wait(1.5)
    assert bench.status()["Queue"] == "0"
    assert bench.status()["state"] == "Idle" and bench.board.places_mm == (-2.0, 0.0, -1.0)


@pytest.mark.parametrize("byte", [b"!", b"\x18"])
def test_hold_and_reset_say_how_long_the_lathe_runs_on(byte: bytes) -> None:
    bench = bench_of(ahead_s=1.0, slower=0.0)
    for _ in range(10):
        bench.send("G01X-.2F1.#G01X-.2F1.#\n")
    bench.wait(0.5)
    said, sent = bench.send(byte), len(bench.judge.sent)
    assert "[MSG:the lathe cannot be stopped over its link: it runs on for 0." in said
    assert bench.status()["state"] == ("Hold:1" if byte == b"!" else "Run")
    bench.wait(2.0)
    assert len(bench.judge.sent) == sent, "something was sent behind the hold"
    assert bench.status()["state"] == ("Hold:0" if byte == b"!" else "Idle")
    x, z = bench.judge.mm
    assert -2.0 < x < -0.4 and bench.board.places_mm == pytest.approx((x, 0.0, z))
    assert f"to X{x:.3f} Z{z:.3f}]" in said


def test_a_hold_goes_on_where_it_was() -> None:
    bench = bench_of(ahead_s=1.0)
    bench.send("G01X-.2F1.#\n" * 10, 0.5)
    bench.send(b"!", 3.0)
    assert bench.board.state == "Hold:0" and bench.board.quiet
    bench.send(b"~", 5.0)
    assert bench.board.state == "Idle" and bench.judge.mm == (pytest.approx(-2.0), 0.0) and bench.judge.faults == []


def test_a_reset_keeps_the_modes_that_the_lathe_has() -> None:
    bench = bench_of(ahead_s=0.5)
    bench.send("G90#G01X-1.Z0.F1.#\nG91#G01X-1.F1.#\n", 0.2)
    bench.send(b"\x18", 2.0)
    assert bench.judge.sent.endswith(b"G90#G01X-1.Z0.F1.#?") and bench.board.places_mm[0] == -1.0
    bench.send("G01X-3.Z0.F2.#\n", 2.0)
    assert bench.judge.mm[0] == bench.board.places_mm[0] == -3.0 and bench.judge.sent.count(b"Y") == 1


def test_there_is_no_way_back_to_manual_mode() -> None:
    bench = LatheBench()
    bench.send("G01X-.1F1.#\n", 1.0)
    assert bench.board.state == "Idle"
    said = bench.send("$J=G91X1F60\n") + bench.send("G10L20P1X0\n")
    assert said.count("error:9") == 2 and "cannot be jogged: switch the lathe off and on" in said
    assert bench.judge.sent.endswith(b"#?")


def test_behind_m02_nothing_is_taken() -> None:
    bench = LatheBench()
    bench.run(["G01X-.1F1.#", "M02#"])
    assert "its program has ended with M02" in bench.send("G01X-.1F1.#\n") and bench.judge.faults == []
    assert "error:9" in bench.said


@pytest.mark.parametrize(
    ("line", "error"),
    [
        ("G01X-1.#", 22),
        ("X-1.F1.#", 26),
        ("G90#G01X-1.F1.#", 26),
        ("G33Z-1.F1.#", 20),
        ("G01Y1.F1.#", 20),
        ("G01X1.F1.#Z1.", 20),
        ("G01X1.X2.F1.#", 25),
        ("G2X1.Z1.#", 20),
        ("G00X1.#" + "Z1.#" * 3 + "G01Z1.#", 22),
        ("G00X-" + "1" * 70 + ".#", 1),
    ],
)
def test_a_line_that_cannot_be_read_whole_sends_nothing(line: str, error: int) -> None:
    bench = LatheBench()
    assert f"error:{error}\r\n" in bench.send(f"{line}\n") and bench.judge.sent == b""
    bench.run(["G01X-.1F1.#"])
    assert bench.judge.mm[0] == pytest.approx(-0.1)


def test_behind_a_refused_record_nothing_more_goes_out() -> None:
    bench = LatheBench()
    said = bench.send("G01X-1.F1.#\nG01X-1.#\nG01X-1.F1.#\n", 3.0)
    assert "error:22" in said and "error:9" in said and "a record was refused" in said
    assert bench.judge.mm[0] == -1.0
    bench.send(b"\x18")
    bench.run(["G01X-1.F1.#"])
    assert bench.judge.mm[0] == -2.0


def test_a_program_begins_at_the_work_zero() -> None:
    bench = LatheBench()
    bench.send("$J=G91X-1F120\n", 2.0)
    assert "the tool is not at the work zero" in bench.send("G01X-1.F1.#\n") and b"Y" not in bench.judge.sent
    bench.send("G10L20P1X0Z0\n")
    bench.run(["G01X-1.F1.#"])
    assert bench.judge.mm[0] == pytest.approx(bench.board.places_mm[0]) == pytest.approx(-2.0)


@pytest.mark.parametrize(
    ("settings", "program", "x_mm"),
    [
        ("", "G00X-4.#", -4.0),
        (":g20=diameter", "G00X-4.#", -4.0),
        (":g20=diameter", "G20#G00X-4.#", -2.0),
        ("", "G21#G00X-4.#", -2.0),
        ("", "G71#G00X-.1#", -2.5375),  # 203.2 steps
        ("", "G71#G01X-.1F.1#", -2.5375),
    ],
)
def test_units_and_diameters_are_the_dialects(settings: str, program: str, x_mm: float) -> None:
    machine = load_machine("mini-lathe").model_copy(update={"controller": f"mini-lathe{settings}"})
    bench = LatheBench(machine)
    bench.run([program])
    assert bench.board.places_mm[0] == x_mm


def test_a_lathe_that_waits_for_its_index_is_reckoned_to_wait() -> None:
    ends_s = []
    for settings in ("", ":thread_start=index"):
        bench = LatheBench(load_machine("mini-lathe").model_copy(update={"controller": f"mini-lathe{settings}"}))
        bench.run(["G00Z1.#", "G01Z-1.F1.#", "G01Z-1.F1.#"])
        ends_s.append(bench.time_s)
    assert 60 / 90 - 0.1 < ends_s[1] - ends_s[0] < 2 * 60 / 90 + 0.1


def test_a_broken_link_is_said_and_the_position_is_lost() -> None:
    bench = LatheBench()
    bench.send("G01X-1.F1.#\n", 0.3)
    bench.judge.is_cut = True
    said = bench.wait(0.3)
    assert "ALARM:3" in said and "the link to the lathe broke" in said and bench.status()["state"] == "Alarm"
    assert "error:8" in bench.send("$#\n") or bench.board.state == "Alarm"


def test_no_more_lines_wait_than_a_planner_of_grbl_holds() -> None:
    bench = LatheBench()
    said = bench.send("G01X-.5F1.#\n" * 20, 0.3)
    assert said.count("ok") == 15 and bench.status()["Bf"].startswith("15,")
    bench.wait(15.0)
    assert bench.said.count("ok") == 20 and bench.judge.mm[0] == -10.0
