# SPDX-License-Identifier: LGPL-2.1-or-later
"""The chains of an imported drawing as FreeCAD's own Part objects: one for each layer and colour, or for each chain.

    chains ──► Part: those of one object ──► shape: a wire for each chain, lines and arcs exact
                 └── matched with the objects of before, so that these keep their names when the file is read again

What FreeCAD knows of an object beside its shape are its properties Layer, Colour, ChainName, Groups, Closed and Filled.
"""

from __future__ import annotations

import hashlib
from collections import defaultdict
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np

from CNCStepper.drawing.drawing import Attributes, Chain
from CNCStepper.errors import JobError
from CNCStepper.workbench.drawings.exact_curves import keep_curves
from CNCStepper.workbench.drawings.wires import wire_of
from CNCStepper.workbench.features.base import CONTAINERS, LINK
from CNCStepper.workbench.services.translation import later, tr

BY_LAYER, BY_CHAIN = "layer", "chain"
MOST_PARTS = 1000  # objects that one drawing becomes: FreeCAD's tree is slow with more
FEW_CHAINS = 60  # so many become an object each, unless a person says otherwise
DIGITS = 6  # of a mm: what is nearer is the same place
FINGERPRINT = "Fingerprint"
GROUP = later("Drawing")
TEXTS = {
    "Layer": later("The layer in the file"),
    "Colour": later("The colour in the file"),
    "ChainName": later("The name in the file"),
}
FLAGS = {
    "Closed": later("Whether all of its chains are closed"),
    "Filled": later("Whether the file fills it"),
}


@dataclass(frozen=True)
class ImportedPart:
    """The chains of one object."""

    chains: tuple[Chain, ...]
    by_layer: bool

    @property
    def attributes(self) -> Attributes:
        """What its chains share."""
        first = self.chains[0].attributes
        if not self.by_layer:
            return first
        return Attributes(first.layer, first.colour, filled=all(chain.attributes.filled for chain in self.chains))

    @property
    def label(self) -> str:
        """How it is called in the tree."""
        told = self.attributes
        if told.name:
            return told.name
        return " ".join(filter(None, (told.layer, told.colour if self.by_layer else ""))) or tr("Contour")

    @property
    def fingerprint(self) -> str:
        """A digest of its curves."""
        digest = hashlib.sha256()
        for chain in self.chains:
            for column in (chain.curve.xy, chain.curve.bulge):
                digest.update((np.round(column, DIGITS) + 0.0).tobytes())
        return digest.hexdigest()


def best_split(chains: Sequence[Chain]) -> str:
    """Return what becomes one object unless a person says so: each chain where these are few, else each layer."""
    return BY_CHAIN if len(chains) <= FEW_CHAINS else BY_LAYER


def parts_of_chains(chains: Sequence[Chain], split: str) -> list[ImportedPart]:
    """Return the parts in the order of the file; raises JobError for more than MOST_PARTS."""
    if split == BY_CHAIN:
        _require_few(len(chains))
        return [ImportedPart((chain,), False) for chain in chains]
    found: defaultdict[tuple[str, str], list[Chain]] = defaultdict(list)
    for chain in chains:
        found[chain.attributes.layer, chain.attributes.colour].append(chain)
    _require_few(len(found))
    return [ImportedPart(tuple(own), True) for own in found.values()]


def _require_few(count: int) -> None:
    if count > MOST_PARTS:
        raise JobError(
            "drawing-parts",
            "the drawing would become too many objects",
            value=str(count),
            limit=str(MOST_PARTS),
            advice="make one object of each layer",
        )


def matched(parts: Sequence[ImportedPart], objects: Sequence[Any]) -> list[Any]:
    """Return for each part the object of before that it goes on in, None for a new one; each object once.

    Layer, colour and name say which; of several alike those of the same curves, the others in their order.
    """
    alike: defaultdict[tuple[str, str, str], list[Any]] = defaultdict(list)
    for obj in objects:
        alike[obj.Layer, obj.Colour, obj.ChainName].append(obj)
    found: list[Any] = [None] * len(parts)
    for exactly in (True, False):
        for number, part in enumerate(parts):
            told = part.attributes
            candidates = alike[told.layer, told.colour, told.name]
            if found[number] is not None or not candidates:
                continue
            same = [obj for obj in candidates if not exactly or getattr(obj, FINGERPRINT) == part.fingerprint]
            if same:
                found[number] = same[0]
                candidates.remove(same[0])
    return found


def shape_steps(part: ImportedPart, made: list[Any]) -> Iterator[None]:
    """Append the shape of a part to `made`, a chain at a time, so that a window can see to its events."""
    import Part

    wires = []
    for chain in part.chains:
        wires.append(wire_of(chain.curve, 0.0))
        yield
    made.append(wires[0] if len(wires) == 1 else Part.makeCompound(wires))


def set_part(obj: Any, part: ImportedPart, shape: Any) -> None:
    """Give an object the shape and the attributes of a part; its place and its label stay."""
    placement = obj.Placement
    obj.Shape = shape
    obj.Placement = placement
    told = part.attributes
    obj.Layer, obj.Colour, obj.ChainName, obj.Groups = told.layer, told.colour, told.name, list(told.groups)
    obj.Closed = all(chain.curve.closed for chain in part.chains)
    obj.Filled = told.filled
    setattr(obj, FINGERPRINT, part.fingerprint)
    keep_curves(obj, [chain.curve for chain in part.chains])
    view = getattr(obj, "ViewObject", None)
    if view is not None and told.colour:
        view.LineColor = view.PointColor = tuple(int(told.colour[at : at + 2], 16) / 255.0 for at in (1, 3, 5))


def new_object(document: Any, part: ImportedPart) -> Any:
    """Return a new object for a part, without its shape."""
    obj = document.addObject("Part::Feature", "Contour")
    obj.Label = part.label
    for name, text in TEXTS.items():
        obj.addProperty("App::PropertyString", name, GROUP, text, 1)
    obj.addProperty("App::PropertyStringList", "Groups", GROUP, later("The groups around it in the file"), 1)
    for name, text in FLAGS.items():
        obj.addProperty("App::PropertyBool", name, GROUP, text, 1)
    obj.addProperty("App::PropertyString", FINGERPRINT, GROUP, later("Of its curves"), 1 | 4)
    return obj


@contextmanager
def in_one_group(members: list[Any]) -> Iterator[None]:
    """Take away meanwhile what links objects from other groups than their own.

    FreeCAD takes any link of a group for membership, that of a nest to its parts too, and refuses a member of two
    groups at each change of one of them.
    """
    links = list(_links_of_groups(members))
    for group, name, _ in links:
        _link(group, name, [])
    try:
        yield
    finally:
        for group, name, linked in links:
            _link(group, name, [each for each in map(group.Document.getObject, linked) if each is not None])


def _links_of_groups(members: list[Any]) -> Iterator[tuple[Any, str, list[str]]]:
    """Yield each link of a group to one of some objects but those to its own members: group, property, names."""
    for group in {other for member in members for other in member.InList if hasattr(other, "Group")}:
        for name in group.PropertiesList:
            if name != "Group" and group.getTypeIdOfProperty(name) in (LINK, CONTAINERS):
                linked = getattr(group, name)
                yield group, name, [each.Name for each in (linked if isinstance(linked, list) else [linked]) if each]


def _link(group: Any, name: str, linked: list[Any]) -> None:
    is_list = group.getTypeIdOfProperty(name) == CONTAINERS
    setattr(group, name, linked if is_list else next(iter(linked), None))
