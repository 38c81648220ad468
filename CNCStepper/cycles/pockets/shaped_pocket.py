# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pockets of a given shape have in common: they are pockets with one outline, cut by any pattern."""

from __future__ import annotations

from CNCStepper.cycles.pockets.pocket import Pocket, PocketCycle
from CNCStepper.geometry.curve import Curve


class ShapedPocket(PocketCycle):
    """A pocket without drawn outlines; a cycle that derives from this draws its own."""

    def _as_pocket(self, outline: Curve) -> Pocket:
        """Return the pocket with that outline and the keys of this one."""
        keys = {name: getattr(self, name) for name in PocketCycle.model_fields}
        return Pocket(**keys, outlines=(outline,))
