# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a session, readable by their owner only: how to reach it, how it ended, what it logged.

NAME.session   port, token and process, while it runs       NAME.outcome   afterwards       NAME.log
"""

from __future__ import annotations

import json
import os
import secrets
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

KEPT = 20  # sessions whose outcome and log are kept
SESSION, OUTCOME, LOG = ".session", ".outcome", ".log"


def session_folder() -> Path:
    """Return the user's folder of sessions, made when it is not there."""
    from platformdirs import user_state_path

    folder = user_state_path("cncstepper", appauthor=False) / "sessions"
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    return folder


def new_session(folder: Path | None = None) -> Path:
    """Return the path for the file of a new session, and remove what old ones left."""
    folder = folder or session_folder()
    _prune(folder)
    return folder / f"{time.strftime('%Y%m%d-%H%M%S')}-{secrets.token_hex(4)}{SESSION}"


def sessions(folder: Path | None = None) -> list[Path]:
    """Return the files of the sessions that run, oldest first; one may have been killed."""
    return sorted((folder or session_folder()).glob(f"*{SESSION}"))


def write_private(path: Path, content: Mapping[str, Any]) -> None:
    """Write JSON that only its owner can read; a reader finds it whole or not at all."""
    draft = path.with_name(f"{path.name}.{secrets.token_hex(4)}")
    with open(os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w", encoding="utf-8") as file:
        json.dump(content, file)
    os.replace(draft, path)


def read_private(path: Path) -> dict[str, Any] | None:
    """Return the JSON of `write_private`, or None when there is no such file."""
    try:
        return json.loads(path.read_text("utf-8"))
    except FileNotFoundError:
        return None


def _prune(folder: Path) -> None:
    for kind in (OUTCOME, LOG):
        for old in sorted(folder.glob(f"*{kind}"))[:-KEPT]:
            with suppress(OSError):  # another program prunes too
                old.unlink()
