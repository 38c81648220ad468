# SPDX-License-Identifier: LGPL-2.1-or-later
"""Making our objects anew while a person types.

FreeCAD's own recompute of a document runs its progress bar, which takes the keys that are typed meanwhile away from the
field that they are meant for. An object alone is made without it.
"""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.base import proxy_type


def remake(document: Any) -> None:
    """Make those of our objects that have changed, and ours that stand on them, each after what it stands on."""
    made: set[str] = set()
    for obj in reversed(document.TopologicalSortedObjects):
        changed = "Touched" in obj.State or any(part.Name in made for part in obj.OutList)
        if proxy_type(obj) and changed:
            obj.recompute()
            obj.purgeTouched()
            made.add(obj.Name)
