# SPDX-License-Identifier: LGPL-2.1-or-later
"""A drawing as every reader returns it: chains of lines and arcs in mm, with layer, colour, name and groups.

    DXF ──┐
    SVG ──┤
    text ─┼─► Piece: one entity ──► joined_pieces ──► Drawing: chains · gaps · skipped entities · warnings
    solid ┘

Y points up. Chains keep the order of the file. Texts from the file are printable (safe_text.py).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from CNCStepper.errors import JobError, Text
from CNCStepper.geometry.chain_joining import Gap
from CNCStepper.geometry.curve import Curve

Share = Callable[[float], None]
"""Called with the share of a reading that is done, 0 to 1."""

KERF = "Kerf"  # the custom variable of a DXF file that holds the kerf of a nested sheet, mm


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
    `kerf_mm` is the kerf for which parts on a nested sheet share cuts, None where they share none.
    """

    chains: Sequence[Chain]
    gaps: tuple[tuple[str, Gap], ...] = ()
    skipped: tuple[Skipped, ...] = ()
    unit_mm: float = 1.0
    damage: str = ""
    warnings: tuple[str, ...] = ()
    kerf_mm: float | None = None

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
