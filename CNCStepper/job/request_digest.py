# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of a question to the cut process, and what names it: a digest of its plain data.

Large parts, which many questions hold, are written and digested once: the window waits for both.
"""

from __future__ import annotations

import functools
import hashlib
import json
from typing import Any


class Content(dict[str, Any]):
    """Plain data that many questions hold: its text and what names it are worked out once. It never changes."""

    @functools.cached_property
    def text(self) -> str:
        """Its JSON."""
        return json.dumps(self, sort_keys=True)

    @functools.cached_property
    def digest(self) -> str:
        """What names it."""
        return _digest(self.text)


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


def text_of(value: Any) -> str:
    """Return the JSON of plain data, in ASCII."""
    if type(value) is Content:
        return value.text
    if type(value) is dict and all(type(key) is str for key in value):
        return f"{{{', '.join(f'{json.dumps(key)}: {text_of(part)}' for key, part in value.items())}}}"
    if type(value) is list and any(type(part) is Content for part in value):
        return f"[{', '.join(map(text_of, value))}]"
    return json.dumps(value)


def digest_of(value: Any) -> str:
    """Return the SHA-256 of plain data."""
    return _digest(json.dumps(value, sort_keys=True))


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode("ascii")).hexdigest()
