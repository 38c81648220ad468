# SPDX-License-Identifier: LGPL-2.1-or-later
"""What names a question to the cut process: a digest of its plain data, of which large parts are digested once."""

from __future__ import annotations

import functools
import hashlib
import json
from typing import Any


class Content(dict[str, Any]):
    """Plain data that many questions hold: what names it is worked out once. It never changes."""

    @functools.cached_property
    def digest(self) -> str:
        """What names it."""
        return digest_of(self)


HOLDERS = (Content, dict, list)


def key_of(question: dict[str, Any]) -> str:
    """Return what names a question."""
    return digest_of(_by_names(question))


def _by_names(value: Any) -> Any:
    """Return plain data with the digest of each Content in its place."""
    if type(value) is Content:
        return value.digest
    if type(value) is dict:
        return {key: _by_names(part) if type(part) in HOLDERS else part for key, part in value.items()}
    return [part.digest if type(part) is Content else part for part in value]  # a list, whose lists hold none


def digest_of(value: Any) -> str:
    """Return the SHA-256 of plain data."""
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode("ascii")).hexdigest()
