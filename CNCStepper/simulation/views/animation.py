# SPDX-License-Identifier: LGPL-2.1-or-later
"""One view of a program as an animation over the planned time: GIF, APNG, WebP, or MP4 by ffmpeg."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from matplotlib.animation import AbstractMovieWriter, FFMpegWriter, PillowWriter
from PIL import Image
from PIL.PngImagePlugin import PngInfo

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Text
from CNCStepper.simulation.views.picture_style import DPI
from CNCStepper.simulation.views.scene import Scene
from CNCStepper.simulation.views.single_view import draw_view, view_figure

FRAMES_A_S = 10
ABOUT = "CNCStepper"  # in every animation's description
SOFTWARE = 0x0131  # of EXIF


class _ImageWriter(PillowWriter):
    """Writes an animation with a description, which matplotlib leaves out."""

    def finish(self) -> None:
        first, *others = self._frames  # type: ignore[attr-defined]
        text = PngInfo()
        text.add_text("Software", ABOUT)
        exif = Image.Exif()
        exif[SOFTWARE] = ABOUT
        about: dict[str, dict[str, Any]] = {
            ".gif": {"comment": ABOUT},
            ".apng": {"pnginfo": text},
            ".webp": {"exif": exif},
        }
        own = about[Path(self.outfile).suffix]
        first.save(self.outfile, save_all=True, append_images=others, duration=int(1000 / self.fps), loop=0, **own)


MOVIES: dict[str, Any] = {".gif": _ImageWriter, ".apng": _ImageWriter, ".webp": _ImageWriter, ".mp4": FFMpegWriter}
Captioned = tuple[Scene, list[str]]  # a scene and the facts of its head


def save_animation(file: Path, view: str, scenes: Iterator[Captioned], title: str) -> None:
    """Write one of VIEWS as an animation of scenes of one program; its kind is the ending of the file's name.

    Raises JobError where there is no encoder for it.
    """
    writer = _writer(file)
    first = next(scenes)
    figure = view_figure(view, first[0])
    with tempfile.TemporaryDirectory() as folder:  # of ours alone; ffmpeg writes by name
        draft = Path(folder) / f"animation{file.suffix.lower()}"
        with writer.saving(figure, str(draft), DPI):
            for scene, facts in (first, *scenes):
                figure.clear()
                draw_view(figure, view, scene, title, facts)
                writer.grab_frame()
        write_whole(file, draft.read_bytes())


def is_movie(file: Path) -> bool:
    """Return whether a file's name is that of an animation."""
    return file.suffix.lower() in MOVIES


def _writer(file: Path) -> AbstractMovieWriter:
    writer = MOVIES[file.suffix.lower()]
    if not writer.isAvailable():
        raise JobError(
            "encoder",
            Text("no encoder for '{file}' is installed", file=file.name),
            advice="end it in .gif, or install ffmpeg",
        )
    return writer(fps=FRAMES_A_S, metadata={"comment": ABOUT})
