# SPDX-License-Identifier: LGPL-2.1-or-later
"""`hold`, `stop`, `back` and `jog` at a machine that cannot: each says so at once and does not wait for the end."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from CNCStepper.cli.job import hold, stop
from CNCStepper.cli.recovery import back
from CNCStepper.control.protocol.grbl.capabilities import check_can
from CNCStepper.control.service import connection_session
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.errors import CNCStepperError, MachineRefusal
from CNCStepper.recovery.retract.retract_client import step_aside

CANNOT = ("back", "hold", "stop")
RUNNING = replace(SenderStatus(phase="running"), total=4, cannot=CANNOT)


class Job:
    """A session that runs for ever and refuses: like the real one, `status` drops the events that came before."""

    outcome = None

    def __init__(self) -> None:
        self.asked: list[str] = []
        self._events: list[dict[str, Any]] = []
        self._polls = 0

    def __enter__(self) -> Job:
        return self

    def __exit__(self, *error: object) -> None:
        pass

    def status(self) -> SenderStatus:
        self._pass()
        self._events.clear()
        return RUNNING

    def hold(self) -> None:
        self._refuse("hold")

    def stop(self) -> None:
        self._refuse("stop")

    def poll(self, wait_s: float) -> list[dict[str, Any]]:
        self._pass()
        events, self._events = self._events, []
        return events

    def _pass(self) -> None:
        self._polls += 1
        assert self._polls < 30, "it waits for ever"

    def _refuse(self, command: str) -> None:
        self.asked.append(command)
        try:
            check_can(command, CANNOT)
        except CNCStepperError as error:
            self._events.append({"event": "refused", "command": command, "text": str(error), "error": error})


@pytest.mark.parametrize(
    ("verb", "options", "asked", "said"),
    [
        (hold.command, [], ["hold"], "its link has no such command"),
        (stop.command, [], ["stop"], "no further line is sent"),
        (back.command, ["--distance", "1"], [], "cannot go back along its cut"),
    ],
    ids=["hold", "stop", "back"],
)
def test_a_verb_says_at_once_that_the_machine_cannot(
    verb: Any, options: list[str], asked: list[str], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    job = Job()
    attach: Callable[[Path], Job] = lambda file: job  # noqa: E731
    monkeypatch.setattr(connection_session, "attach", attach)
    result = CliRunner().invoke(verb, [*options, "--session", str(tmp_path / "a job ç.session")])
    assert result.exit_code == 1 and said in result.output + str(result.exception), result.output
    assert job.asked == asked


def test_a_jog_does_not_advise_a_hold_that_the_machine_cannot_do() -> None:
    with pytest.raises(MachineRefusal, match="cannot be held while its program runs"):
        step_aside(Job())  # type: ignore[arg-type]
