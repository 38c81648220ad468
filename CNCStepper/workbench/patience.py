# SPDX-License-Identifier: LGPL-2.1-or-later
"""While the kernels are being compiled elsewhere (`warming.py`) a window compiles nothing itself.

They run as plain Python meanwhile: a usual cut takes little longer so. One that takes long has to wait.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager

from CNCStepper.errors import CNCStepperError

WAITS = "kernels-prepared"  # the code of the refusal of what has to wait
PATIENCE_S = 1.0

compiling_elsewhere = False


@contextmanager
def patience() -> Iterator[None]:
    """Compile nothing within, while that is done elsewhere; raises CNCStepperError where it then takes too long."""
    if not compiling_elsewhere:
        yield
        return
    from CNCStepper.kernels import uncompiled

    end_s = time.monotonic() + PATIENCE_S

    def look() -> None:
        if time.monotonic() > end_s:
            raise CNCStepperError(
                WAITS,
                "large cuts are being prepared, once after an installation",
                advice="this one is made by itself when that is done, in about a minute",
            )

    with uncompiled(look):
        yield
