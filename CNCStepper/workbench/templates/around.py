# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a new job's stock is made round."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Around:
    """The bounding box of what was selected, None for nothing; is_solid: whether the stock is as large as that."""

    box: Any = None
    is_solid: bool = False
