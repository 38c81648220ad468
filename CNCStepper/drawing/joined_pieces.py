# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pieces of a drawing as chains, joined within each layer, all in columns.

pieces ──► those of a layer (and colour) ──► joined_bundle: chains, gaps ──► chains in the order of the file
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.chain_columns import ChainColumns, columns_of
from CNCStepper.drawing.drawing import Chain, Piece, Share
from CNCStepper.geometry.chain_joining import NEAR_MM, Gap, joined_bundle
from CNCStepper.geometry.curve_bundle import bundles_joined
from CNCStepper.tolerances import JOINED_ENDS_MM


def joined_pieces(
    pieces: Iterable[Piece | Chain],
    same_mm: float = JOINED_ENDS_MM,
    near_mm: float = NEAR_MM,
    by_colour: bool = False,
    share: Share = lambda share: None,
) -> tuple[ChainColumns, tuple[tuple[str, Gap], ...]]:
    """Return the chains of the pieces, in the order of their first pieces, and the gaps left, by layer.

    Only pieces of one layer are joined, and with `by_colour` of one layer and colour: ends within `same_mm`. Gaps up to
    `near_mm` are reported. `share` is called with the share that is done.
    """
    columns = columns_of(pieces)
    together: dict[tuple[str, str], int] = {}  # in the order of the file, as the looks are
    keys = [(look.layer, look.colour if by_colour else "") for look in columns.looks]
    group = np.array([together.setdefault(key, len(together)) for key in keys], np.int32)[columns.look]
    bundles, firsts, gaps = [], [np.empty(0, int)], []
    for (layer, _), number in together.items():
        checkpoint()
        chains, first, nearly = joined_bundle(columns.bundle.where(group == number), same_mm, near_mm)
        bundles.append(chains)
        firsts.append(np.flatnonzero(group == number)[first])
        gaps += [(layer, gap) for gap in nearly]
        share((number + 1) / len(together))
    numbers = np.concatenate(firsts)
    order = np.argsort(numbers, kind="stable")
    bundle = bundles_joined(bundles)
    bundles.clear()  # no two copies of them are there at once
    return columns.where(numbers[order], bundle if len(together) == 1 else bundle.taken(order)), tuple(gaps)
