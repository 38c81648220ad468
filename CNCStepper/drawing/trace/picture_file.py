# SPDX-License-Identifier: LGPL-2.1-or-later
"""A PNG or JPEG file as greys in bounded memory: its size is read before any pixel is."""

from __future__ import annotations

import io
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image, ImageFilter, ImageOps, UnidentifiedImageError

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import read_input
from CNCStepper.safe_text import printable

MOST_BYTES = 100_000_000
MOST_PIXELS = 30_000_000  # 120 MB while a picture with transparency is put on white
LEAST_DPI = 10.0  # smaller ones in a file stand for "not known"
FORMATS = ("PNG", "JPEG")
SIXTEEN_BITS = ("I;16", "I;16B", "I;16L", "I")


@dataclass(frozen=True)
class Greys:
    """A picture's greys, uint8[rows, columns], 0 black, the first row below; dpi: as its file says, 0 for none."""

    values: np.ndarray
    dpi: float


def read_greys(path: Path, blur_px: float = 0.0) -> Greys:
    """Return the greys of a picture, transparent places white; raises JobError for no picture and a huge one."""
    content = read_input(path, MOST_BYTES)
    place = Place(str(path))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # pillow warns of large pictures; ours are bounded below
            image = Image.open(io.BytesIO(content), formats=FORMATS)
            _require_small(image.size, place)
            dpi = _dpi(image)
            grey = _grey(ImageOps.exif_transpose(image))
            checkpoint()
            if blur_px:
                grey = grey.filter(ImageFilter.GaussianBlur(blur_px))
    except JobError:
        raise
    except Image.DecompressionBombError as error:
        raise _too_large(printable(str(error), 255), place) from error
    except (OSError, ValueError, SyntaxError, EOFError) as error:
        unknown = isinstance(error, UnidentifiedImageError)  # its words name an object of Python
        why = Text("its content is no picture") if unknown else printable(str(error), 255)
        raise JobError("picture-file", Text("not a PNG or JPEG picture: {why}", why=why),
                       advice="save it again as PNG", place=place) from error  # fmt: skip
    return Greys(np.asarray(grey, np.uint8)[::-1], dpi)


def _require_small(size: tuple[int, int], place: Place) -> None:
    width, height = size
    if width * height > MOST_PIXELS:
        raise _too_large(Text("{width} by {height}", width=width, height=height), place)


def _too_large(value: str, place: Place) -> JobError:
    limit, advice = (
        Text("{most} pixels", most=MOST_PIXELS),
        "scale it down: 10 pixels a mm are enough for any cutter",
    )
    what = "the picture has too many pixels"
    return JobError("picture-large", what, value=value, limit=limit, advice=advice, place=place)


def _dpi(image: Image.Image) -> float:
    try:
        dpi = float(image.info.get("dpi", (0.0, 0.0))[0])
    except (TypeError, ValueError, IndexError, ZeroDivisionError):
        return 0.0
    return dpi if LEAST_DPI <= dpi < 1e6 else 0.0


def _grey(image: Image.Image) -> Image.Image:
    """Return a picture as greys of 8 bits, on white where it is transparent."""
    if image.mode in SIXTEEN_BITS:
        values = np.asarray(image, np.int64)
        return Image.fromarray((np.clip(values, 0, 65535) // 257).astype(np.uint8))
    if image.mode in ("RGBA", "LA", "PA") or "transparency" in image.info:
        coloured = image.convert("RGBA")
        white = Image.new("L", coloured.size, 255)
        white.paste(coloured.convert("L"), mask=coloured.getchannel("A"))
        return white
    return image.convert("L")


def otsu_threshold(values: np.ndarray) -> int:
    """Return the grey that parts dark and light best (Otsu 1979), from 1 to 255."""
    counts = np.bincount(values.ravel(), minlength=256).astype(float)
    below, weighted = np.cumsum(counts)[:-1], np.cumsum(counts * np.arange(256))
    above = counts.sum() - below
    both = (below > 0) & (above > 0)
    if not both.any():
        return 128
    apart = np.zeros(255)
    means = weighted[:-1][both] / below[both] - (weighted[-1] - weighted[:-1][both]) / above[both]
    apart[both] = below[both] * above[both] * means**2
    best = np.flatnonzero(apart >= apart.max() * (1.0 - 1e-12))  # a gap in the greys: its middle
    return int((best[0] + best[-1]) // 2) + 1
