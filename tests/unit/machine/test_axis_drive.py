# SPDX-License-Identifier: LGPL-2.1-or-later
"""Axis arithmetic: the two published problems figure for figure, in the core, at the prompt and in a profile."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from CNCStepper.cli.main import group
from CNCStepper.errors import JobError
from CNCStepper.machine.axis_drive import Drive, answers, shown
from CNCStepper.machine.profile import load_machine

OPEN_LOOP = Drive(screw_pitch_mm=6, gear_ratio=5, steps_per_turn=48)
CLOSED_LOOP = Drive(screw_pitch_mm=6, gear_ratio=5, encoder_pulses_per_turn=48, encoder_gear_ratio=4)
SHIPPED = Path(__file__).parents[3] / "CNCStepper" / "machine" / "profiles" / "table-a.toml"
POSITIVE = st.floats(0.01, 1000)


def test_the_published_open_loop() -> None:
    assert OPEN_LOOP.pulses(250) == 10_000
    assert OPEN_LOOP.motor_rpm(500) == pytest.approx(416.667, abs=5e-4)
    assert OPEN_LOOP.pulse_rate_hz(500) == pytest.approx(333.333, abs=5e-4)
    assert OPEN_LOOP.step_deg == 7.5
    assert OPEN_LOOP.motor_deg(250) == 10_000 * 7.5
    assert OPEN_LOOP.turn_deg(250) == 10_000 * 7.5 / 5


def test_the_published_closed_loop() -> None:
    assert CLOSED_LOOP.closed_loop and not OPEN_LOOP.closed_loop
    assert CLOSED_LOOP.pulses(250) == 8000
    assert CLOSED_LOOP.pulse_rate_hz(500) == pytest.approx(266.667, abs=5e-4)
    assert CLOSED_LOOP.motor_rpm(500) == pytest.approx(416.667, abs=5e-4)


@pytest.mark.parametrize("key", ["steps_per_turn", "gear_ratio", "screw_pitch_mm", "encoder_pulses_per_turn"])
@pytest.mark.parametrize("value", [math.inf, math.nan])
def test_what_is_no_number_is_refused(key: str, value: float) -> None:
    with pytest.raises(ValidationError):
        Drive.model_validate({"screw_pitch_mm": 5, key: value})


def test_a_belt_with_microsteps() -> None:
    belt = Drive(belt_pitch_mm=2, pulley_teeth=20, microsteps=16)
    assert (belt.pulses_per_mm, belt.resolution_mm, belt.travel_per_turn_mm) == (80, 0.0125, 40)
    assert belt.feed_mm_min(25_000) == 18_750
    assert Drive(screw_pitch_mm=5, microsteps=2).pulses_per_mm == 80  # the mini-lathe


@pytest.mark.slow
@given(pitch=POSITIVE, steps=st.floats(1, 1000), gear=POSITIVE, feed=POSITIVE, distance=POSITIVE)
def test_every_formula_has_its_way_back(pitch: float, steps: float, gear: float, feed: float, distance: float) -> None:
    drive = Drive(screw_pitch_mm=pitch, steps_per_turn=steps, gear_ratio=gear)
    assert drive.distance_mm(drive.pulses(distance)) == pytest.approx(distance)
    assert drive.feed_mm_min(drive.pulse_rate_hz(feed)) == pytest.approx(feed)
    assert drive.motor_deg(distance) / drive.step_deg == pytest.approx(drive.pulses(distance))
    assert drive.rpm(feed) * drive.travel_per_turn_mm == pytest.approx(feed)
    assert drive.motor_rpm(feed) * drive.travel_per_motor_turn_mm == pytest.approx(feed)


@pytest.mark.parametrize(
    "keys",
    [
        {},
        {"belt_pitch_mm": 2},
        {"pulley_teeth": 20},
        {"screw_pitch_mm": 5, "belt_pitch_mm": 2, "pulley_teeth": 20},
        {"screw_pitch_mm": 5, "belt_pitch_mm": 2},
        {"screw_pitch_mm": 0},
        {"screw_pitch_mm": 5, "microsteps": 0},
    ],
)
def test_what_cannot_be_a_drive_is_refused(keys: dict[str, float]) -> None:
    with pytest.raises(ValidationError):
        Drive.model_validate(keys)


def test_the_workings_give_the_values() -> None:
    for drive in (OPEN_LOOP, CLOSED_LOOP, Drive(belt_pitch_mm=2.032, pulley_teeth=15, microsteps=8)):
        for answer in answers(drive, 123.456, 789.0):
            working = answer.working.split("=")[-1].replace("·", "*")
            assert eval(working) == pytest.approx(answer.value, rel=1e-8), answer  # our own text of numbers


@pytest.mark.parametrize(
    ("value", "text"), [(10_000.0, "10000"), (416.66667, "416.667"), (0.03125, "0.03125"), (0, "0")]
)
def test_values_are_shown_without_noise(value: float, text: str) -> None:
    assert shown(value) == text


def test_the_prompt_prints_the_published_figures() -> None:
    opened = printed("--screw", "6", "--gear", "5", "--steps", "48", "--distance", "250", "--feed", "500")
    closed = printed(
        "--screw", "6", "--gear", "5", "--encoder", "48", "--encoder-gear", "4", "--distance", "250", "--feed", "500"
    )
    for text, figures in (
        (opened, ("10000", "416.667 rpm", "333.333 Hz")),
        (closed, ("8000", "416.667 rpm", "266.667 Hz")),
    ):
        assert {line.split("= ")[-1] for line in text.splitlines()} >= set(figures)


@pytest.mark.parametrize(
    "arguments",
    [
        (),
        ("--belt", "2"),
        ("--teeth", "20"),
        ("--axis", "x"),
        ("--machine", "table-a", "--axis", "x"),
        ("--machine", "table-a", "--axis", "x", "--screw", "5"),
    ],
)
def test_the_prompt_says_what_is_missing(arguments: tuple[str, ...]) -> None:
    assert CliRunner().invoke(group, ["axis", *arguments]).exit_code == 2


def test_a_profile_gives_the_drive_and_the_steps_follow(tmp_path: Path) -> None:
    path = profile(tmp_path, "", "screw_pitch_mm = 5\nmicrosteps = 2")
    assert load_machine(path).axis["x"].steps_per_mm == 80
    text = printed("--machine", str(path), "--axis", "x")
    assert "at 5000 mm/min" in text and "= 80 1/mm" in text
    calibrated = profile(tmp_path, "steps_per_mm = 79.6", "screw_pitch_mm = 5\nmicrosteps = 2")
    assert load_machine(calibrated).axis["x"].steps_per_mm == 79.6


@pytest.mark.parametrize(
    ("steps", "drive", "told"),
    [
        ("steps_per_mm = 80", "screw_pitch_mm = 5", "steps_per_mm is 80, but the drive gives 40"),
        ("", "screw_pitch_mm = -5", "axis.x.drive.screw_pitch_mm"),
        ("", "pulley_teeth = 5", "axis.x.drive: belt_pitch_mm and pulley_teeth belong together"),
        ("", "pitch_mm = 5", "there is no key axis.x.drive.pitch_mm"),
    ],
)
def test_a_profile_that_contradicts_itself_is_refused(tmp_path: Path, steps: str, drive: str, told: str) -> None:
    with pytest.raises(JobError) as refusal:
        load_machine(profile(tmp_path, steps, drive))
    assert told in refusal.value.what


def profile(folder: Path, steps: str, drive: str) -> Path:
    """Write table A with other steps, and a drive, for X."""
    text = SHIPPED.read_text("utf-8").replace("steps_per_mm = 80", steps, 1)
    path = folder / "machine ç.toml"
    path.write_text(f"{text}\n[axis.x.drive]\n{drive}\n", "utf-8")
    return path


def printed(*arguments: str) -> str:
    result = CliRunner().invoke(group, ["axis", *arguments])
    assert result.exit_code == 0, result.output
    return result.output
