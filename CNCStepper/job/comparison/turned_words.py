# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person reads of the parts of two lathe programs: bars, tools, and where the diameters differ.

Diameters are told whatever the programs' X is; a depth is a distance in the half section, as a radius is.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from CNCStepper.errors import Text
from CNCStepper.job.comparison.turned_difference import DifferentRing
from CNCStepper.simulation.turning.turned_part import DUST_MM3, TurnedPart

MOST_RINGS = 12  # that are shown, the deepest ones
Pair = tuple[TurnedPart, TurnedPart]


def turned_sentences(
    parts: Pair, names: tuple[str, str], bars: tuple[Text, Text] | None, rings: Sequence[DifferentRing], same_mm: float
) -> Iterator[Text]:
    """Yield what is to be known of bars and tools, then the deepest difference."""
    if bars:
        what = "the bars differ, {first} and {second}: both parts are cut out of the first one"
        yield Text(what, first=bars[0], second=bars[1])
    for part, name in zip(parts, names, strict=True):
        yield from _of_tools(part, Path(name).name)
    if not rings:
        yield Text("the turned parts are the same within {same_mm:g} mm", same_mm=same_mm)
        return
    yield _ring_sentence(rings[0])
    if len(rings) > 1:
        yield Text("the turned parts differ at {count} places", count=len(rings))


def _of_tools(part: TurnedPart, name: str) -> Iterator[Text]:
    for tool, line in part.left_out.items():
        what = "{name}: the shape of tool {tool} is not known, its cuts from line {line} on are left out"
        yield Text(what, name=name, tool=tool, line=line)
    if part.stock.volume_mm3 - part.section.volume_mm3 < DUST_MM3:
        yield Text("{name} cuts nothing of the bar", name=name)


def _ring_sentence(ring: DifferentRing) -> Text:
    return Text(
        "the turned parts differ by up to {depth_mm:.3f} mm at Z{z_mm:.3f}: {diameters}, from Z{begin_mm:.3f} to "
        "Z{end_mm:.3f}",
        depth_mm=ring.depth_mm, z_mm=ring.at_z_mm, diameters=_diameters(ring), begin_mm=ring.z_mm[0],
        end_mm=ring.z_mm[1],
    )  # fmt: skip


def _diameters(ring: DifferentRing) -> Text:
    if ring.of_both_mm is None:
        low_mm, high_mm = ring.diameters_mm
        return Text("a ring between ø{low_mm:.3f} and ø{high_mm:.3f}", low_mm=low_mm, high_mm=high_mm)
    one_mm, other_mm = ring.of_both_mm
    words: dict[str, float] = {"one_mm": one_mm, "other_mm": other_mm, "by_mm": abs(one_mm - other_mm)}
    if ring.side == "outer":
        return Text("ø{one_mm:.3f} and ø{other_mm:.3f}, {by_mm:.3f} mm in diameter", **words)
    return Text("bores of ø{one_mm:.3f} and ø{other_mm:.3f}, {by_mm:.3f} mm in diameter", **words)


def ring_rows(rings: Sequence[DifferentRing]) -> Iterator[tuple[str, str, str]]:
    """Yield the deepest rings from the end face on, with the diameters of both parts there.

    Of a ring within the parts they are its own, beside the program that has removed it.
    """
    for ring in sorted(rings[:MOST_RINGS], key=lambda ring: -ring.at_z_mm):
        if ring.of_both_mm is None:
            removed = "ø{:.3f} … ø{:.3f}".format(*ring.diameters_mm)
            yield Text("ring at Z{z_mm:.3f}", z_mm=ring.at_z_mm), *((removed, "-") if ring.first else ("-", removed))
            continue
        one, other = (f"ø{diameter_mm:.3f}" for diameter_mm in ring.of_both_mm)
        outer = ring.side == "outer"
        name = Text("diameter at Z{z_mm:.3f}" if outer else "bore at Z{z_mm:.3f}", z_mm=ring.at_z_mm)
        yield name, one, other
