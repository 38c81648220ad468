# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ezdxf writes into its log while it reads a drawing: kept, made printable, and not on the terminal."""

from __future__ import annotations

import logging
from collections.abc import Iterator
from contextlib import contextmanager

from CNCStepper.safe_text import printable

LOGGER = "ezdxf"
MOST_RECORDS = 20


class _Collector(logging.Handler):
    def __init__(self) -> None:
        super().__init__(logging.ERROR)
        self.told: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        if len(self.told) < MOST_RECORDS:
            self.told.append(printable(record.getMessage(), 255))


@contextmanager
def collected_log() -> Iterator[list[str]]:
    """Give a list that takes the errors which ezdxf logs inside the block; none of its words reaches another log."""
    logger, collector = logging.getLogger(LOGGER), _Collector()
    propagates, logger.propagate = logger.propagate, False
    logger.addHandler(collector)
    try:
        yield collector.told
    finally:
        logger.removeHandler(collector)
        logger.propagate = propagates
