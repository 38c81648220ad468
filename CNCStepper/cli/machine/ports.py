# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper ports`: lists serial ports, and the controllers that answer there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.machine.service_client import profile_option
from CNCStepper.errors import CNCStepperError, Text, joined
from CNCStepper.machine.controller_family import BAUD

if TYPE_CHECKING:
    from CNCStepper.control.protocol.grbl.connect import ControllerInfo
    from CNCStepper.control.protocol.grbl.driver import Grbl
    from CNCStepper.control.protocol.grbl.timeouts import Timing


@click.command("ports", cls=Verb)
@click.option("--ask", "asked", multiple=True, metavar="PORT", help="Ask what answers at this port or URL; repeatable.")
@click.option("--baud", type=click.IntRange(min=300), default=BAUD, show_default=True)
@profile_option
@click.pass_context
def command(context: click.Context, asked: tuple[str, ...], baud: int, machine: str) -> None:
    """List the serial ports of this computer, or say what answers at each port given with --ask.

    A controller is asked with `?`, `$I`, `$$`, `$#` and `$G`, which change nothing; but many boards restart when their
    port is opened, so do not ask one that is cutting. Over a network give its URL: socket://HOST:PORT,
    telnet://HOST (port 23), rfc2217://HOST:PORT. Exit status 1 when one of the ports given does not answer.
    """
    if not asked:
        _list_ports()
        return
    answers = [_ask(port, baud, machine) for port in asked]
    context.exit(0 if all(answers) else 1)


def _list_ports() -> None:
    from CNCStepper.control.transport.link import port_list

    choices = port_list()
    for choice in choices:
        show_text(choice.text)
    if not choices:
        show_text("no serial port is there: plug the controller in, or give its URL (socket://HOST:PORT)", err=True)


def _ask(port: str, baud: int, profile: str) -> bool:
    """Print what answers at a port; return whether something did."""
    from CNCStepper.control.protocol.grbl.driver import Grbl
    from CNCStepper.control.protocol.grbl.timeouts import Timing
    from CNCStepper.control.transport.link import opener_of

    try:
        link = opener_of(profile)(port, baud)
        try:
            driver = Grbl(link)
            told = _meet(port, driver, Timing())
        finally:
            link.close()
    except CNCStepperError as error:
        show_text("{port}: {error}", port=port, error=error)
        return False
    show_text("{port}: {told}", port=port, told=told)
    return True


def _meet(port: str, driver: Grbl, timing: Timing) -> str:
    """Return what answers in words; one that moves is not asked what it is."""
    from CNCStepper.control.protocol.grbl.connect import has_greeting, learn, wake_up

    woken = wake_up(driver, timing, locked=True)
    assert driver.status
    state = driver.status.name
    if driver.status.state not in ("Idle", "Alarm"):
        return Text("a controller in the state {state}, which is not disturbed", state=state)
    found = learn(driver, timing, has_greeting(woken))
    _note_position(port, driver, found.greeted)
    return joined(", ", (_told(found, driver.window + 1), state))


def _note_position(port: str, driver: Grbl, greeted: bool) -> None:
    """Keep for the next connection that the position is unknown, where the controller has restarted or is locked."""
    from CNCStepper.control.service.position_trust_file import PositionTrustFile
    from CNCStepper.control.session.files import session_folder
    from CNCStepper.control.stream.position_trust import trust_at_connect

    kept = PositionTrustFile.of_port(session_folder(), port)
    kept.keep(trust_at_connect(kept.trust, driver, greeted))


def _told(found: ControllerInfo, receive_bytes: int) -> str:
    words = [f"{found.firmware.name} {found.version}", Text("{count} bytes of receive buffer", count=receive_bytes)]
    if found.settings.get(13):
        words.append(Text("reports in inches ($13=1)"))
    if found.greeted:
        words.append(Text("it restarted when its port was opened"))
    return joined(", ", words)
