# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as every reader returns it: chains of lines and arcs in mm, with layer, colour, name and groups.

    DXF ──┐
    SVG ──┤
    text ─┼─► Piece: one entity ──► joined(pieces) ──► Drawing: chains · gaps · skipped entities · warnings
    solid ┘

Y points up. Chains keep the order of the file. Texts from the file are printable (safe_text.py).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import JobError, Text
from CNCStepper.geometry.chain_joining import NEAR_MM, Gap, numbered_chains
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import JOINED_ENDS_MM

Share = Callable[[float], None]
"""Called with the share of a reading that is done, 0 to 1."""


@dataclass(frozen=True, slots=True)
class Attributes:
    """What the file says of an entity beside its geometry; "" where it says nothing.

    `colour` is "#rrggbb" in lower case: the stroke, or the fill where there is no stroke. `groups` are the names of the
    groups or blocks around the entity, the outermost first. `filled` is true where the file fills the area.
    """

    layer: str = ""
    colour: str = ""
    name: str = ""
    groups: tuple[str, ...] = ()
    filled: bool = False


@dataclass(frozen=True, slots=True)
class Piece:
    """The curve of one entity, mm, and its attributes."""

    curve: Curve
    attributes: Attributes


@dataclass(frozen=True, slots=True)
class Chain:
    """Pieces that meet, as one curve in mm; the attributes are those of its first piece."""

    curve: Curve
    attributes: Attributes


@dataclass(frozen=True, slots=True)
class Skipped:
    """An entity that is in no chain: its kind, layer and handle (or id) as the file names them, and why."""

    kind: str
    layer: str
    handle: str
    why: str


@dataclass(frozen=True)
class Layer:
    """The chains of one layer as curves, mm, and where their ends nearly meet."""

    name: str
    curves: tuple[Curve, ...]
    gaps: tuple[Gap, ...]


@dataclass(frozen=True)
class Drawing:
    """The chains of a file, where their ends nearly meet, by layer, and what was left out.

    `unit_mm` is the length of the file's unit. `damage` describes a damaged file of which a part may be missing; "" for
    a sound one. `warnings` describe what was read otherwise than the file says (a clip path that was not applied).
    """

    chains: tuple[Chain, ...]
    gaps: tuple[tuple[str, Gap], ...] = ()
    skipped: tuple[Skipped, ...] = ()
    unit_mm: float = 1.0
    damage: str = ""
    warnings: tuple[str, ...] = ()

    @property
    def layers(self) -> tuple[Layer, ...]:
        """The layers that hold chains, in the order in which they first appear."""
        curves: dict[str, list[Curve]] = {}
        for chain in self.chains:
            curves.setdefault(chain.attributes.layer, []).append(chain.curve)
        return tuple(Layer(name, tuple(own), tuple(self._gaps_of(name))) for name, own in curves.items())

    def layer(self, name: str) -> Layer:
        """Return the layer of that name, capital or not; raises JobError that names those there are."""
        for layer in self.layers:
            if layer.name.casefold() == name.casefold():
                return layer
        names = ", ".join(f"'{layer.name}'" for layer in self.layers)
        raise JobError(
            "dxf-layer",
            Text("the drawing has no curves on a layer '{name}'", name=name),
            advice=Text("it has them on {names}", names=names),
        )

    def _gaps_of(self, layer: str) -> Iterator[Gap]:
        return (gap for name, gap in self.gaps if name == layer)


def joined_pieces(
    pieces: Iterable[Piece],
    same_mm: float = JOINED_ENDS_MM,
    near_mm: float = NEAR_MM,
    by_colour: bool = False,
    share: Share = lambda share: None,
) -> tuple[tuple[Chain, ...], tuple[tuple[str, Gap], ...]]:
    """Return the chains of the pieces, in the order of their first pieces, and the gaps left, by layer.

    Only pieces of one layer are joined, and with `by_colour` of one layer and colour: ends within `same_mm`. Gaps up to
    `near_mm` are reported. `share` is called with the share that is done.
    """
    bundles: dict[tuple[str, str], list[tuple[int, Piece]]] = {}
    for number, piece in enumerate(pieces):
        colour = piece.attributes.colour if by_colour else ""
        bundles.setdefault((piece.attributes.layer, colour), []).append((number, piece))
    chains: dict[int, Chain] = {}
    gaps: list[tuple[str, Gap]] = []
    for done, ((layer, _), own) in enumerate(bundles.items(), start=1):
        checkpoint()
        curves, nearly = numbered_chains([piece.curve for _, piece in own], same_mm, near_mm)
        chains |= {own[first][0]: Chain(curve, own[first][1].attributes) for first, curve in curves.items()}
        gaps.extend((layer, gap) for gap in nearly)
        share(done / len(bundles))
    return tuple(chain for _, chain in sorted(chains.items(), key=lambda item: item[0])), tuple(gaps)
