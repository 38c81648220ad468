# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's link (USP, 2006): how far ahead of its motion a program may be sent.

The lathe acknowledges nothing and the size of its buffer is not published, so that what may lie in it is a setting.
What lies there cannot be taken back: after a hold or a stop the lathe cuts it to its end.
"""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel

from CNCStepper.quantities import Bounds

LONGEST_RECORD = 60  # bytes: a record of two coordinates and a feed, each of ten digits


class LatheLink(BaseModel, extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True):
    """What may lie in the lathe's buffer.

    ahead_s: of motion that was sent and is not done; a record that lasts longer is sent alone. ahead_bytes: of records
    that were sent and are not done. slower: share of the time by which the lathe may be slower than its published
    waits; too little fills its buffer, too much lets it stand between two chunks.
    """

    ahead_s: Annotated[float, Bounds("time", 0.1, 60.0)] = 2.0
    ahead_bytes: Annotated[int, Bounds("count", LONGEST_RECORD + 4, 65_536)] = 128
    slower: Annotated[float, Bounds("share", zero=True)] = 0.01
