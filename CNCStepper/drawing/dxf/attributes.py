# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layer, colour, name and groups of a DXF entity, by the layer table and the insertions around it.

    layer    its own; on layer "0" inside a block that of the insertion
    colour   true colour, else the colour index: 256 is that of the layer, 0 that of the insertion
    name     the innermost block around it, or its handle
    groups   the groups that it is in, then the blocks around it, the outermost first

Colour 7 is black or white, as the background wants it; it is read as black.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from CNCStepper.drawing.drawing import Attributes
from CNCStepper.safe_text import printable

MOST_CHARACTERS = 255
BY_LAYER, BY_BLOCK, BLACK_OR_WHITE = 256, 0, 7
BLACK = "#000000"
ESCAPED = "\\U+"  # before the four hexadecimal digits of a letter


@dataclass(frozen=True)
class Insertion:
    """What the insertions around an entity and its groups give to it; outside every block and group nothing."""

    layer: str | None = None
    colour: str = BLACK
    blocks: tuple[str, ...] = ()
    groups: tuple[str, ...] = ()


OUTSIDE = Insertion()


class Layers:
    """Whether each layer of a document is visible, its colour, and its one name: "A" and "a" are the same layer."""

    def __init__(self, document: Any):
        self._document = document
        self._known: dict[str, tuple[bool, str]] = {}
        self._names: dict[str, str] = {}

    def named(self, name: str) -> str:
        """Return the name of a layer as the table writes it, else as it was first asked for."""
        key = name.casefold()
        if key not in self._names:
            table = self._document.layers
            self._names[key] = str(table.get(name).dxf.name) if table.has_entry(name) else name
        return self._names[key]

    def is_hidden(self, name: str) -> bool:
        """Return whether a layer is off or frozen; one that the table does not have is visible."""
        return self._found(name)[0]

    def colour(self, name: str) -> str:
        """Return the colour of a layer, that of index 7 where the table does not have it."""
        return self._found(name)[1]

    def _found(self, name: str) -> tuple[bool, str]:
        if name not in self._known:
            self._known[name] = self._read(name)
        return self._known[name]

    def _read(self, name: str) -> tuple[bool, str]:
        if not self._document.layers.has_entry(name):
            return False, BLACK
        layer = self._document.layers.get(name)
        colour = colour_of(abs(layer.dxf.color), layer.dxf.get("true_color"), BLACK, BLACK)
        return bool(layer.is_off() or layer.is_frozen()), colour


def colour_of(index: int, true_colour: int | None, of_layer: str, of_insertion: str) -> str:
    """Return a colour as "#rrggbb" from its index and its true colour of 24 bits, which goes before the index."""
    from ezdxf import colors  # it takes 0.4 s

    if true_colour is not None:
        return f"#{true_colour & 0xFFFFFF:06x}"
    if index == BY_BLOCK:
        return of_insertion
    if index == BLACK_OR_WHITE:
        return BLACK
    return str(colors.aci2rgb(index).to_hex()) if 0 < index < BY_LAYER else of_layer


def layer_of(entity: Any, around: Insertion) -> str:
    """Return the name of the layer on which an entity lies, as the file writes it."""
    own = str(attribute(entity, "layer", "0"))
    return around.layer if around.layer is not None and own == "0" else own


def entity_colour(entity: Any, layer: str, around: Insertion, layers: Layers) -> str:
    """Return the colour of an entity on a layer."""
    index, true_colour = attribute(entity, "color", BY_LAYER), attribute(entity, "true_color", None)
    return colour_of(index, true_colour, layers.colour(layer), around.colour)


def decoded(text: str) -> str:
    """Return a text of a file with its \\U+XXXX as letters, as files before R2007 write what their code page lacks."""
    from ezdxf import decode_dxf_unicode  # it takes 0.4 s

    return str(decode_dxf_unicode(text)) if ESCAPED in text else text


def attributes(layer: str, colour: str, handle: str, around: Insertion) -> Attributes:
    """Return the attributes of an entity; its texts are made printable."""
    blocks = tuple(printable(decoded(block), MOST_CHARACTERS) for block in around.blocks)
    name = blocks[-1] if blocks else printable(handle, MOST_CHARACTERS)
    return Attributes(printable(decoded(layer), MOST_CHARACTERS), colour, name, (*around.groups, *blocks))


def attribute(entity: Any, name: str, otherwise: Any) -> Any:
    """Return an attribute of an entity; kinds that ezdxf does not know have none."""
    return entity.dxf.get(name, otherwise) if entity.dxf.is_supported(name) else otherwise
