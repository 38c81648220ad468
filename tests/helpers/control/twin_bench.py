# SPDX-License-Identifier: LGPL-2.1-or-later
"""A published machine without hardware in simulated time: bytes with exact times in, the path of its axes out."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from CNCStepper.virtual.server.twin_faults import Twin


def play(twin: Twin, writes: Iterable[tuple[float, bytes]], rest_s: float = 1.0) -> np.ndarray:
    """Let bytes come, each at its time, and `rest_s` after; return the path, float64[k, 1 + axes]."""
    path: list[np.ndarray] = []
    at_s = twin.time_s
    for at_s, data in writes:
        twin.advance(at_s)
        twin.receive(data, at_s, at_s)
        path += twin.take_path()
    twin.advance(at_s + rest_s)
    path += twin.take_path()
    return np.concatenate(path) if path else np.empty((0, 1 + len(twin.columns)))


def send(twin: Twin, data: bytes, limit_s: float = 1000.0, step_s: float = 0.01) -> np.ndarray:
    """Send bytes as its line takes them, until it rests; return the path, float64[k, 1 + axes]."""
    path: list[np.ndarray] = []
    end_s = twin.time_s + limit_s
    while data or not twin.quiet:
        count = twin.room
        twin.receive(data[:count], twin.time_s, twin.time_s)
        data = data[count:]
        twin.advance(twin.time_s + step_s)
        path += twin.take_path()
        assert twin.time_s < end_s, f"still moving after {limit_s} s"
    return np.concatenate(path) if path else np.empty((0, 1 + len(twin.columns)))
