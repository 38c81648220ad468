# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples that a newcomer opens: job files of this project, each as a document of its own."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from CNCStepper.workbench import packages
from CNCStepper.workbench.document.job_opening import JobOpening
from CNCStepper.workbench.services.translation import later, tr

FOLDER = packages.ROOT / "examples" / "jobs"


@dataclass(frozen=True)
class Example:
    """A job file, and what it shows."""

    file: str
    title: str

    @property
    def path(self) -> Path:
        """Where it is."""
        return FOLDER / self.file


EXAMPLES = (
    Example("sign.toml", later("Sign: letters, a pocket and an outline with tabs")),
    Example("gasket-plasma.toml", later("Gasket: cut out of sheet by plasma")),
    Example("plate.toml", later("Plate: holes, pockets and a contour")),
    Example("rib-wire.toml", later("Wing rib: out of foam by a hot wire")),
    Example("lathe-shaft.toml", later("Shaft: turned on a lathe")),
    Example("brazil-engraving.toml", later("Engraving: a map along a point list")),
)


def open_example(example: Example) -> Any:
    """Return a new document in which an example is opened, as one undo step, while the window goes on."""
    import FreeCAD

    document = FreeCAD.newDocument(example.path.stem)
    JobOpening(document, example.path, tr(example.title)).begin()
    return document
