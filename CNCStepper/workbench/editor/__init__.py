# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editor of programs: `open_program(obj)` for a job's or an edited one, `open_file(path)`; Qt is loaded then."""

from __future__ import annotations

from pathlib import Path
from typing import Any


def open_program(obj: Any) -> Any:
    """Open the editor of a job's program or of an edited program; returns its dock."""
    from CNCStepper.workbench.editor.program_source import ObjectSource
    from CNCStepper.workbench.editor.window import open_source

    return open_source(ObjectSource(obj))


def open_file(path: Path) -> Any:
    """Open the editor of a G-code file; returns its dock. Raises JobError for one that cannot be read."""
    from CNCStepper.workbench.editor.program_source import FileSource
    from CNCStepper.workbench.editor.window import open_source

    return open_source(FileSource(path))
