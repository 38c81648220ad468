# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of the cycles in docs/pictures/cycles anew, each from the proven program of its example job.

In both languages; then look at them. Part of `make pictures`; with names of cycles only those.
"""

from __future__ import annotations

import sys

from manual import CATALOGUES, DOCS, Catalogue
from worked_parts import CHOICES, JOBS, keep_pictures, work_table

from CNCStepper.workbench.help.topics import OBJECT_TOPICS

KEPT = DOCS / "pictures" / "cycles"
JOB_FILES = {path.stem: path for path in [*sorted((JOBS / "cycles").glob("*.toml")), JOBS / "elliptical-pocket.toml"]}
TITLES = CHOICES | {topic.picture: topic.title for topic in OBJECT_TOPICS}


def keep(name: str) -> None:
    """Make, prove and draw one example job; ends with its findings when it may not be cut."""
    titles = {language: Catalogue(language).tr(TITLES[name]).capitalize() for language in CATALOGUES}
    keep_pictures(work_table(JOB_FILES[name]), KEPT / f"{name}.png", titles)


if __name__ == "__main__":
    for chosen in sys.argv[1:] or JOB_FILES:
        keep(chosen)
