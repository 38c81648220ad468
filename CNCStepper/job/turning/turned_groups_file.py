# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a 3D view draws of a turned part, as a file in the folder of its proof: groups of strips of triangles.

Names of groups: "raw" and "cut-N" (the surface that tool N has cut), "section", "chuck", "jaws", "tailstock",
"tool-N", "holder-N". Reading takes numpy only.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from CNCStepper.simulation.meshes.revolved_section import Strips

FACES = "faces.bin"
Group = tuple[np.ndarray, np.ndarray, np.ndarray]  # points and normals float32[n, 3], counts int32[k] of the strips
Groups = dict[str, Group]


def write_groups(folder: Path, groups: dict[str, Strips]) -> list[list[Any]]:
    """Write groups; return name, number of points and of strips of each, as `read_groups` takes them."""
    with (folder / FACES).open("wb") as file:
        for strips in groups.values():
            for array in (strips.points, strips.normals, strips.counts):
                file.write(np.ascontiguousarray(array).tobytes())
    return [[name, len(strips.points), len(strips.counts)] for name, strips in groups.items()]


def read_groups(folder: Path, sizes: list[list[Any]]) -> Groups:
    """Return the groups of these names and sizes."""
    return dict(_read((folder / FACES).read_bytes(), sizes))


def _read(data: bytes, sizes: list[list[Any]]) -> Iterator[tuple[str, Group]]:
    place = 0
    for name, points, strips in sizes:
        flat = np.frombuffer(data, np.float32, 6 * points, place)
        place += flat.nbytes
        counts = np.frombuffer(data, np.int32, strips, place)
        place += counts.nbytes
        yield name, (flat[: 3 * points].reshape(-1, 3), flat[3 * points :].reshape(-1, 3), counts)
