# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of two compared programs as a file: paths of a mill or table, parts and paths of a lathe."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from CNCStepper.job.comparison.compare_programs import ProgramComparison, compared_sections
from CNCStepper.job.comparison.turned_picture import save_turned_comparison
from CNCStepper.job.comparison.turned_picture_words import TURNED_WORDS
from CNCStepper.simulation.views.comparison_picture import save_comparison


def save_picture(
    file: Path, found: ProgramComparison, facts: Sequence[str] = (), words: Mapping[str, str] = TURNED_WORDS
) -> None:
    """Draw what was found as PNG or SVG; words: those of TURNED_WORDS in another language.

    Raises JobError for another kind of file.
    """
    names = Path(found.names[0]).name, Path(found.names[1]).name
    sections = compared_sections(found)
    if sections is None:
        save_comparison(file, found.paths, names, facts, words)
    else:
        save_turned_comparison(file, found.paths, sections, names, facts, words)
