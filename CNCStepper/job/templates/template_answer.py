# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a template makes of a drawing, as plain data for a window: the chains of each rule, and the job.

{"file": PATH, "path": PATH, "content": {...}, "make": false}    path: of the template, for the files that it names

{"rules": [TAKEN, ...], "untaken": TAKEN}                        TAKEN: {"count": N, "rows": [...], "curves": ...}
{"job": {...}, "titles": [...], "offset_mm": [X, Y]}             with "make": true; curves as the drawing has them
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import astuple
from pathlib import Path
from typing import Any

from CNCStepper.drawing.chain_list import counts_of
from CNCStepper.drawing.drawing import Chain, Drawing, Share
from CNCStepper.job.cut_transfer import content_of
from CNCStepper.job.drawings.linked_file import FileState, file_state
from CNCStepper.job.drawings.packed_curves import packed_curves
from CNCStepper.job.templates.drawing_job import content_in_place, job_by_template, operation_title, read_by_template
from CNCStepper.job.templates.rules import Assignment, assigned
from CNCStepper.job.templates.template import Template, template_of

Answer = dict[str, Any]
Read = tuple[Path, Any, FileState]
_last: list[tuple[Read, Drawing]] = []  # the drawing that was read last: a rule is changed more often than a drawing


def template_answer(asked: dict[str, Any], share: Share = lambda share: None) -> Answer:
    """Return what a template makes of a drawing; raises JobError for a bad template, drawing or job."""
    template = template_of(asked["content"], Path(asked["path"]))
    file = Path(asked["file"])
    found = assigned(template.rule, _drawing(template, file, share).chains)
    if asked["make"]:
        return _job(template, file, found)
    return {"rules": [_taken(chains) for chains in found.taken], "untaken": _taken(found.untaken)}


def _drawing(template: Template, file: Path, share: Share) -> Drawing:
    read = (file, template.drawing, file_state(file))
    if not _last or _last[0][0] != read:
        _last[:] = [(read, read_by_template(template, file, share))]
    return _last[0][1]


def _taken(chains: Sequence[Chain]) -> Answer:
    rows = [list(astuple(count)) for count in counts_of(chains)]
    return {"count": len(chains), "rows": rows, "curves": packed_curves([chain.curve for chain in chains])}


def _job(template: Template, file: Path, found: Assignment) -> Answer:
    content, offset_mm = content_in_place(template, file, found)
    titles = list(map(operation_title, content["operation"]))
    job = job_by_template(template, content, file.with_suffix(".toml"))
    return {"job": content_of(job), "titles": titles, "offset_mm": list(offset_mm)}
