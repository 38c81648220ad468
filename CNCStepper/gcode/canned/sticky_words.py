# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of canned cycles that stick while one is modal."""

from __future__ import annotations

from typing import NamedTuple

from CNCStepper.canned_drilling import Place


class Run(NamedTuple):
    """What sticks: the height before the run, and the last block's Z, R and P or Q, as numbers of the text.

    bore: I, J and K of a G87. dwell: the last P of any cycle.
    """

    initial: float
    z: float
    r: float
    own: float
    bore: Place = (0.0, 0.0, 0.0)
    dwell: float = 0.0
