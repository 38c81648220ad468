# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of Debian packages that are not installed: fetched by apt from the machine's own sources, and only unpacked.

They lie in the user's cache folder, so that a machine fetches each once. Nothing of a package is run.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

FETCH_S = 90  # 20 MB take some seconds
WHOLE = "whole"  # the name of an unpacked package, which no half of one has


def unpacked(package: str) -> Path | str:
    """Return the folder with the files of a package, or why there is none."""
    folder = _cache() / package
    if (folder / WHOLE).is_dir():
        return folder / WHOLE
    if not (shutil.which("apt-get") and shutil.which("dpkg-deb")):
        return "this machine has no apt"
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder) as work:
        try:
            _run(["apt-get", "-qq", "download", package], Path(work))
            (archive,) = Path(work).glob("*.deb")
            _run(["dpkg-deb", "-x", str(archive), "files"], Path(work))
        except (OSError, ValueError, subprocess.SubprocessError) as error:
            return f"apt does not give {package}: {error}"
        with contextlib.suppress(OSError):  # another run was first
            (Path(work) / "files").rename(folder / WHOLE)
    return folder / WHOLE


def _run(words: list[str], folder: Path) -> None:
    subprocess.run(words, cwd=folder, check=True, timeout=FETCH_S, stdin=subprocess.DEVNULL, capture_output=True)


def _cache() -> Path:
    """Return the folder of all packages, beside those of the other tools."""
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(base) / "cncstepper-packages"
