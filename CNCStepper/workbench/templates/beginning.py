# SPDX-License-Identifier: LGPL-2.1-or-later
"""The beginning of a new job by a template of the shop, whatever machine it is of; no Qt.

template's file ──► of_template ──► values and tools that nobody has typed ──► those of the template
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.job.templates.template_files import template_paths
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.processes import is_turning
from CNCStepper.workbench.features.base import edit, entry_of, is_job, values


def shop_choices(*, of_lathe: bool) -> list[tuple[str, str]]:
    """Return paths and names of the shop's templates: of a lathe, or all others, those that cannot be read too."""
    return [(str(path), path.stem) for path in template_paths() if _is_of_lathe(path) is of_lathe]


def _is_of_lathe(path: Path) -> bool:
    try:
        return is_turning(read_toml(path))
    except CNCStepperError:
        return False


class Beginning:
    """What a new job has begun with, so that another beginning takes its place; what a person has changed stays.

    KEYS: of a job, that a template gives. FEEDS: of a tool, that count as untyped while they have their default or 0.
    """

    KEYS: tuple[str, ...] = ()
    FEEDS: tuple[str, ...] = ()

    def __init__(self, job: Any):
        self.job = job
        self.usual = self._values()
        self._given = dict(self.usual)  # what no person has typed
        self._tools = {each.Name: values(each) for each in job.Tools}

    def of_template(self, path: Path) -> tuple[Any, dict[str, Any]]:
        """Return what a template begins, with its tools, and the values of the job's object.

        Raises CNCStepperError for a template that cannot be used.
        """
        raise NotImplementedError

    def add_tool(self, tool: Any) -> None:
        """Add a tool of a template."""
        raise NotImplementedError

    def add_first_tool(self) -> None:
        """Add the tool that a job has which begins with no template."""
        raise NotImplementedError

    def follow(self, tools: Sequence[Any]) -> None:
        """Let tools that stay follow the job."""

    def take(self, path: str) -> None:
        """Begin with a template's file, or with what is preferred (""); raises CNCStepperError and changes nothing."""
        model, given = self.of_template(Path(path)) if path else (None, {})
        present = self._values()
        typed = {key for key in present if present[key] != self._given[key]}
        self._edit({key: value for key, value in (self.usual | given).items() if key not in typed})
        now = self._values()
        self._given |= {key: now[key] for key in now if key not in typed}
        self._take_tools(model.tool if model is not None else ())

    def _values(self) -> dict[str, Any]:
        found = values(self.job)
        return {key: found[key] for key in self.KEYS}

    def _edit(self, changes: dict[str, Any]) -> None:
        before = values(self.job)
        edit(self.job, **changes)
        try:
            self.job.Proxy.check(self.job)
        except CNCStepperError:
            edit(self.job, **{key: before[key] for key in changes})
            raise

    def _take_tools(self, tools: Sequence[Any]) -> None:
        """Put tools in place of those that nobody has changed; where the job has none then, a new one."""
        job = self.job
        gone = [each for each in job.Tools if not self._is_typed(each)]
        kept = [each for each in job.Tools if each not in gone]
        job.Tools = kept
        for each in gone:
            job.Document.removeObject(each.Name)
        self.follow(kept)
        for each in tools:
            taken = {tool.Number for tool in job.Tools}
            number = max(taken) + 1 if each.number in taken else each.number
            self.add_tool(each.model_copy(update={"number": number}))
        if not job.Tools:
            self.add_first_tool()
        self._tools |= {each.Name: values(each) for each in job.Tools if each not in kept}

    def _is_typed(self, tool: Any) -> bool:
        """Return whether a person has added or changed a tool, or cuts with it; feeds by the material are no change."""
        before, now = self._tools.get(tool.Name), values(tool)
        if before is None or any(not is_job(user) for user in tool.InList):
            return True
        usual = {key: (0.0, float(entry_of(tool.Proxy, key).default)) for key in self.FEEDS}
        changed = [key for key in now if now[key] != before[key]]
        return any(not any(math.isclose(now[key], each) for each in usual.get(key, ())) for key in changed)
