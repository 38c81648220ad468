# SPDX-License-Identifier: LGPL-2.1-or-later
"""State that no path edit may change: outputs, tool, and the modes of path control."""

from __future__ import annotations

import numpy as np

from CNCStepper.state import State
from CNCStepper.toolpath import Toolpath

SAME_SURFACE = 1e-3  # relative: S of a constant surface speed is written in other units


def modes_of(state: State) -> tuple:
    """Return those of a state; a speed that follows X is not among them."""
    rpm = state.spindle_rpm if not state.surface_m_min else 0.0
    on = state.spindle, rpm, state.mist, state.flood, state.tool
    return *on, state.work_system, state.feed_mode, state.path_mode


def same_modes(old: Toolpath, new: Toolpath) -> np.ndarray:
    """Return the rows of two tables of equal length that have the same modes, bool[n]."""
    numbers: dict[tuple, int] = {}
    one, other = (_by_row(path, numbers) for path in (old, new))
    surface, after = (_surface(path) for path in (old, new))
    return (one == other) & (np.abs(surface - after) <= SAME_SURFACE * surface)


def _by_row(path: Toolpath, numbers: dict[tuple, int]) -> np.ndarray:
    of_states = np.array([numbers.setdefault(modes_of(state), len(numbers)) for state in path.states])
    return of_states[path.table().state]


def _surface(path: Toolpath) -> np.ndarray:
    return np.array([state.surface_m_min for state in path.states])[path.table().state]
