# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper machine-test` at a virtual controller: what moves, what is measured, what is written."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from CNCStepper.control.operator.machine_test_lines import (
    arrivals,
    both_sides,
    check_no_power,
    check_room,
    circle,
    is_on,
    modes_back,
    outputs_of,
    square,
    switching,
)
from CNCStepper.errors import JobError, MachineRefusal
from CNCStepper.machine.own_profiles import change
from CNCStepper.machine.profile import load_machine
from helpers.cli.command_line import called
from helpers.control.virtual_process import virtual_grbl


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    with virtual_grbl(speed=20.0) as address:
        yield address


def on_bench(address: str, *words: object, answer: str = "") -> str:
    options = ("--port", address, "--machine", "table-a")
    result = called("machine-test", *map(str, words), *options, answer=answer)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def place(address: str) -> tuple[float, float, float]:
    """Return where the controller stands, by its own words."""
    result = called("console", "--port", address, answer="?\nquit\n")
    found = re.search(r"machine X(\S+) Y(\S+) Z(\S+)", result.stdout)
    assert found, result.stdout + result.stderr
    return float(found[1]), float(found[2]), float(found[3])


def test_pulses_go_as_far_as_the_profile_says_and_back(address: str) -> None:
    x, y, z = place(address)
    assert "X: 400 pulses forward" in on_bench(address, "pulses", "x", 400)
    way_mm = 400 / load_machine("table-a").axis["x"].steps_per_mm
    assert place(address) == pytest.approx((x + way_mm, y, z), abs=0.02)
    on_bench(address, "pulses", "x", 400, "--back")
    assert place(address) == pytest.approx((x, y, z), abs=0.02)


def test_a_square_and_a_circle_end_where_they_began_and_leave_the_modes(address: str) -> None:
    def modes() -> str:
        said = called("console", "--port", address, answer="G18\n$G\nquit\n").stdout
        return next(line for line in said.splitlines() if "[GC:" in line)

    before, began = modes(), place(address)
    assert "square of 20 mm" in on_bench(address, "square", "--side", 20, "--height", 5, "--feed", 2000)
    assert "circle of 10 mm" in on_bench(address, "circle", "--diameter", 10, "--feed", 2000)
    assert place(address) == pytest.approx(began, abs=0.02)
    assert modes() == before and "G18" in before


def test_relays_are_switched_one_by_one_and_a_circle_waits_for_the_power_to_be_off(address: str) -> None:
    said = on_bench(address, "relays", "--seconds", 0.1)
    assert (
        said.split("\n")[:2] == ["spindle_cw: switched on", "spindle_cw: switched off"]
        and "flood: switched on\nflood: switched off" in said
    )
    unknown = called("machine-test", "relays", "oxygen", "--port", address, "--machine", "table-a")
    assert unknown.returncode == 1 and "has no relay 'oxygen'" in unknown.stderr
    called("console", "--port", address, answer="M3S1000\nquit\n")
    on = called("machine-test", "circle", "--port", address, "--machine", "table-a")
    called("console", "--port", address, answer="M5\nquit\n")
    assert on.returncode == 1 and "switch it off first: M5" in on.stderr


def test_inputs_are_printed_at_each_change(address: str) -> None:
    assert "inputs that are on: none" in on_bench(address, "inputs", "--seconds", 0.3)


def test_travel_is_measured_corrected_and_written_where_that_is_wanted(address: str, tmp_path: Path) -> None:
    steps = load_machine("table-a").axis["x"].steps_per_mm
    plot = tmp_path / "x.png"
    answers = "9.9\n50\n9.91\n9.89\ny\nn\n"
    said = on_bench(address, "travel", "x", "--length", 10, "--repeats", 3, "--plot", plot, answer=answers)
    assert "mean 9.9000 mm, standard deviation 0.0100 mm" in said
    assert f"steps_per_mm {steps:g} becomes {steps * 10 / 9.9:.4f}".rstrip("0") in said
    assert load_machine("table-a").axis["x"].steps_per_mm == pytest.approx(steps * 10 / 9.9, abs=1e-4)
    assert plot.read_bytes().startswith(b"\x89PNG")


def test_travel_that_is_right_changes_nothing(address: str) -> None:
    said = on_bench(address, "travel", "y", "--length", 10, "--repeats", 2, answer="10\n10\n")
    assert "within the readings' scatter" in said and "write" not in said


def test_backlash_is_measured_from_both_sides_and_written(address: str) -> None:
    said = on_bench(address, "backlash", "y", "--repeats", 2, "--yes", answer="0\n0.1\n0.02\n0.12\n")
    assert "Y: backlash 0.1000 mm (profile: 0 mm)" in said
    assert load_machine("table-a").axis["y"].backlash_mm == 0.1


def test_squareness_drives_the_corners_and_says_the_angle(address: str) -> None:
    began = place(address)
    said = on_bench(address, "squareness", "--x", 30, "--y", 40, answer="50.1\n")
    assert "+0.2390°" in said and place(address) == pytest.approx(began, abs=0.02)
    said = on_bench(address, "squareness", "--x", 30, "--y", 40, "--diagonals", answer="50\n50\n")
    assert "is 90.0000°" in said


# --- the lines by themselves ------------------------------------------------------------------


def test_a_measured_length_is_begun_in_its_own_sense_and_ends_where_it_began() -> None:
    for length in (10.0, -10.0):
        start, along, home = arrivals("x", length, 0.5, 600)
        lengths = [float(line.split("X")[1].split("F")[0]) for line in (*start, *along, *home)]
        assert lengths[1] * length > 0 and abs(lengths[1]) == 2.5 and lengths[2] == length
        assert sum(lengths) == pytest.approx(0)


def test_both_sides_come_to_the_same_place() -> None:
    below, above = both_sides("z", 5, 300)
    assert below == ["$J=G91G21Z-5.0000F300.0", "$J=G91G21Z5.0000F300.0"] and above == below[::-1]


def test_a_square_closes() -> None:
    assert len(square(20, 600)) == 4 and len(set(square(20, 600))) == 4
    assert len(circle(123.4567, 20000)) <= 70


def test_modes_are_put_back_as_they_were_said() -> None:
    assert modes_back("[GC:G2 G54 G18 G20 G90 G94 M5 M9 T0 F12.5 S0]") == "G0G18G20G90G94F12.5"
    assert modes_back("[GC:G0 G54 G17 G21 G91 G93 M5 M9 T0 F0 S0]") == "G0G17G21G91G93"
    with pytest.raises(MachineRefusal):
        modes_back("ok")


def test_what_is_on_is_read_from_the_modes() -> None:
    assert outputs_of("[GC:G0 G54 G17 G21 G90 G94 M4 M7 M8 T0 F0 S0]") == "CMF"
    check_no_power("[GC:G0 G54 G17 G21 G90 G94 M5 M8 T0 F0 S0]")
    with pytest.raises(MachineRefusal):
        check_no_power("[GC:G0 G54 G17 G21 G90 G94 M3 M9 T0 F0 S0]")


def test_travel_is_checked_only_where_the_place_is_known() -> None:
    machine = load_machine("table-a")
    check_room(machine, None, "x", 0, 1e6)
    check_room(machine, (-50.0, 0.0, 0.0), "x", -350, 50)
    for low, high in ((-350.1, 0), (0, 50.1)):
        with pytest.raises(JobError) as refused:
            check_room(machine, (-50.0, 0.0, 0.0), "x", low, high)
        assert refused.value.code == "test-travel" and "-350.000 to 50.000 mm" in refused.value.limit


def test_relays_switch_by_the_programs_words() -> None:
    machine = load_machine("table-a")
    assert switching(machine, "flood", True) == ["M8"]
    assert switching(machine, "flood", False, "SFM") == ["M9", "M7"]
    assert switching(machine, "mist", False, "SM") == ["M9"]
    assert switching(machine, "spindle_cw", True) == [f"M3S{machine.spindle.max_rpm:g}"]
    assert switching(load_machine("wire-table"), "spindle_ccw", False) == ["M5"]
    assert switching(machine, "output_2", True) == ["M64P2"] and switching(machine, "output_2", False) == ["M65P2"]
    assert [is_on("flood", "SF"), is_on("mist", "SF"), is_on("flood", None), is_on("output_0", "")] == [
        True,
        False,
        None,
        None,
    ]


def test_relays_come_from_the_profile_else_from_its_pins_else_from_what_it_has() -> None:
    from CNCStepper.machine.relays import relays_of

    names = [relay.name for relay in relays_of(load_machine("torch-table"))]
    assert names[0] == "spindle_cw"
    pins = {"x_step": 2, "x_direction": 3, "output_0": -14, "flood": 1}
    wired = change("torch-table", {("signals", "pins"): pins}).machine
    assert [relay.device for relay in relays_of(wired)] == ["flood", "output_0"]
    named = change("torch-table", {("relay",): [{"name": "plasma", "device": "spindle_cw"}]}).machine
    assert [relay.name for relay in relays_of(named)] == ["plasma"]
