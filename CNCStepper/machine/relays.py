# SPDX-License-Identifier: LGPL-2.1-or-later
"""The relays of a machine: what can be switched by hand, under the names that its people have for it."""

from __future__ import annotations

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.controller_family import family_of
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.wiring import DEVICES, Relay
from CNCStepper.safe_text import printable


def relays_of(machine: Machine) -> tuple[Relay, ...]:
    """Return the relays that the profile names; where it names none, one for each device that it has.

    A device is there when it has a pin of its own in `signals.pins`, or else by the profile's spindle and coolant. The
    mini-lathe's link has no byte for one.
    """
    if family_of(machine) == "lathe":
        return ()
    if machine.relay:
        return machine.relay
    wired: list[str] = [device for device in DEVICES if device in machine.signals.pins]
    has_power = machine.has_spindle or machine.switches_power
    usual: list[str] = [*(["spindle_cw"] if has_power else []), *machine.outputs.coolant]
    return tuple(Relay.model_validate({"name": device, "device": device}) for device in wired or usual)


def relay_named(machine: Machine, name: str) -> Relay:
    """Return the relay of that name; raises JobError where there is none."""
    found = next((relay for relay in relays_of(machine) if relay.name == name), None)
    if found is None:
        names = ", ".join(relay.name for relay in relays_of(machine))
        raise JobError(
            "no-relay",
            Text("{machine} has no relay '{name}'", machine=machine.name, name=printable(name, 40)),
            advice=Text("there are: {names}", names=names or "none"),
        )
    return found
