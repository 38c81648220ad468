# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which chains of a drawing are meant: by layer, colour, name, group, closed or open, filled or not.

    layer = "cut*"        the whole name, capital or not; * is any text, ? any character; a list: one of them
    colour = "#ff0000"    as the reader gives it
    group = "sign*"       one of the groups or blocks around the chain

A key that is left out lets every chain through.
"""

from __future__ import annotations

import fnmatch
import re
from collections.abc import Iterable, Sequence
from functools import cache

from pydantic import BaseModel, ConfigDict, Field, StrictBool, field_validator

from CNCStepper.drawing.drawing import Chain
from CNCStepper.errors import Text, joined, one_of
from CNCStepper.safe_text import printable

MOST_PATTERNS = 64
MOST_CHARACTERS = 255
Patterns = tuple[str, ...]


class Selection(BaseModel):
    """The keys by which chains are selected."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    layer: Patterns = Field(default=(), max_length=MOST_PATTERNS)
    colour: Patterns = Field(default=(), max_length=MOST_PATTERNS)
    name: Patterns = Field(default=(), max_length=MOST_PATTERNS)
    group: Patterns = Field(default=(), max_length=MOST_PATTERNS)
    closed: StrictBool | None = None
    filled: StrictBool | None = None

    @field_validator("layer", "colour", "name", "group", mode="before")
    @classmethod
    def _one_or_several(cls, value: object) -> object:
        return (value,) if isinstance(value, str) else value

    @field_validator("layer", "colour", "name", "group")
    @classmethod
    def _is_short(cls, patterns: Patterns) -> Patterns:
        if any(len(pattern) > MOST_CHARACTERS for pattern in patterns):
            raise ValueError(f"a pattern has at most {MOST_CHARACTERS} characters")
        return patterns

    def takes(self, chain: Chain) -> bool:
        """Return whether a chain is selected."""
        told = chain.attributes
        return (
            (self.closed is None or self.closed == chain.curve.closed)
            and (self.filled is None or self.filled == told.filled)
            and _matches(self.layer, (told.layer,))
            and _matches(self.colour, (told.colour,))
            and _matches(self.name, (told.name,))
            and _matches(self.group, told.groups)
        )

    def of(self, chains: Iterable[Chain]) -> tuple[Chain, ...]:
        """Return the chains that are selected, in their order."""
        return tuple(chain for chain in chains if self.takes(chain))

    @property
    def words(self) -> str:
        """The keys that are given, for a person."""
        given = self.model_dump(exclude_defaults=True)
        return joined(", ", [_words(key, value) for key, value in given.items()]) or Text("all of it")


def _words(key: str, value: object) -> str:
    if isinstance(value, Sequence):
        return Text("{key} {choices}", key=key, choices=one_of(f"'{printable(one)}'" for one in value))
    return Text("{key} {answer}", key=key, answer=Text("yes") if value else Text("no"))


def _matches(patterns: Patterns, texts: Sequence[str]) -> bool:
    """Return whether a text matches one of the patterns; without patterns every text does."""
    return not patterns or any(_compiled(pattern).match(text) for pattern in patterns for text in texts)


@cache
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(fnmatch.translate(pattern.replace("[", "[[]")), re.IGNORECASE)
