# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialects by name; each is one small definition in a file of its own.

A dialect with settings is named with them: `mach:dwell=ms`, `mini-lathe:g20=diameter,g70=inch`; `dialect_options`
has those that every dialect takes.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from types import MappingProxyType

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.definition import ArcRule, Dialect, Writing
from CNCStepper.gcode.dialects.dialect_options import with_machine_setting
from CNCStepper.gcode.dialects.fanuc_lathe import FANUC_LATHE
from CNCStepper.gcode.dialects.fluidnc import FLUIDNC
from CNCStepper.gcode.dialects.grbl import GRBL
from CNCStepper.gcode.dialects.grblhal import GRBLHAL
from CNCStepper.gcode.dialects.iso import ISO
from CNCStepper.gcode.dialects.linuxcnc import LINUXCNC
from CNCStepper.gcode.dialects.mach import MACH
from CNCStepper.gcode.dialects.mach_turn import MACH_TURN
from CNCStepper.gcode.dialects.marlin import MARLIN
from CNCStepper.gcode.dialects.mini_lathe import MINI_LATHE
from CNCStepper.gcode.dialects.qtplasmac import QTPLASMAC
from CNCStepper.gcode.dialects.thesis_a import THESIS_A

__all__ = ["ArcRule", "Dialect", "Writing", "dialect", "dialect_named", "dialect_names"]

_ALL = (GRBL, GRBLHAL, FLUIDNC, LINUXCNC, QTPLASMAC, MACH, MARLIN, ISO, THESIS_A, MINI_LATHE, FANUC_LATHE, MACH_TURN)
_DIALECTS = {one.name: one for one in _ALL}


def dialect_names() -> list[str]:
    """Return the names of all dialects, without settings."""
    return sorted(_DIALECTS)


def dialect(name: str | Dialect) -> Dialect:
    """Return the dialect called `name`, with its settings (a Dialect is returned as it is).

    Raises ProgramError when there is no such dialect or setting.
    """
    return name if isinstance(name, Dialect) else _named(name)


dialect_named = dialect  # for functions that have an argument called `dialect`


def _changed(
    chosen: Dialect, codes: Mapping = MappingProxyType({}), writing: Mapping | None = None, **fields
) -> Dialect:
    """Return a dialect with some codes, some fields of its writing and some of its own changed."""
    if writing and chosen.writing:
        fields["writing"] = replace(chosen.writing, **writing)
    return replace(chosen, codes={**chosen.codes, **codes}, **fields)


@lru_cache(256)
def _named(name: str) -> Dialect:
    base, _, settings = name.partition(":")
    if base not in _DIALECTS:
        what = Text("there is no dialect '{base}'", base=base)
        raise ProgramError(
            "unknown-dialect",
            what,
            advice=Text("use one of: {dialect_names}", dialect_names=", ".join(dialect_names())),
        )
    return _with_settings(_DIALECTS[base], settings, name)


def _with_settings(plain: Dialect, settings: str, name: str) -> Dialect:
    """Return `plain` with what `settings` ("key=value,key=value") changes."""
    chosen = plain
    for setting in settings.split(",") if settings else ():
        key, _, value = setting.partition("=")
        narrowed = with_machine_setting(chosen, key, value)
        if narrowed is not None:
            chosen = narrowed
            continue
        values = plain.settings.get(key, {})
        if value not in values:
            known = [f"{key}={value}" for key, values in plain.settings.items() for value in values]
            what = Text("{plain} has no setting '{setting}'", plain=plain.title, setting=setting)
            raise ProgramError(
                "unknown-dialect", what, advice=Text("use one of: {known}", known=", ".join(known) or "none")
            )
        chosen = _changed(chosen, **values[value])
    return replace(chosen, name=name) if settings else plain
