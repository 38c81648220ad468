# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which groups (GROUP) of a DXF drawing each entity is in, by its handle.

ezdxf knows the names of the groups; their entities are taken from the text, since those that are read straight
(plain_entities.py) are not in its document.
"""

from __future__ import annotations

import re
from typing import Any

from CNCStepper.drawing.dxf.attributes import MOST_CHARACTERS, decoded
from CNCStepper.safe_text import printable

_GROUP = re.compile(rb"\n[ \t]*0[ \t]*\r?\nGROUP[ \t]*\r?\n(.*?)(?=\n[ \t]*0[ \t]*\r?\n[A-Z])", re.DOTALL)
_OWN = re.compile(rb"(?:^|\n)[ \t]*5[ \t]*\r?\n[ \t]*([0-9A-Fa-f]+)")
_MEMBER = re.compile(rb"\n[ \t]*340[ \t]*\r?\n[ \t]*([0-9A-Fa-f]+)")


def groups_of(document: Any, text: bytes | None) -> dict[str, tuple[str, ...]]:
    """Return the names of the groups round each entity that is in one, by its handle in capitals.

    `text` has the groups where the document lacks entities of theirs, None where it has them all.
    """
    names = {
        str(group.dxf.handle).upper(): printable(decoded(name), MOST_CHARACTERS) for name, group in document.groups
    }
    if text is None:
        members = {str(group.dxf.handle).upper(): list(group.handles()) for _, group in document.groups}
    else:
        members = dict(map(_members, _GROUP.findall(text))) if names else {}
    found: dict[str, tuple[str, ...]] = {}
    for group, handles in members.items():
        for handle in map(str.upper, handles) if group in names else ():
            if names[group] not in found.get(handle, ()):
                found[handle] = (*found.get(handle, ()), names[group])
    return found


def _members(body: bytes) -> tuple[str, list[str]]:
    """Return the handle of a group and those of its entities."""
    own = _OWN.search(body)
    return own[1].decode("ascii").upper() if own else "", [each.decode("ascii") for each in _MEMBER.findall(body)]
