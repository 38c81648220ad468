# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where compiled reading pays, and a text as it takes it; texts for which it does not are read line by line."""

from __future__ import annotations

import sys

BYTE_ORDER_MARK = "\ufeff"
PIECE = 1 << 21  # bytes read at once
PAYS = 16_384  # characters from which on the kernel is faster
PAYS_WITH_LOADING = 1_000_000  # and with loading it first, which takes half a second


def pays(size: int) -> bool:
    """Whether a text of so many characters is read sooner by kernels, and they are there; loads them where it is."""
    if size < (PAYS if "numba" in sys.modules else PAYS_WITH_LOADING):
        return False
    from CNCStepper import kernels

    if not kernels.compiles():
        return False
    kernels.load()  # one call reads a whole piece: as plain Python that takes minutes
    return True


def as_bytes(text: str) -> bytes:
    """Return a text as the compiled reader takes it."""
    return text.removeprefix(BYTE_ORDER_MARK).encode("utf-8", "surrogatepass")
