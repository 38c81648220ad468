# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a program is to be restarted, as a person names it: a line, an operation, a contour, a point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import Place as FilePlace
from CNCStepper.errors import ProgramError, Text
from CNCStepper.recovery.restart.interrupted_program import Program, Stretch, cutting
from CNCStepper.tolerances import PICKED_MM
from CNCStepper.toolpath import LINE, Span

COARSE, FINE = 9, 65  # places on an arc that are compared: on all arcs, then on the nearest, then about the best


class Place(NamedTuple):
    """A place of the path: after a share of a row, from 0 to below 1."""

    row: int
    share: float = 0.0


@dataclass(frozen=True)
class RequestedPlace:
    """A requested restart place; exactly one of line, contour, operation and at_mm, or operation with contour.

    line: of the file, from 1. time: which of the times that it is run, from 1; needed where it is run more than once.
    operation: its name, or its number from 1. contour: its number from 1, counted in the operation if one is named.
    at_mm: X Y or X Y Z in the stock's work coordinates; without Z the first way that passes there is meant.
    """

    line: int = 0
    time: int = 0
    operation: str = ""
    contour: int = 0
    at_mm: tuple[float, ...] = ()


def place_of(program: Program, where: RequestedPlace) -> Place:
    """Return the place that is meant; raises ProgramError where there is none, or more than one."""
    said = bool(where.line) + bool(where.operation or where.contour) + bool(where.at_mm)
    if said != 1:
        what = "the place of a restart is a line, an operation, a contour or a point"
        raise ProgramError(
            "restart-where", what, value=str(said), limit="1", advice="give one of them", place=_file(program)
        )
    if where.line:
        return by_line(program, where.line, where.time)
    if where.at_mm:
        return by_point(program, where.at_mm)
    if where.contour:
        return by_contour(program, where.contour, where.operation)
    return Place(operation_of(program, where.operation).first)


def by_line(program: Program, number: int, time: int = 0) -> Place:
    """Return where the first move at or after a line of the file begins."""
    runs = _runs_of(program, number)
    if (len(runs) > 1 or time) and not 1 <= time <= len(runs):
        what = Text("which run of line {number} is meant is not clear", number=number)
        advice, limit = "give the number of the run", Text("from 1 to {runs}", runs=len(runs))
        raise ProgramError("restart-time", what, limit=limit, advice=advice, place=_file(program, number))
    row = int(np.searchsorted(program.table.line, runs[max(time, 1) - 1]))
    if row == len(program.table):
        what = Text("nothing moves at line {number} or after it", number=number)
        raise ProgramError("restart-nothing-left", what, advice="choose an earlier line", place=_file(program, number))
    return Place(row)


def _runs_of(program: Program, number: int) -> list[int]:
    """Return the lines, as they run from 1, that are a line of the file, or else the next one that is run."""
    later = program.file_lines[program.file_lines >= number]
    if not len(later):
        return [len(program.lines) + 1]
    runs = np.flatnonzero(program.file_lines == later.min())
    if program.is_translated:  # lines one behind the other are one run of it
        runs = runs[np.diff(runs, prepend=-2) > 1]
    return (runs + 1).tolist()


def operation_of(program: Program, name: str) -> Span:
    """Return the operation with a name or number; raises ProgramError where there is none, or more than one."""
    spans = program.operations
    if name.isdigit() and 1 <= int(name) <= len(spans):
        return spans[int(name) - 1]
    found = [span for span in spans if span.name.casefold() == name.strip().casefold()]
    if len(found) == 1:
        return found[0]
    known = ", ".join(f"{number} ({span.name})" for number, span in enumerate(spans, 1))
    what = Text("no operation, or more than one, is called '{name}'", name=name)
    advice = Text("its operations are: {known}", known=known) if known else "it names no operation: choose a line"
    raise ProgramError("restart-operation", what, advice=advice, place=_file(program))


def by_contour(program: Program, number: int, operation: str = "") -> Place:
    """Return where a stretch of cuts between two rapids begins, counted in an operation or in the whole program."""
    found = contours(program, operation_of(program, operation) if operation else None)
    if not 1 <= number <= len(found):
        what = Text("there is no contour {number}", number=number)
        limit = Text("from 1 to {found}", found=len(found))
        raise ProgramError("restart-contour", what, limit=limit, advice="choose another", place=_file(program))
    return Place(found[number - 1].first)


def contours(program: Program, operation: Span | None = None) -> list[Stretch]:
    """Return the stretches of cuts between two rapids, of an operation or of the whole program."""
    found = cutting(program)
    return found if operation is None else [one for one in found if operation.first <= one.first < operation.last]


def by_point(program: Program, at_mm: Sequence[float]) -> Place:
    """Return the place of the cuts that is nearest to a point; of ways on top of each other that of the first."""
    axes = len(at_mm)
    rows = np.concatenate([np.arange(one.first, one.last) for one in cutting(program)] or [np.zeros(0, int)])
    rows = rows[np.isfinite(program.begins[rows][:, :axes]).all(axis=1)]
    if not len(rows):
        raise ProgramError("restart-point", "the program cuts nothing", advice="give a line", place=_file(program))
    away, shares = _nearest(program, rows, np.array(at_mm, float))
    best = int(np.flatnonzero(away <= away.min() + PICKED_MM)[0])
    row, share = int(rows[best]), float(shares[best])
    return Place(row, share) if share < 1 else Place(min(row + 1, len(program.table) - 1))


def _nearest(program: Program, rows: np.ndarray, at_mm: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the distance of each row from a point, and the share of the row there; coarse for far arcs."""
    away, shares = np.empty(len(rows)), np.empty(len(rows))
    arcs = program.table.kind[rows] > LINE
    away[~arcs], shares[~arcs] = _nearest_on_lines(program, rows[~arcs], at_mm)
    whole = np.tile((0.0, 1.0), (len(rows), 1))
    away[arcs], shares[arcs] = _nearest_on_arcs(program, rows[arcs], at_mm, whole[arcs], COARSE)
    near = arcs & (away - program.ways.length_mm[rows] / COARSE <= away.min())
    for width in (1.0, 2.0 / FINE, 4.0 / FINE**2):
        bounds = np.clip(shares[near, None] + (-width, width), 0, 1)
        away[near], shares[near] = _nearest_on_arcs(program, rows[near], at_mm, bounds, FINE)
    return away, shares


def _nearest_on_lines(program: Program, rows: np.ndarray, at_mm: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    axes = len(at_mm)
    begin = program.tips(program.begins[rows], rows)[:, :axes]
    way = program.tips(program.table.end[rows, :3], rows)[:, :axes] - begin
    squared = (way**2).sum(axis=1)
    share = np.clip(((at_mm - begin) * way).sum(axis=1) / np.where(squared > 0, squared, 1), 0, 1)
    return np.sqrt(((begin + way * share[:, None] - at_mm) ** 2).sum(axis=1)), share


def _nearest_on_arcs(
    program: Program, rows: np.ndarray, at_mm: np.ndarray, bounds: np.ndarray, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return the nearest of `count` places on each arc, between its two bounds, float64[n, 2], shares of it."""
    shares = np.linspace(bounds[:, 0], bounds[:, 1], count, axis=1)
    each = np.repeat(rows, count)
    tips = program.tips(program.places(each, shares.ravel()), each)[:, : len(at_mm)]
    away = np.sqrt(((tips - at_mm) ** 2).sum(axis=1)).reshape(-1, count)
    best = away.argmin(axis=1) if len(rows) else np.zeros(0, int)
    return away.min(axis=1, initial=np.inf), shares[np.arange(len(rows)), best]


def _file(program: Program, line: int = 0) -> FilePlace:
    return FilePlace(program.file, line)
