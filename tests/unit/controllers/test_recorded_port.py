# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole way in real time: sender's link, controller's process, player's process, and a port that is recorded."""

from __future__ import annotations

import time
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest

from CNCStepper.control.transport.link import Link, open_link
from CNCStepper.errors import LinkError
from helpers.controllers.recorded_port import pulses_of
from helpers.controllers.thesis_programs import line_pulses, moves_of

STEPS_PER_MM, FEED = 10, 24_000
PROFILE = f"""
name = "Quick table"
controller = "thesis-a"
interpolation = "{{}}"
processes = ["hot-wire"]
feed_mm_min = {FEED}
rapid_mm_min = {FEED}
tool_change = "split"
tool_length = "none"
[planner]
junction_deviation_mm = 0.02
arc_tolerance_mm = 0.002
[signals]
motors = ["x", "y"]
""" + "".join(
    f"""
[axis.{axis}]
steps_per_mm = {STEPS_PER_MM}
max_rate_mm_min = {FEED}
acceleration_mm_s2 = 4000
travel_min_mm = -500
travel_max_mm = 500
"""
    for axis in "xy"
)
LIMIT_S = 60.0
ALL_OFF = (0, 0b1011)  # data and control: the port itself inverts pins 1, 14 and 17


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    return tmp_path / "port.csv"


@pytest.fixture(params=["planner", "dda"])
def link(request: pytest.FixtureRequest, tmp_path: Path, recording: Path) -> Iterator[Link]:
    profile = tmp_path / "quick.toml"
    profile.write_text(PROFILE.format(request.param), "utf-8")
    opened = open_link(f"record:{recording}", machine=str(profile))
    until(opened, b"help]\r\n")
    yield opened
    opened.close()


def until(link: Link, end: bytes) -> bytes:
    said, end_s = b"", time.monotonic() + LIMIT_S
    while end not in said:
        assert time.monotonic() < end_s and b"error" not in said, said
        said += link.read(0.1)
    return said


def send(link: Link, *lines: str) -> None:
    """Send lines one after another, and wait until the machine is idle."""
    for line in lines:
        link.write(line.encode("ascii") + b"\n")
        until(link, b"ok\r\n")
    while b"<Idle" not in status(link):
        time.sleep(0.01)


def status(link: Link) -> bytes:
    link.write(b"?")
    return until(link, b">\r\n")


@pytest.mark.slow
@pytest.mark.parametrize(("number", "rate"), [(1, 1000), (2, 10_000), (3, 25_000), (4, 25_000)])
def test_a_thesis_program_comes_out_of_the_port_pulse_for_pulse(
    number: int, rate: int, tmp_path: Path, recording: Path
) -> None:
    per_mm, feed = rate // 500, 30_000  # 500 mm/s
    text = PROFILE.format("dda").replace(f"steps_per_mm = {STEPS_PER_MM}", f"steps_per_mm = {per_mm}")
    profile = tmp_path / "quick.toml"
    profile.write_text(text.replace(str(FEED), str(feed)).replace("= 4000", "= 20_000"), "utf-8")
    link = open_link(f"record:{recording}", machine=str(profile))
    moves = moves_of(number)
    try:
        until(link, b"help]\r\n")
        send(link, f"G21G90G94F{feed}", *(move.words() for move in moves))
    finally:
        link.close()
    pulses = pulses_of(recording)
    waits_s = [after[0] - before[0] for before, after in pairwise(pulses)]
    late_ms = 1000 * (max(waits_s) - 1 / rate)
    print(f"program {number} at {rate} pulses/s: {len(pulses)} pulses, the longest wait {late_ms:.1f} ms over")
    assert sorted(waits_s)[len(waits_s) // 2] == pytest.approx(1 / rate, rel=0.6), "it was cut at about its rate"
    first = 0
    for move in moves:
        end = tuple(round(way * per_mm) for way in move.end)
        count = next(n for n in range(1, len(pulses) - first + 1) if pulses[first + n - 1][3] == end)
        cut = pulses[first : first + count]
        if move.centre is None:
            way = tuple(round((b - a) * per_mm) for a, b in zip(move.begin, move.end, strict=True))
            assert [pulse[1:3] for pulse in cut] == line_pulses(way)
        assert max(move.distance((x / per_mm, y / per_mm)) for *_, (x, y) in cut) <= 1 / per_mm
        first += count
    assert first == len(pulses)


def test_a_hold_brakes_and_no_pulse_is_lost(link: Link, recording: Path) -> None:
    link.write(f"G21G90G94G1X300Y100F{FEED}\n".encode())
    until(link, b"ok\r\n")
    time.sleep(0.4)
    link.write(b"!")
    while b"Hold:0" not in (said := status(link)):
        time.sleep(0.002)
    place = [float(value) for value in said.split(b"MPos:")[1].split(b"|")[0].split(b",")]
    time.sleep(0.3)
    link.write(b"~")
    send(link, "G4P0")
    link.close()
    pulses = pulses_of(recording)
    assert pulses[-1][3] == (3000, 1000)
    stood = max(range(1, len(pulses)), key=lambda row: pulses[row][0] - pulses[row - 1][0])
    assert [steps / STEPS_PER_MM for steps in pulses[stood - 1][3]] == pytest.approx(place[:2], abs=1e-6)
    times_s = [time_s for time_s, *_ in pulses[:stood]]  # one that came late has the next one close behind it
    fastest = max(50 / (after - before) for before, after in zip(times_s, times_s[50:], strict=False))
    assert 5 / (times_s[-1] - times_s[-6]) < 0.35 * fastest, "it was slow before it stood"


def test_a_controller_that_is_killed_leaves_a_machine_that_brakes_with_everything_off(
    link: Link, recording: Path
) -> None:
    send(link, "M8")
    link.write(f"G21G90G94G1X300Y100F{FEED}\n".encode())
    until(link, b"ok\r\n")
    time.sleep(0.4)
    link._port._process.kill()
    with pytest.raises(LinkError) as lost:
        until(link, b"never")
    assert lost.value.code == "link-lost"
    end_s = time.monotonic() + LIMIT_S
    while _last_registers(recording) != ALL_OFF or not pulses_of(recording):  # it begins with all off
        assert time.monotonic() < end_s, _last_registers(recording)
        time.sleep(0.05)
    pulses = pulses_of(recording)
    assert pulses[-1][3][0] < 3000
    waits_s = [after[0] - before[0] for before, after in pairwise(pulses)]
    assert min(waits_s[-5:]) > 2 * min(waits_s), "it was slow before it stood"


def _last_registers(recording: Path) -> tuple[int, ...]:
    """Return the registers of the last whole row, () where there is none yet."""
    rows = recording.read_text("utf-8").rpartition("\n")[0].splitlines()[1:]
    return tuple(map(int, rows[-1].split(",")[1:])) if rows else ()


def test_relays_leave_the_port_as_it_was(link: Link, recording: Path) -> None:
    send(link, "M8", "G4P0.1", "M3S1", "G4P0.1", "M9", "G4P0.1", "M5")
    link.close()
    rows = recording.read_text("utf-8").splitlines()[1:]
    registers = [tuple(map(int, row.split(",")[1:])) for row in rows]
    assert len(set(registers)) >= 4 and registers[-1] == ALL_OFF
