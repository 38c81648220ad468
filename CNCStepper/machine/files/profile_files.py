# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where machine profiles lie: those that ship with the product, and those of the user.

    CNCStepper/machine/profiles/NAME.toml                  shipped; never written
    CONFIG/cncstepper/machines/NAME.toml                   the user's own; one of a shipped name takes its place

CONFIG is the user's configuration folder as platformdirs names it: ~/.config on Linux.
"""

from __future__ import annotations

import os
import re
from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path

from CNCStepper.errors import MissingPackage, missing_package

SUFFIX = ".toml"
NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]{0,59}")


def own_folder() -> Path:
    """Return the folder of the user's profiles, which need not be there; raises MissingPackage without platformdirs."""
    return config_folder() / "machines"


def config_folder() -> Path:
    """Return the folder of the user's files, which need not be there; raises MissingPackage without platformdirs."""
    try:
        from platformdirs import user_config_path
    except ImportError as error:
        raise missing_package("platformdirs") from error
    return user_config_path("cncstepper", appauthor=False)


def own_path(name: str) -> Path | None:
    """Return the file of the user's profile of that name, None where there is none."""
    if not NAME.fullmatch(name):
        return None
    try:
        path = own_folder() / f"{name}{SUFFIX}"
    except MissingPackage:  # a user without a folder for profiles has none
        return None
    return path if path.is_file() else None


def own_names() -> list[str]:
    """Return the names of the user's profiles."""
    try:
        entries = os.listdir(own_folder())
    except (OSError, MissingPackage):
        return []
    return sorted(name for name, suffix in map(os.path.splitext, entries) if suffix == SUFFIX and NAME.fullmatch(name))


@cache
def shipped_names() -> tuple[str, ...]:
    """Return the names of the profiles that ship with the product."""
    folder = resources.files("CNCStepper.machine") / "profiles"
    return tuple(sorted(entry.name[:-5] for entry in folder.iterdir() if entry.name.endswith(SUFFIX)))


def shipped_file(name: str) -> Traversable:
    """Return the file of a shipped profile."""
    return resources.files("CNCStepper.machine") / "profiles" / f"{name}{SUFFIX}"
