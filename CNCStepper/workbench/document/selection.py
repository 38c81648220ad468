# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of the selected objects an operation can follow, and why not the others."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from CNCStepper.errors import CNCStepperError, GeometryError, Text
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.features.cycle_operation import CycleOperation

TOLERANCE_MM = 0.01  # in which it is seen whether lines close and which are drawn twice
Pair = tuple[Any, tuple[str, ...]]


@dataclass(frozen=True)
class Selected:
    """The drawings that can be followed, in the order of the document, and why the others cannot."""

    used: tuple[Pair, ...]
    refusals: tuple[CNCStepperError, ...]

    def require(self) -> None:
        """Raise the reason when there is no drawing that can be followed though some were selected."""
        if self.used or not self.refusals:
            return
        if len(self.refusals) == 1:
            raise self.refusals[0]
        raise GeometryError(
            "drawings-unusable",
            "none of the selected drawings can be followed",
            value="; ".join(error.what for error in self.refusals),
            advice="mend one of them, or select others",
        )


def members(obj: Any) -> list[Any]:
    """Return an object, or what a group, layer or part holds, at any depth; what a job is made of is no drawing."""
    found: dict[Any, None] = {}
    waiting = [obj]
    while waiting:
        one = waiting.pop()
        if _is_group(one):
            waiting += [member for member in reversed(one.Group) if member not in found]
        elif one.isDerivedFrom("Part::Feature") or not (_is_ours(one) or _is_origin(one)):
            found[one] = None
    return list(found)


def selected_drawings(kind: type[CycleOperation], pairs: Iterable[Pair]) -> Selected:
    """Return which drawings an operation of a kind can follow, each with its picked faces and edges, () for all of it.

    The order of the pairs does not matter.
    """
    ordered = sorted(((drawing, _in_order(names)) for drawing, names in pairs), key=lambda pair: pair[0].ID)
    used, refusals = _each_alone(kind, ordered)
    if kind.CLOSED or not (kind.SHAPE or kind.PICKS_LINES):
        used, more = _together(used, kind.CLOSED)
        refusals += more
    if kind.SHAPE or kind.ONE_DRAWING:
        refusals += [_one_only(drawing, used[0][0]) for drawing, _ in used[1:]]
        used = used[:1]
    return Selected(tuple(used), tuple(refusals))


def _each_alone(kind: type[CycleOperation], pairs: Sequence[Pair]) -> tuple[list[Pair], list[CNCStepperError]]:
    used, refusals = [], []
    for drawing, names in pairs:
        try:
            _require_lines(drawing, names, kind.TAKES_SOLIDS)
            if not kind.CLOSED:
                kind.look(drawing, names)
            used.append((drawing, names))
        except CNCStepperError as error:
            refusals.append(error)
    return used, refusals


def _together(pairs: list[Pair], closed: bool) -> tuple[list[Pair], list[CNCStepperError]]:
    """Return which drawings go together, without those that are drawn twice and, where it counts, that stay open."""
    from CNCStepper.workbench.drawings.joined_curves import drawn_of
    from CNCStepper.workbench.drawings.shapes import open_line

    refusals: dict[Any, CNCStepperError] = {}
    while True:
        left, sound = [pair for pair in pairs if pair[0] not in refusals], len(refusals)
        for drawing, names in left:
            try:
                drawn_of([(drawing, names)], TOLERANCE_MM)
            except CNCStepperError as error:
                refusals[drawing] = error
        if len(refusals) > sound:
            continue
        drawn = drawn_of(left, TOLERANCE_MM)
        needed = {drawing for each in drawn.curves for drawing in each.drawings}
        for out, kept in drawn.doubled:
            if out.drawings[0] not in needed:
                refusals[out.drawings[0]] = _drawn_twice(out.label, kept.label)
        for each in drawn.curves if closed else ():
            if not each.curve.closed:
                end = tuple(each.curve.xy[-1])
                refusals |= {drawing: open_line(drawing.Label, end) for drawing in each.drawings}
        if len(refusals) == sound:
            return left, [refusals[drawing] for drawing, _ in pairs if drawing in refusals]


def _require_lines(drawing: Any, names: tuple[str, ...], solids: bool) -> None:
    """Raise GeometryError for what is no drawing, or a solid of which nothing is picked."""
    shape = getattr(drawing, "Shape", None)
    if not drawing.isDerivedFrom("Part::Feature") or shape is None or drawing.isDerivedFrom("Part::Datum"):
        raise GeometryError(
            "drawing-kind",
            Text("'{drawing}' holds no lines that can be followed", drawing=drawing.Label),
            advice="select a sketch, wires, faces or edges",
        )
    if shape.Solids and not (names or solids):
        raise GeometryError(
            "drawing-solid",
            Text("'{drawing}' is a solid", drawing=drawing.Label),
            advice="select those of its faces or edges that count",
        )


def _drawn_twice(label: str, other: str) -> CNCStepperError:
    what = Text("'{label}' is drawn where '{other}' is, and counts once", label=label, other=other)
    advice = "take one of them out"
    return GeometryError("drawing-twice", what, advice=advice)


def _one_only(drawing: Any, used: Any) -> CNCStepperError:
    return GeometryError(
        "drawing-second",
        Text(
            "'{drawing}' is one more drawing beside '{used}', and only one gives the shape",
            drawing=drawing.Label,
            used=used.Label,
        ),
        advice="cut them together as a pocket, or this one with an operation of its own",
    )


def _in_order(names: Iterable[str]) -> tuple[str, ...]:
    """Return the names of faces and edges by kind and number: "Face2" before "Face10"."""
    return tuple(sorted(names, key=lambda name: (name.rstrip("0123456789"), len(name), name)))


def _is_group(obj: Any) -> bool:
    return "Group" in obj.PropertiesList and not obj.isDerivedFrom("Part::Feature")


def _is_origin(obj: Any) -> bool:
    return bool(obj.isDerivedFrom("App::Origin") or obj.isDerivedFrom("App::OriginFeature"))


def _is_ours(obj: Any) -> bool:
    return proxy_type(obj).startswith("CNCStepper_")
