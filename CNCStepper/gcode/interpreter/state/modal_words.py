# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modes that no row of the table shows, as words: how corners are followed, where cycles retract to, overrides."""

from __future__ import annotations

from collections.abc import Set

from CNCStepper.gcode.interpreter.state.modal_state_stack import modes_of, path_words
from CNCStepper.gcode.interpreter.state.model import Model

PATH_MODES, RETRACT_MODES = frozenset(("G61", "G61.1", "G64")), frozenset(("G98", "G99"))
OVERRIDES = frozenset(("M48", "M49", "M50", "M51"))
OVERRIDE_WORDS = {  # by whether feed and spindle may be overridden; a program begins with both
    (True, True): "M48",
    (True, False): "M51 P0",
    (False, True): "M50 P0",
    (False, False): "M49",
}


def modal_words(model: Model, said: Set[str]) -> tuple[str, ...]:
    """Return the words of those modes in force that a program names; `said`: the names of its words."""
    modes = modes_of(model)
    path = (path_words(modes),) if said & PATH_MODES else ()
    retract = ("G98" if model.to_initial else "G99",) if said & RETRACT_MODES else ()
    allowed = "feed" in modes.overrides, "speed" in modes.overrides
    return *path, *retract, *((OVERRIDE_WORDS[allowed],) if said & OVERRIDES else ())
