# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keys of relays, what a machine cannot do at all, and the sounds: as the dock's model has them."""

from __future__ import annotations

import sys
import wave
from io import BytesIO
from pathlib import Path

import pytest

from CNCStepper.control.protocol.grbl.capabilities import reason
from CNCStepper.workbench.dock.model.button_states import RULES, ControllerSnapshot, does, why_not, why_not_axis
from CNCStepper.workbench.dock.model.relay_keys import Lines, sound_between
from CNCStepper.workbench.services.sounds import ALARM, FOLDER, NAMES, PAUSE

ROOT = Path(__file__).parents[4]


def test_lines_go_out_one_by_one_and_none_after_a_refusal() -> None:
    lines = Lines()
    lines.put(["M9", "M7"])
    assert lines.due() == "M9" and lines.is_out and lines.due() == ""
    lines.answered(True)
    assert lines.due() == "M7"
    lines.put(["M8", "M3"])
    lines.answered(False)
    assert lines.due() == "" and not lines.is_out
    lines.put(["M8"])
    assert lines.due() == "M8"
    lines.forget()
    assert not lines.is_out and lines.due() == ""


@pytest.mark.parametrize(
    ("word", "controls"),
    [
        ("hold", {"hold"}),
        ("resume", {"resume"}),
        ("stop", set()),
        ("override", {"override"}),
        ("jog", {"jog"}),
        ("jog-hold", {"aside"}),
        ("back", {"back", "forward"}),
        ("home", {"home"}),
    ],
)
def test_what_a_machine_cannot_do_is_said_whatever_it_does(word: str, controls: set[str]) -> None:
    for phase in ("idle", "running", "held", "paused", "alarm", "jogging"):
        moment = ControllerSnapshot(phase, "Idle", job=phase == "running", cannot=(word,))
        free = ControllerSnapshot(phase, "Idle", job=phase == "running")
        assert {control for control in RULES if why_not(control, moment) == reason(word)} == controls
        assert {control for control in RULES if why_not(control, moment) != why_not(control, free)} == controls


@pytest.mark.parametrize("axis", ["y", "z"])
def test_an_axis_that_a_machine_lacks_is_named_at_its_arrows(axis: str) -> None:
    moment = ControllerSnapshot("idle", "Idle", cannot=(f"axis-{axis}",))
    assert why_not("jog", moment) == ""
    assert axis.upper() in why_not_axis(axis, moment)
    assert [other for other in "xyz" if why_not_axis(other, moment)] == [axis]


def test_a_stop_that_does_not_reach_the_machine_can_be_pressed_and_says_so() -> None:
    moment = ControllerSnapshot("running", job=True, cannot=("stop",))
    assert why_not("stop", moment) == "" and does("stop", moment) == reason("stop")
    assert does("stop", ControllerSnapshot("running", job=True)) == RULES["stop"].does


def test_relays_are_switched_while_idle_only() -> None:
    assert why_not("relay", ControllerSnapshot("idle")) == ""
    assert "only while the machine is idle" in why_not("relay", ControllerSnapshot("running", job=True))


def test_alarm_and_pause_are_heard_once_and_a_new_connection_is_silent() -> None:
    idle, alarm, paused = (ControllerSnapshot(phase) for phase in ("idle", "alarm", "paused"))
    running = ControllerSnapshot("running", job=True)
    assert sound_between(running, alarm) == ALARM and sound_between(running, paused) == PAUSE
    assert sound_between(alarm, alarm) == "" == sound_between(paused, running) == sound_between(idle, running)
    assert sound_between(ControllerSnapshot("connecting"), alarm) == ""


def test_every_sound_is_there_short_and_as_its_script_writes_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "tools"))
    monkeypatch.delitem(sys.modules, "sounds", raising=False)
    import sounds

    assert set(sounds.SOUNDS) == set(NAMES)
    assert len({(FOLDER / f"{name}.wav").read_bytes() for name in NAMES}) == len(NAMES)
    for name, tones in sounds.SOUNDS.items():
        path = FOLDER / f"{name}.wav"
        with wave.open(str(path)) as file, wave.open(BytesIO(sounds.sound(tones))) as own:
            assert 0.2 < file.getnframes() / file.getframerate() < 1.0
            pairs = zip(file.readframes(file.getnframes()), own.readframes(own.getnframes()), strict=True)
            assert max(abs(one - other) for one, other in pairs) <= 1, "another libm may round another way"
