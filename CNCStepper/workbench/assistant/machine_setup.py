# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine while it is set up: what answered, the profile it begins from, and the draft of its own; no Qt."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from CNCStepper.control.settings.controller_identity import ControllerIdentity
from CNCStepper.control.settings.settings_profile import profile_from_settings
from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.controller_family import FAMILIES, OWN
from CNCStepper.machine.files.fcm_files import read_fcm
from CNCStepper.machine.files.profile_files import NAME
from CNCStepper.machine.own_profiles import Written, create, profile_content, profile_text, profiles, save
from CNCStepper.machine.profile import Machine, load_machine, profile_names
from CNCStepper.workbench.machines.draft import Draft

BEGIN = "table-a"
MY_MACHINE = "my-machine"


@dataclass(frozen=True)
class StartMachine:
    """A profile to begin from. about: its comment, in the language of the file."""

    profile: str
    machine: Machine
    about: str

    @property
    def text(self) -> str:
        """How it is listed."""
        travel = " × ".join(f"{axis.travel_max_mm - axis.travel_min_mm:g}" for axis in self.machine.own_axes.values())
        return f"{self.machine.name} – {travel} mm"


def start_machines() -> list[StartMachine]:
    """Return the profiles that can be begun from; one that cannot be read is not among them."""
    found = []
    for profile in profiles():
        try:
            machine, text = load_machine(profile.name), profile_text(profile.name)
        except CNCStepperError:
            continue
        found.append(StartMachine(profile.name, machine, about_of(text)))
    return sorted(found, key=lambda start: start.machine.name.lower())


def about_of(text: str) -> str:
    """Return the comment that a profile begins with."""
    lines = []
    for line in text.splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# ").rstrip())
    return "\n".join(lines)


class MachineSetup:
    """See the module; `identity` is None while nothing has answered, `saved` the name once it is saved."""

    def __init__(self) -> None:
        self.identity: ControllerIdentity | None = None
        self.base = BEGIN
        self.saved = ""
        self.draft = Draft(BEGIN, profile_content(BEGIN))

    def begin_from(self, base: str) -> None:
        """Begin from a profile; what was typed before is forgotten."""
        self.base, self.saved = base, ""
        self.draft = Draft(base, profile_content(base))
        self._take_controller()

    def begin_from_fcm(self, path: Path) -> None:
        """Begin from a machine file of FreeCAD's, laid over the profile that is chosen; raises JobError."""
        self._lay(read_fcm(path, profile_content(self.base)))

    def take_settings(self) -> None:
        """Put the values of the controller that answered into the draft."""
        if self.identity:
            content, _ = self.draft.content()
            self._lay(profile_from_settings(content, self.identity.settings))

    def answer(self, identity: ControllerIdentity | None) -> None:
        """Note what answered at the port."""
        self.identity = identity
        self._take_controller()

    @property
    def machine(self) -> Machine | None:
        """The machine of the draft, None while a value is none."""
        content, problems = self.draft.judged()
        return None if problems else Machine.model_validate(content)

    @property
    def is_own_controller(self) -> bool:
        """Whether this computer itself is the controller of the machine."""
        return FAMILIES.get(self.draft.texts[("controller",)].partition(":")[0], "") in OWN

    def proposed_name(self) -> str:
        """Return a free name for the profile, made of the machine's name."""
        plain = re.sub(r"[^a-z0-9]+", "-", self.draft.texts[("name",)].lower()).strip("-")[:50]
        name, names = plain if NAME.fullmatch(plain) else MY_MACHINE, profile_names()
        numbered = (f"{name}-{number}" for number in range(2, len(names) + 3))
        return name if name not in names else next(free for free in numbered if free not in names)

    def save(self, name: str) -> Written:
        """Write the draft as the user's profile; a new one keeps the comments of what it began from.

        Raises JobError for a bad name or value.
        """
        content, _ = self.draft.judged()
        if name not in profile_names():
            create(name, self.base)
        written = save(name, content)
        self.saved = name
        return written

    def _lay(self, content: dict) -> None:
        """Make another content the draft, which counts as typed."""
        self.draft = Draft(self.draft.name, content)

    def _take_controller(self) -> None:
        """Let the draft have the controller that answered, where the machine is one with a firmware of its own."""
        if self.identity and self.identity.controller and not self.is_own_controller:
            self.draft.texts[("controller",)] = self.identity.controller
