# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that a CNCStepper controller lacks, as texts: the controller reports them at connection.

[CANNOT:hold] of `$I`  ──►  driver.cannot  ──►  SenderStatus.cannot, `check_can`, warnings before a job
"""

from __future__ import annotations

from collections.abc import Iterable

from CNCStepper.errors import MachineRefusal, Text

CANNOT_CODE = "cannot"
SWITCH = "press the machine's own switch, or let it run to its end"
ANOTHER_AXIS = "name an axis that it has"
REASONS: dict[str, tuple[str, str]] = {  # of each word of [CANNOT:...]: why not, and what to do
    "hold": ("this machine cannot be held while its program runs: its link has no such command", SWITCH),
    "resume": ("this machine cannot be resumed over its link", "use the machine's own buttons"),
    "stop": (
        "this machine cannot be stopped while it runs the lines that it has",
        "press the machine's switch; no further line is sent",
    ),
    "override": ("this machine's speeds cannot be changed while its program runs", "change F in the program"),
    "jog": ("this machine cannot be jogged from here", "use the machine's own buttons"),
    "jog-hold": ("this machine cannot be jogged while a program is held", "stop the program, then jog"),
    "axis-y": ("this machine has no Y axis", ANOTHER_AXIS),
    "axis-z": ("this machine has no Z axis", ANOTHER_AXIS),
    "back": ("this machine cannot go back along its cut", "restart the program at a line before it"),
    "home": ("this machine cannot find its own zero", "move the tool to the work zero and set it there"),
    "probe": ("this machine has no probe", "set the zero by hand"),
    "position": (
        "this machine does not report its position: it is calculated from the lines sent",
        "look at the machine",
    ),
}
OF_PROGRAMS = frozenset(REASONS) - {"home", "probe", "jog", "axis-y", "axis-z"}  # that matter while a program runs
NEEDS: dict[str, tuple[str, ...]] = {  # the ability that each command needs
    "hold": ("hold",),
    "resume": ("resume",),
    "stop": ("stop",),
    "override": ("override",),
    "jog": ("jog",),
    "jog_on": ("jog",),
    "home": ("home",),
    "tell_place": ("back",),
    "retrace": ("back",),
    "want_back": ("back",),
}


def reason(word: str) -> str:
    """Return why a machine lacks the function that a word of [CANNOT:...] names, for a button's tooltip."""
    why, what_to_do = _reason(word)
    return Text("{why}: {what_to_do}", why=why, what_to_do=what_to_do)


def missing(command: str, cannot: Iterable[str]) -> str:
    """Return the first word of `cannot` that a command needs, "" where the machine can do it."""
    return next((word for word in NEEDS.get(command, ()) if word in cannot), "")


def check_can(command: str, cannot: Iterable[str]) -> None:
    """Raise MachineRefusal for a command of which the machine cannot do what it needs."""
    if word := missing(command, cannot):
        why, what_to_do = _reason(word)
        raise MachineRefusal(CANNOT_CODE, why, value=word, advice=what_to_do)


def own_axes(cannot: Iterable[str]) -> str:
    """Return the axes that the machine has: "XYZ", or "XZ" of a lathe."""
    return "".join(axis for axis in "XYZ" if axis_word(axis) not in cannot)


def axis_word(axis: str) -> str:
    """Return the word of [CANNOT:...] for an axis that a machine lacks."""
    return f"axis-{axis.lower()}"


def check_axes(axes: Iterable[str], cannot: Iterable[str]) -> None:
    """Raise MachineRefusal that names the first of `axes` that the machine lacks."""
    if word := next((axis_word(axis) for axis in axes if axis_word(axis) in cannot), ""):
        why, what_to_do = _reason(word)
        raise MachineRefusal(CANNOT_CODE, why, value=word, advice=what_to_do)


def _reason(word: str) -> tuple[str, str]:
    return REASONS.get(word) or (
        Text("this machine cannot do this: {word}", word=word),
        "use the machine's own buttons",
    )
