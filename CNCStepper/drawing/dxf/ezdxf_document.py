# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads DXF files and texts with ezdxf, which may end with any exception on a damaged one, and keeps its log."""

from __future__ import annotations

import io
import logging
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.safe_text import printable

LOGGER = "ezdxf"
MOST_RECORDS = 20
MOST_WORDS = 255  # characters of a message of ezdxf


def load_file(path: Path) -> tuple[Any, str]:
    """Return the document of a file, and the damage where ezdxf had to repair it; raises JobError for no DXF file."""
    import ezdxf  # it takes 0.4 s
    from ezdxf import recover

    try:
        return ezdxf.readfile(path), ""
    except Exception as damage:
        try:
            return recover.readfile(path)[0], str(damage) or "it ends too early"
        except Exception as error:
            raise no_dxf(path, str(error)) from error


def load_text(content: bytes) -> tuple[Any, str]:
    """Return the document of a DXF text and the name of its encoding; nothing is repaired."""
    import ezdxf  # it takes 0.4 s
    from ezdxf.filemanagement import dxf_stream_info

    encoding = dxf_stream_info(io.StringIO(content.decode("latin-1"))).encoding
    text = content.decode(encoding, "surrogateescape").replace("\r\n", "\n")
    return ezdxf.read(io.StringIO(text)), encoding


def no_dxf(path: Path, why: str) -> JobError:
    """Return the refusal of a file that is no DXF file."""
    advice = "save it as DXF again, as R2000 or newer"
    return JobError(
        "dxf-file", Text("not a DXF file: {why}", why=printable(why, MOST_WORDS)), advice=advice, place=Place(str(path))
    )


class _Collector(logging.Handler):
    def __init__(self) -> None:
        super().__init__(logging.ERROR)
        self.messages: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        if len(self.messages) < MOST_RECORDS:
            self.messages.append(printable(record.getMessage(), MOST_WORDS))


@contextmanager
def collected_log() -> Iterator[list[str]]:
    """Give a list that takes the errors which ezdxf logs inside the block; no other log gets them."""
    logger, collector = logging.getLogger(LOGGER), _Collector()
    propagates, logger.propagate = logger.propagate, False
    logger.addHandler(collector)
    try:
        yield collector.messages
    finally:
        logger.removeHandler(collector)
        logger.propagate = propagates
