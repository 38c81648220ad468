# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one place where a part's own coordinates become those of a program, and back.

    part      z = 0 the finished end face, z < 0 towards the chuck; r the radius
    program   X = r - zero_r_mm (the table and all that reads it hold radii), Z = z_sign (z - zero_z_mm)

A controller whose programs begin at the work zero has it where the tool is then; Z of the mini-lathe falls away from
the chuck, so that its sign is -1.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Placement:
    """Where the program's zero lies in the part's coordinates, mm, and the sign of its Z."""

    zero_z_mm: float = 0.0
    zero_r_mm: float = 0.0
    z_sign: float = 1.0

    def program(self, z_mm: float, r_mm: float) -> tuple[float, float, float]:
        """Return X (a radius), Y and Z of the program for a place of the part."""
        return r_mm - self.zero_r_mm, 0.0, self.z_sign * (z_mm - self.zero_z_mm)

    def mirrored(self) -> Placement:
        """Return the placement of a part that is the mirror image in z: the program is that of the part itself."""
        return Placement(-self.zero_z_mm, self.zero_r_mm, -self.z_sign)

    def part(self, ends_mm: np.ndarray) -> np.ndarray:
        """Return (z, r) in the part's coordinates of places in the program's, float64[n, 3] to float64[n, 2]."""
        ends = np.asarray(ends_mm, float)
        return np.column_stack([ends[:, 2] * self.z_sign + self.zero_z_mm, ends[:, 0] + self.zero_r_mm])

    @property
    def mirrors(self) -> bool:
        """Whether arcs change their direction."""
        return self.z_sign < 0
