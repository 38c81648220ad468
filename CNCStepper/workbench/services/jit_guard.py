# SPDX-License-Identifier: LGPL-2.1-or-later
"""No object of a document keeps the window for long.

While the kernels are being compiled elsewhere (`kernel_warmup.py`) a window compiles nothing itself: they run as
plain Python
meanwhile, and a usual cut takes little longer so. One that takes long has to wait until they are compiled. When they
are, a cut that takes long is ended too, and made by the cut process (`deferred_cuts.py`).
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from CNCStepper.cancellation import interruptible
from CNCStepper.errors import CNCStepperError

WAITS = "kernels-prepared"  # the code of the refusal of what has to wait for the kernels
LONG = "cut-long"  # of what the cut process makes
PATIENCE_S = 1.0
MOST_S = 1.0  # of the window thread's processor time, for one object
FIRST_S = 3.0  # the same, until one has taken as long as loading the kernels does
LOADED_S = 0.3
HURRY_S = 0.05  # the same, for those after one that took too long

compiling_elsewhere = False
loaded = False  # one has taken that long
hurry = False  # one has taken too long, and the window has not been free since
long_refused: Callable[[], None] | None = None  # called where something was left to the cut process; only in a window


@contextmanager
def without_compiling() -> Iterator[None]:
    """Compile nothing within while that is done elsewhere, and in a window calculate for a short time only.

    Raises CNCStepperError where it then takes too long. A script without a window waits for all.
    """
    if compiling_elsewhere:
        from CNCStepper.kernels import uncompiled

        with uncompiled(_until(time.monotonic() + PATIENCE_S, time.monotonic, _waits)):
            yield
    elif long_refused is not None:
        with _short_time():
            yield
    else:
        yield


@contextmanager
def _short_time() -> Iterator[None]:
    global loaded
    begun_s, most_s = time.thread_time(), HURRY_S if hurry else MOST_S if loaded else FIRST_S
    try:
        with interruptible(_until(begun_s + most_s, time.thread_time, _is_long)):
            yield
    finally:
        loaded = loaded or time.thread_time() - begun_s > LOADED_S


def _until(end_s: float, clock: Callable[[], float], refusal: Callable[[], CNCStepperError]) -> Callable[[], None]:
    def look() -> None:
        if clock() > end_s:
            raise refusal()

    return look


def _waits() -> CNCStepperError:
    what = "large cuts are being prepared, once after an installation"
    return CNCStepperError(WAITS, what, advice="this one is made when that is done, in about a minute")


def _is_long() -> CNCStepperError:
    global hurry
    assert long_refused is not None
    hurry = True
    long_refused()
    what = "this takes long and is calculated in the background"
    return CNCStepperError(LONG, what, advice="it appears when that is done")
