# SPDX-License-Identifier: LGPL-2.1-or-later
"""A position that is unknown, on the disk from one connection to the next: one file a port, gone when it is known.

PORT-DIGEST.position    beside the sessions' files, readable by their owner only
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable
from pathlib import Path

from CNCStepper.control.belief import LOST, NOTHING_AGAINST, Belief
from CNCStepper.control.session_file import read_private, write_durably
from CNCStepper.errors import JobError

POSITION = ".position"
LONGEST_NAME = 40
_NOT_FOR_NAMES = re.compile(r"[^A-Za-z0-9]+")


class BeliefFile:
    """What was held of the position of the machine at one port when somebody was last connected to it.

    belief: as it was kept; without a file nothing speaks against the position. path: None keeps nothing.
    """

    def __init__(self, path: Path | None):
        self._path = path
        self.belief = _read(path) if path else NOTHING_AGAINST

    @classmethod
    def of_port(cls, folder: Path, port: str) -> BeliefFile:
        """Return that of a port, by whatever name it has, in a folder of sessions."""
        readable = _NOT_FOR_NAMES.sub("-", port).strip("-")[:LONGEST_NAME]
        digest = hashlib.sha256(port.encode("utf-8")).hexdigest()[:16]
        return cls(folder / f"{readable}-{digest}{POSITION}")

    def keep(self, belief: Belief) -> None:
        """Keep what is held now; when this returns it is on the disk. Raises JobError when it cannot be."""
        kept = belief if belief.position_known is False else NOTHING_AGAINST
        if kept == self.belief:
            return
        self.belief = kept
        if self._path:
            _write(self._path, kept)

    def keep_or_tell(self, belief: Belief, tell: Callable[[str, str], None]) -> None:
        """Keep what is held now; where that cannot be done, tell it as a warning once."""
        try:
            self.keep(belief)
        except JobError as error:
            tell("warning", str(error))


def _read(path: Path) -> Belief:
    """Return what a file says; one that cannot be read says by being there that the position was lost."""
    try:
        content = read_private(path)
        if content is None:
            return NOTHING_AGAINST
        return LOST._replace(counts_from_here=content["counts_from_here"] is True, zeroed=frozenset(content["zeroed"]))
    except (OSError, ValueError, KeyError, TypeError):
        return LOST


def _write(path: Path, belief: Belief) -> None:
    try:
        if belief.position_known is False:
            zeroed = "".join(sorted(belief.zeroed))
            write_durably(path, {"counts_from_here": belief.counts_from_here, "zeroed": zeroed})
        else:
            path.unlink(missing_ok=True)
    except OSError as error:
        raise JobError(
            "position-unwritable",
            f"what is known of the machine's position cannot be kept: {error.strerror or error}",
            advice=f"make room on the disk of {path.parent}, and see that you may write there",
        ) from error
