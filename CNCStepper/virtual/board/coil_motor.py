# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which way the coils of a unipolar motor pull its rotor.

    L1 against L2, L3 against L4: the current in two phases, and so the direction of the field

    L3       9 ─── A      forwards:  A 9 5 6 and again        A: L1 and L3   9: L1 and L4   5: L2 and L4   6: L2 and L3
     |       |     |      one coil alone lies between two of them: a half step
    L4       5 ─── 6      both coils of a phase, or no coil, make no field

The rotor turns to the nearest place at which the field holds it. Coils two places on (A then 5) move nothing: the field
pulls neither way. Three places on (A then 6) is one place back. In a wrong order each word moves the rotor by its own
pull, forwards or backwards.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.virtual.motors.rotor import MotorLimits, Rotor

PLACES = 4  # of a whole turn of the field, in full steps
FIRST_WORD = 0x0A
REST_PLACE = -1.0  # a pulse forwards then leads to the sequence's begin


def field_of(coils: int) -> float | None:
    """Return where the coils' field points, in full steps forwards of FIRST_WORD's, 0 to 4; None without a field."""
    l1, l2, l3, l4 = (coils >> bit & 1 for bit in (3, 2, 1, 0))
    one, other = l1 - l2, l3 - l4
    if not (one or other):
        return None
    turn = math.atan2(1, 1) - math.atan2(other, one)
    return round(turn / (math.pi / 2.0), 6) % PLACES


class CoilMotor:
    """A motor whose coils are set one word after another; counts where its rotor is, in full steps.

    stuck: words at which the rotor did not move though the field did.
    """

    def __init__(self, limits: MotorLimits | None = None):
        self.stuck = 0
        self._rotor = Rotor(limits, place=REST_PLACE)
        self._field = REST_PLACE  # unwound: with the turns it has made

    @property
    def steps(self) -> float:
        """Where the rotor is, from where it began."""
        return self._rotor.place - REST_PLACE

    def set_coils(self, at_s: float, coils: int) -> float:
        """Let the coils carry a word from a time on; return the rotor's steps."""
        field, before = field_of(coils), self._rotor.place
        if field is not None:
            ahead = (field - self._field + PLACES / 2) % PLACES - PLACES / 2
            self.stuck += ahead == -PLACES / 2
            self._field += ahead
        self._rotor.turn(np.array([at_s]), np.array([self._field]), np.array([field is not None]))
        if self._rotor.place == before and field is not None and self._field - before == -PLACES / 2:
            self._field = before  # nothing has moved: the next word pulls from here
        return self.steps

    def settle(self, now_s: float) -> float:
        """Let time pass without a change of coils; return the rotor's steps."""
        self._rotor.settle(now_s)
        return self.steps
