# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cuts that the parts of an order share, as chains of a sheet's drawing, and what they save.

part's outline in a block ──► the block's outline, on the layer of its parts; lines on COMMON, cut on the line
all other chains          ──► where the part lies, on their own layers
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from CNCStepper.drawing.drawing import Attributes, Chain
from CNCStepper.errors import Text
from CNCStepper.job.nesting.order_file import Order
from CNCStepper.nesting.common_lines import CommonCuts, common_cuts
from CNCStepper.nesting.nesting_model import Layout, Placement, placed

COMMON = Attributes(layer="COMMON")
MM_IN_M = 1000.0


@dataclass(frozen=True)
class Saving:
    """What common lines save: mm of cut, pierces; blocks: groups of parts that share cuts; left: those cut apart."""

    length_mm: float
    pierces: int
    blocks: int
    left: int

    @property
    def sentence(self) -> str:
        """The saving in words."""
        return Text(
            "common lines: {blocks} blocks of parts, {length:.3f} m of cut and {pierces} pierces saved",
            blocks=self.blocks,
            length=self.length_mm / MM_IN_M,
            pierces=self.pierces,
        )

    @property
    def notes(self) -> list[str]:
        """What could not be merged, in words."""
        what = Text("{left} blocks of parts are cut apart: no common line fits between them", left=self.left)
        return [what] if self.left else []


def shared_cuts(order: Order, layout: Layout) -> dict[int, CommonCuts]:
    """Return what the parts of each sheet share, by the sheet's number; empty where the order wants no common lines."""
    if not order.common_lines:
        return {}
    return {number: _of_sheet(order, layout, number) for number in layout.sheets}


def saving_of(shared: Mapping[int, CommonCuts]) -> Saving:
    """Return what the common lines of all sheets save."""
    found = shared.values()
    return Saving(
        sum(each.saved_mm for each in found),
        sum(each.saved_pierces for each in found),
        sum(len(each.blocks) for each in found),
        sum(each.left for each in found),
    )


def on_sheet(layout: Layout, number: int) -> list[Placement]:
    """Return the placements on a sheet, in the order by which parts are numbered there."""
    return [placement for placement in layout.placements if placement.sheet == number]


def part_chains(order: Order, lie: Sequence[Placement], cuts: CommonCuts) -> Iterator[Chain]:
    """Yield the chains of the parts on a sheet; those in blocks without their outline."""
    for number, placement in enumerate(lie):
        own = order.chains[placement.item]
        outline = outline_number(own) if number in cuts.parts else None
        yield from (placed_chain(chain, placement) for each, chain in enumerate(own) if each != outline)


def block_chains(
    order: Order, lie: Sequence[Placement], cuts: CommonCuts, lines: Attributes | None = COMMON
) -> Iterator[Chain]:
    """Yield the outlines of the blocks, and their lines on the layer COMMON; lines: None: on that of the outlines."""
    for block in cuts.blocks:
        own = order.chains[lie[block.parts[0]].item]
        attributes = own[outline_number(own)].attributes
        yield from (Chain(loop, attributes) for loop in block.loops)
        yield from (Chain(line, lines or attributes) for line in block.lines)


def placed_chain(chain: Chain, placement: Placement) -> Chain:
    """Return a chain of a part where the placement puts it."""
    turned = chain.curve.rotated(placement.rotation_deg) if placement.rotation_deg else chain.curve
    return Chain(turned.moved(placement.x_mm, placement.y_mm), chain.attributes)


def outline_number(chains: Sequence[Chain]) -> int:
    """Return which chain of a part is its outline: the largest closed one."""
    areas = [abs(chain.curve.area_mm2) if chain.curve.closed else 0.0 for chain in chains]
    return areas.index(max(areas))


def _of_sheet(order: Order, layout: Layout, number: int) -> CommonCuts:
    lie = on_sheet(layout, number)
    drawn = [order.chains[placement.item] for placement in lie]
    outlines = [chains[outline_number(chains)] for chains in drawn]
    return common_cuts(
        [placed_chain(chain, placement).curve for chain, placement in zip(outlines, lie, strict=True)],
        [placed(order.items[placement.item].exact, placement) for placement in lie],
        [chain.attributes for chain in outlines],
        order.sheets[number].outline,
        order.kerf_mm,
    )
