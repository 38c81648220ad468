# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fonts of the system: the folders of Linux, Windows and macOS, and the faces in them by family and style.

Only the head of each file and its names are read: some 0.2 ms a file. The list is made once for a process.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from CNCStepper.drawing.text.sfnt import MOST_FACES, FontDamage, face_offsets, family_and_style, table_places
from CNCStepper.errors import JobError, Text

SUFFIXES = (".ttf", ".otf", ".ttc", ".otc")
MOST_FILES = 20_000
MOST_DEPTH = 6
MOST_NAME_BYTES = 1_000_000
HEAD_BYTES = 12 + 4 * MOST_FACES
NAMED = 8  # families named in an advice
REGULAR = ("regular", "book", "roman", "normal", "medium", "plain")
GENERIC = {  # of CSS, and of files that name fonts of another system
    "sans-serif": ("DejaVu Sans", "Arial", "Helvetica", "Liberation Sans", "Nimbus Sans"),
    "serif": ("DejaVu Serif", "Times New Roman", "Times", "Liberation Serif", "Nimbus Roman"),
    "monospace": ("DejaVu Sans Mono", "Consolas", "Menlo", "Liberation Mono", "Nimbus Mono PS"),
}


@dataclass(frozen=True)
class Face:
    """A face in a font file: the number of the face in it, its family and style."""

    path: Path
    number: int
    family: str
    style: str


def folders() -> tuple[Path, ...]:
    """Return the folders in which the system keeps fonts, those of the user first."""
    home, environment = Path.home(), os.environ
    if sys.platform == "win32":
        local, windows = environment.get("LOCALAPPDATA", ""), environment.get("WINDIR", r"C:\Windows")
        return (*((Path(local) / "Microsoft/Windows/Fonts",) if local else ()), Path(windows) / "Fonts")
    if sys.platform == "darwin":
        return (
            home / "Library/Fonts",
            Path("/Library/Fonts"),
            Path("/System/Library/Fonts"),
            Path("/Network/Library/Fonts"),
        )
    data = Path(environment.get("XDG_DATA_HOME") or home / ".local/share")
    shared = environment.get("XDG_DATA_DIRS") or "/usr/local/share:/usr/share"
    return data / "fonts", home / ".fonts", *(Path(folder) / "fonts" for folder in shared.split(":") if folder)


@lru_cache(1)
def faces() -> tuple[Face, ...]:
    """Return the faces of the system, by family and style; matplotlib's own fonts too, so that there is always one."""
    found: dict[tuple[str, str], Face] = {}
    for folder in (*folders(), _matplotlib_fonts()):
        for path in _font_files(folder):
            for face in _faces_in(path):
                found.setdefault((face.family.casefold(), face.style.casefold()), face)
    return tuple(sorted(found.values(), key=lambda face: (face.family.casefold(), face.style.casefold())))


def families() -> tuple[str, ...]:
    """Return the names of the families of the system, sorted."""
    return tuple(dict.fromkeys(face.family for face in faces()))


def find_face(family: str, style: str = "") -> Face:
    """Return the face of a family and style, capitals or not; without a style the regular one.

    `family` may also name a style ("DejaVu Sans Bold") or be sans-serif, serif or monospace. Raises JobError that names
    families or styles which are there.
    """
    wanted = family.strip().casefold()
    own = [face for face in faces() if face.family.casefold() == wanted]
    if not own and not style:
        own = [face for face in faces() if f"{face.family} {face.style}".casefold() == wanted]
    for other in GENERIC.get(wanted, ()) if not own else ():
        own = own or [face for face in faces() if face.family == other]
    if not own:
        raise JobError("font-unknown", Text("there is no font '{family}'", family=family), advice=_advice(wanted))
    return _of_style(own, style)


def _of_style(own: list[Face], style: str) -> Face:
    words = set(style.casefold().replace("-", " ").replace("oblique", "italic").split())
    for face in own:
        if set(face.style.casefold().replace("oblique", "italic").split()) - set(REGULAR) == words - set(REGULAR):
            return face
    if not words:
        return own[0]
    raise JobError(
        "font-style",
        Text("the font '{family}' has no style '{style}'", family=own[0].family, style=style),
        advice=Text("it has {styles}", styles=", ".join(face.style for face in own)),
    )


def _advice(wanted: str) -> str:
    near = [name for name in families() if wanted.split(" ")[0] in name.casefold()] or list(families())
    return Text("name one that the system has: {families}", families=", ".join(near[:NAMED]) or Text("none"))


def _matplotlib_fonts() -> Path:
    import matplotlib

    return Path(matplotlib.get_data_path()) / "fonts/ttf"


def _font_files(folder: Path) -> Iterator[Path]:
    """Yield the font files below a folder in order, at most MOST_FILES."""
    left = MOST_FILES
    for where, inner, names in os.walk(folder):
        inner.sort()
        if len(Path(where).relative_to(folder).parts) >= MOST_DEPTH:
            inner.clear()
        for name in sorted(names):
            if name.casefold().endswith(SUFFIXES):
                left -= 1
                if left < 0:
                    return
                yield Path(where) / name


def _faces_in(path: Path) -> list[Face]:
    """Return the faces of one file; none of a file that is damaged or cannot be read: it is no font of the system."""
    try:
        with path.open("rb") as file:
            offsets = face_offsets(file.read(HEAD_BYTES))
            return [_face(file, path, number, offset) for number, offset in enumerate(offsets)]
    except (OSError, FontDamage):
        return []


def _face(file: object, path: Path, number: int, offset: int) -> Face:
    def piece(at: int, length: int) -> bytes:
        file.seek(at)  # type: ignore[attr-defined]
        return file.read(min(length, MOST_NAME_BYTES))  # type: ignore[attr-defined, no-any-return]

    directory = piece(offset, 12)
    directory += piece(offset + 12, 16 * min(int.from_bytes(directory[4:6], "big"), 256))
    family, style = family_and_style(piece(*table_places(directory).get("name", (0, 0))))
    return Face(path, number, family or path.stem, style)
