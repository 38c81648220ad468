# SPDX-License-Identifier: LGPL-2.1-or-later
"""The packages of others that we use: the one list from which all else that names them derives.

`pyproject.toml` and `package.xml` say the same; a test compares them. Pure Python: this is what is there when they are
not.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

PROGRAM, MACHINE, FILES, TERMINAL, SPEED, NESTING = "program", "machine", "files", "terminal", "speed", "nesting"
CLUSTER = "cluster"


@dataclass(frozen=True)
class Need:
    """A package: the name of its module, that by which pip knows it, and what it is for."""

    module: str
    pip: str
    purposes: tuple[str, ...]


NEEDS = (
    Need("numpy", "numpy", (PROGRAM,)),
    Need("shapely", "shapely", (PROGRAM,)),
    Need("ezdxf", "ezdxf", (FILES,)),
    Need("fontTools", "fonttools", (FILES,)),
    Need("pydantic", "pydantic", (PROGRAM,)),
    Need("platformdirs", "platformdirs", (PROGRAM,)),
    Need("serial", "pyserial", (MACHINE,)),
    Need("click", "click", (MACHINE, TERMINAL)),  # the virtual controller is started as the command line starts it
    Need("rich", "rich", (TERMINAL,)),
    Need("matplotlib", "matplotlib", (PROGRAM,)),
    Need("PIL", "pillow", (FILES,)),
    Need("numba", "numba", (SPEED,)),
    Need("spyrrow", "spyrrow", (NESTING,)),
    Need("distributed", "distributed", (CLUSTER,)),
)
FAST = "numba"
PINS = Path(__file__).with_name("constraints.txt")  # for pip: versions of these and of all that they take
REQUIRED = tuple(need.module for need in NEEDS if not {SPEED, NESTING, CLUSTER} & set(need.purposes))
PIP_NAMES = {need.module: need.pip for need in NEEDS}


def modules(purpose: str) -> tuple[str, ...]:
    """Return the modules that something takes, in the order of the list."""
    return tuple(need.module for need in NEEDS if purpose in need.purposes)


def pip_names(names: tuple[str, ...] | list[str]) -> list[str]:
    """Return how pip calls modules."""
    return [PIP_NAMES.get(name, name) for name in names]


def requirements(names: tuple[str, ...] | list[str]) -> list[str]:
    """Return modules as requirements for pip, with the version that PINS has: "pyserial==3.5"."""
    pinned = pins()
    return [f"{name}=={pinned[name]}" for name in pip_names(names)]


def pins() -> dict[str, str]:
    """Return the version of each package in PINS, by the name of the package."""
    lines = PINS.read_text("utf-8").splitlines()
    return dict(line.split("==") for line in lines if line and not line.startswith("#"))
