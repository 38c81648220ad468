# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON that keeps the templates and values of texts.

A `Text` is written as its English; the key "templates" of the outermost object holds template and values of each.
Readers that do not know the key see the English, and a file without the key is read as it is.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

from CNCStepper.errors import Text

TEMPLATES = "templates"
MOST_VALUES, MOST_NESTED = 40, 8
MOST_CHARACTERS = 10_000  # of a text or of a value in one
FIELD = re.compile(  # no width that fills the memory
    r"\{[a-z_]\w*(![ra])?(:[^{}\d]{0,3}\d{0,2}(\.\d{1,2})?[a-zA-Z%]?)?\}"
)


def dumps(content: Mapping[str, Any], **options: Any) -> str:
    """Return an object as JSON, with the templates and values of the texts in it."""
    return json.dumps(with_texts(content), **options)


def loads(text: str | bytes | bytearray) -> Any:
    """Return the object of `dumps`, or what any other JSON holds; raises ValueError for text that is no JSON."""
    return restored(json.loads(text))


def with_texts(content: Mapping[str, Any]) -> dict[str, Any]:
    """Return an object with the key "templates", where it holds texts with values."""
    texts: dict[str, Any] = {}
    _collect(content, texts)
    return {**content, TEMPLATES: texts} if texts else dict(content)


def restored(content: Any) -> Any:
    """Return the object of `with_texts` after its way through JSON; a template that does not give its English goes."""
    if not isinstance(content, dict) or not isinstance(content.get(TEMPLATES), dict):
        return content
    known = {english: text for english, told in content[TEMPLATES].items() if (text := _text(told)) == english}
    return _replaced({key: value for key, value in content.items() if key != TEMPLATES}, known)


def _collect(content: Any, texts: dict[str, Any]) -> None:
    if isinstance(content, Text):
        texts[str(content)] = _plain(content)
    elif isinstance(content, Mapping):
        for value in () if TEMPLATES in content else content.values():
            _collect(value, texts)
    elif isinstance(content, list | tuple):
        for value in content:
            _collect(value, texts)


def _plain(text: Text) -> dict[str, Any]:
    values = {name: _plain(value) if isinstance(value, Text) else value for name, value in text.values.items()}
    return {"template": text.template, "values": values}


def _text(content: Any, nested: int = 0) -> Any:
    """Return the text or other value of `_plain`, None for what is none."""
    if isinstance(content, str | int | float):
        return content
    try:
        template, values = content["template"], content["values"]
        if nested == MOST_NESTED or len(values) > MOST_VALUES or set("{}") & set(FIELD.sub("", template)):
            return None
        text = Text(template, **{name: _text(value, nested + 1) for name, value in values.items()})
        return text if len(text) <= MOST_CHARACTERS else None
    except (TypeError, KeyError, ValueError, AttributeError, IndexError):
        return None


def _replaced(content: Any, texts: dict[str, Text]) -> Any:
    if isinstance(content, str):
        return texts.get(content, content)
    if isinstance(content, dict):
        return {key: _replaced(value, texts) for key, value in content.items()}
    return [_replaced(value, texts) for value in content] if isinstance(content, list) else content
