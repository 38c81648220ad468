# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far two tables of moves lie apart, measured without the code that fits: dense points against dense chords."""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.toolpath import ARC_CW, PLANE_AXES, RAPID, Toolpath

SAGITTA_MM = 1e-5


def stretches(path: Toolpath, step_mm: float) -> list[tuple[tuple, np.ndarray]]:
    """Return what the path does as (what happens before, rapid or feed, feed, spindle), dense points."""
    table, begins = path.table(), path.begins()
    happens: dict[int, list] = {}
    for event in path.events:
        happens.setdefault(event.index, []).append((event.kind, event.value, event.text))
    found: list[tuple[tuple, list[np.ndarray]]] = []
    for row in range(len(path)):
        state = path.states[int(table.state[row])]
        steady = (state.spindle, state.spindle_rpm, state.flood, state.mist, state.tool, state.units)
        key = (table.kind[row] == RAPID, float(table.feed[row]), steady)
        points = dense(path, row, begins[row], step_mm)
        if row in happens or not found or found[-1][0][1:] != key:
            found.append(((tuple(happens.get(row, ())), *key), [points]))
        else:
            found[-1][1].append(points[1:])
    return [(key, np.vstack(parts)) for key, parts in found]


def dense(path: Toolpath, row: int, begin: np.ndarray, step_mm: float) -> np.ndarray:
    """Return points of a row, both ends among them, so near that their chords leave it by SAGITTA_MM at most."""
    table = path.table()
    end, kind = table.end[row], int(table.kind[row])
    if kind < ARC_CW:
        count = max(int(math.dist(begin, end) / step_mm), 1)
        return begin + np.linspace(0, 1, count + 1)[:, None] * (end - begin)
    first, second, normal = PLANE_AXES[int(table.plane[row])]
    centre = table.centre[row]
    a = math.atan2(begin[second] - centre[second], begin[first] - centre[first])
    b = math.atan2(end[second] - centre[second], end[first] - centre[first])
    sweep = (b - a) % (2 * math.pi) if kind != ARC_CW else -((a - b) % (2 * math.pi))
    if abs(sweep) < 1e-12:
        sweep = 2 * math.pi if kind != ARC_CW else -2 * math.pi
    r0 = math.hypot(begin[first] - centre[first], begin[second] - centre[second])
    r1 = math.hypot(end[first] - centre[first], end[second] - centre[second])
    fine = 2 * math.acos(1 - min(SAGITTA_MM / max(r0, 1e-9), 1.0))
    count = max(int(abs(sweep) / fine), int(abs(sweep) * r0 / step_mm), 2)
    share = np.linspace(0, 1, count + 1)
    points = np.empty((count + 1, 3))
    radius = r0 + share * (r1 - r0)
    points[:, first] = centre[first] + radius * np.cos(a + share * sweep)
    points[:, second] = centre[second] + radius * np.sin(a + share * sweep)
    points[:, normal] = begin[normal] + share * (end[normal] - begin[normal])
    return points


def farthest(points: np.ndarray, way: np.ndarray) -> float:
    """Return how far the farthest of `points` is from the polyline `way`, exactly."""
    begin, chord = way[:-1], np.diff(way, axis=0)
    square = np.maximum((chord**2).sum(axis=1), 1e-300)
    most = 0.0
    for part in np.array_split(points, max(len(points) * len(chord) // 2_000_000, 1)):
        local = part[:, None] - begin[None]
        share = np.clip((local * chord).sum(axis=2) / square, 0, 1)
        away = local - share[:, :, None] * chord
        most = max(most, float(np.sqrt((away**2).sum(axis=2).min(axis=1)).max()))
    return most


def frechet(one: np.ndarray, other: np.ndarray) -> float:
    """Return the discrete Fréchet distance (Eiter and Mannila 1994): both are walked in order, neither goes back."""
    away = np.sqrt(((one[:, None] - other[None]) ** 2).sum(axis=2))
    row = np.maximum.accumulate(away[0])
    for k in range(1, len(away)):
        reach = np.minimum(row, np.concatenate([[np.inf], row[:-1]]))
        new = np.empty_like(row)
        last = np.inf
        for j, (come, here) in enumerate(zip(reach.tolist(), away[k].tolist(), strict=True)):
            last = max(min(come, last), here)
            new[j] = last
        row = new
    return float(row[-1])
