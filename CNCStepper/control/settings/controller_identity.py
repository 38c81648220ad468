# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a controller says of itself: firmware, version, board and axes, of the lines that answer `$I`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from CNCStepper.control.protocol.grbl.firmware import GRBL, OWN_FIRMWARES, Firmware, firmware_of_tag
from CNCStepper.control.settings.setting_names import AXES, STEPS_PER_MM
from CNCStepper.errors import Text

_TAGGED = re.compile(r"\[(\w+):(.*)\]")
_SETTING = re.compile(r"\$([0-9]{1,4})=(-?[0-9.]+)")
BOARD_TAGS = ("BOARD", "DRIVER")  # of grblHAL; grbl and FluidNC do not say what they run on


@dataclass(frozen=True)
class ControllerIdentity:
    """What answered; settings: of `$$`, by number."""

    firmware: Firmware = GRBL
    version: str = ""
    board: str = ""
    settings: Mapping[int, float] = field(default_factory=dict)

    @property
    def is_own(self) -> bool:
        """Whether a process of this computer answered, for a machine without a controller of its own."""
        return self.firmware in OWN_FIRMWARES

    @property
    def controller(self) -> str:
        """The name of its controller in a profile; of a process of ours the profile in force says it: ""."""
        return "" if self.is_own else self.firmware.key

    @property
    def axes(self) -> str:
        """The letters of its axes, as its settings have them."""
        return "".join(axis for place, axis in enumerate(AXES) if STEPS_PER_MM + place in self.settings)

    def with_settings(self, settings: Mapping[int, float]) -> ControllerIdentity:
        """Return the same with the settings that were read later."""
        return replace(self, settings=dict(settings))

    @property
    def text(self) -> Text:
        """Firmware, version and board in words."""
        version = self.version or "?"
        if self.board:
            return Text("{name}, version {version}, on {board}", name=self.firmware.name, version=version,
                        board=self.board)  # fmt: skip
        return Text("{name}, version {version}", name=self.firmware.name, version=version)


def identity_of(words: Iterable[str]) -> ControllerIdentity:
    """Return what the lines say that answered `$I` and `$$`; lines that say nothing of it are passed over."""
    firmware, version, boards, settings = GRBL, "", dict[str, str](), dict[int, float]()
    for line in words:
        if setting := _SETTING.fullmatch(line):
            settings[int(setting[1])] = float(setting[2])
        elif tagged := _TAGGED.fullmatch(line):
            tag, text = tagged[1], tagged[2].strip(" :")
            firmware = firmware_of_tag(tag, text) or firmware
            version = text if tag == "VER" else version
            if tag in BOARD_TAGS and text:
                boards[tag] = text
    return ControllerIdentity(
        firmware, version, next((boards[tag] for tag in BOARD_TAGS if tag in boards), ""), settings
    )
