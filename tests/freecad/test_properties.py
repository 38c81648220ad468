# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of our document objects stay those that saved documents hold; a golden file a kind, a line a property.

The lines are in the order of the panel's rows.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest

from CNCStepper.workbench.features.base import Property, value_of
from CNCStepper.workbench.features.catalogue import KINDS
from CNCStepper.workbench.features.freehand import Freehand
from CNCStepper.workbench.features.job import Job
from CNCStepper.workbench.features.tool import Tool


def line(obj: Any, entry: Property) -> str:
    """Return a property as FreeCAD has it: key, name, type, group, choices, value, whether it counts; its texts."""
    fields = (
        entry.key, entry.name, obj.getTypeIdOfProperty(entry.name), obj.getGroupOfProperty(entry.name),
        obj.getEnumerationsOfProperty(entry.name), value_of(obj, entry), "output" if entry.output else "input",
        (entry.only[0], sorted(entry.only[1])) if entry.only else (), entry.plane, obj.getEditorMode(entry.name),
        entry.label, obj.getDocumentationOfProperty(entry.name),
    )  # fmt: skip
    return json.dumps(fields, ensure_ascii=False, default=str) + "\n"


@pytest.mark.parametrize("kind", [Job, Tool, Freehand, *KINDS], ids=lambda kind: kind.Type)
def test_the_properties_are_those_of_saved_documents(
    document: Any, kind: Any, golden: Callable[[str, str], None]
) -> None:
    obj = document.addObject("Part::FeaturePython" if kind is Freehand else "App::FeaturePython", "Object")
    kind(obj)
    golden(f"properties/{kind.Type}.txt", "".join(line(obj, entry) for entry in kind.PROPERTIES))
