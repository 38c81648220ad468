# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which family a profile's controller belongs to, and the profile's interpolation."""

from __future__ import annotations

import pytest

from CNCStepper.gcode.dialects import dialect_names
from CNCStepper.job.make_certificate import machine_digest
from CNCStepper.machine.controller_family import FAMILIES, OWN, family_of, makes_pulses
from CNCStepper.machine.profile import Machine, load_machine, profile_names


def of(controller: str, **changes: object) -> Machine:
    """Return table-a with another controller."""
    return Machine.model_validate(load_machine("table-a").model_dump() | {"controller": controller} | changes)


@pytest.mark.parametrize(("controller", "family"), FAMILIES.items())
def test_family_follows_from_the_controller(controller: str, family: str) -> None:
    assert family_of(of(controller)) == family
    assert makes_pulses(of(controller)) == (family in ("parport", "board"))


@pytest.mark.parametrize("controller", ["linuxcnc", "mach", "marlin", "iso", "qtplasmac", "fanuc-lathe", "mach-turn"])
def test_languages_of_foreign_controllers_have_no_family(controller: str) -> None:
    assert controller in dialect_names() and family_of(of(controller)) == ""


def test_no_profile_has_no_family() -> None:
    assert family_of(None) == "" and not makes_pulses(None)


def test_language_of_the_wire_is_the_programs_own_but_for_machines_whose_pulses_we_make() -> None:
    table = load_machine("thesis-table")
    assert table.language() == "thesis-a:z=none,spindle=always,feed=900"
    assert table.wire_language() == "grbl:z=none,spindle=switch,feed=900,outputs=pins"
    assert of("usb-board").language() == "grbl:outputs=pins" == of("usb-board").wire_language("linuxcnc")
    assert of("mini-lathe").wire_language() == "mini-lathe" and of("grbl").wire_language() == "grbl"


def test_shipped_profiles_have_the_families_of_their_controllers() -> None:
    families = {name: family_of(load_machine(name)) for name in profile_names()}
    assert families["thesis-table"] == "parport" and families["table-a"] == "grbl"
    assert set(OWN) < set(FAMILIES.values())


def test_interpolation_that_is_not_named_leaves_certificates_as_they_were() -> None:
    plain, chosen = of("thesis-a"), of("thesis-a", interpolation="dda")
    assert "interpolation" not in plain.model_dump() and chosen.model_dump()["interpolation"] == "dda"
    assert machine_digest(plain) != machine_digest(chosen)
    assert Machine.model_validate(chosen.model_dump()).interpolation == "dda"
