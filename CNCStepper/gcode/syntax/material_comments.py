# SPDX-License-Identifier: LGPL-2.1-or-later
"""QtPlasmaC's comments that define a material, and CNCStepper's own that names the chart row of a numbered one.

    (o=0, na=mild-steel 3 mm 45A, ph=3.8, pd=0.4, ch=1.5, fr=3850, kw=1.5)          temporary: QtPlasmaC selects it
    (o=1, nu=7, ...)  (o=2, nu=7, ...)                                              added to its file, or written over
    (nu=7, na=mild-steel 3 mm 45A, ph=3.8, pd=0.4, ch=1.5, fr=3850, kw=1.5)         for QtPlasmaC a mere comment

Lengths are in the units of the text. With the last one before `M190 P7` a program's feeds are known from its text
alone; what QtPlasmaC takes is its own file's.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any

from CNCStepper.errors import ProgramError, Text
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.qtplasmac_materials import LARGEST_NUMBER, material_name
from CNCStepper.quantities import Bounds
from CNCStepper.safe_text import printable
from CNCStepper.units import UNIT_MM

PARAMETERS = {  # of a comment: (key of CutData, whether its value is a length)
    "ph": ("pierce_height_mm", True),
    "pd": ("pierce_delay_s", False),
    "ch": ("cut_height_mm", True),
    "fr": ("feed_mm_min", True),
    "kw": ("kerf_mm", True),
    "th": ("thc", False),
    "ca": ("amperes", False),
    "cv": ("volts", False),
    "pe": ("pause_at_end_s", False),
    "gp": ("pressure_bar", False),
    "cm": ("cut_mode", False),
    "jh": ("puddle_jump_height_percent", False),
    "jd": ("puddle_jump_delay_s", False),
}
MANDATORY = ("ph", "pd", "ch", "fr")
BEGIN = re.compile(r"(?:o=|nu=)")
VALUE = re.compile(r"[-+]?(?:\d{1,12}\.?\d{0,12}|\.\d{1,12})")
FORBIDDEN = re.compile(r"[^ -~]|[(),;=]")  # what would end a name or the comment


@dataclass(frozen=True)
class MaterialComment:
    """The content of such a comment. option: 0, 1 or 2 of `o`, None in our own. values: by parameter, in mm."""

    option: int | None
    number: int
    name: str
    values: dict[str, float] = field(default_factory=dict)

    @property
    def feed_mm_min(self) -> float:
        """The cut feed."""
        return self.values["fr"]

    def text(self, units: str) -> str:
        """Return the comment, without its parentheses, for a text in "mm" or "inch"."""
        parts = [] if self.option is None else [f"o={self.option}"]
        parts += [f"nu={self.number}"] if self.number else []
        parts += [f"na={self.name}"] if self.name else []
        for key, value in self.values.items():
            scale = UNIT_MM[units] if PARAMETERS[key][1] else 1.0
            parts.append(f"{key}={f'{value / scale:.6f}'.rstrip('0').rstrip('.')}")
        return ", ".join(parts)


def comment_of(row: CutData) -> MaterialComment:
    """Return the comment for a row of a chart: of its number where it has one, else a temporary material."""
    name = FORBIDDEN.sub(" ", material_name(row)).strip()
    given: dict[str, Any] = {key: getattr(row, own) for key, (own, _) in PARAMETERS.items()}
    values = {key: float(value) for key, value in given.items() if value or key in MANDATORY}
    return MaterialComment(None if row.number else 0, row.number, name, values)


def read_material_comment(text: str, units: str) -> MaterialComment | None:
    """Return the material of a comment (without its parentheses) in a text in `units`; None for other comments.

    Raises ProgramError for one that QtPlasmaC, or the reader of our own, could not take.
    """
    if not BEGIN.match(text):
        return None
    given = _parameters(text)
    option = _whole(given.pop("o"), "o", 0, 2) if "o" in given else None
    number = _whole(given.pop("nu"), "nu", 1, LARGEST_NUMBER) if "nu" in given else 0
    name = given.pop("na", "")
    if option in (1, 2) and not (number and name):
        raise _bad("the comment of a material lacks nu= or na=", text, "give the material its number and name")
    missing = [key for key in MANDATORY if key not in given]
    if missing:
        raise _bad(Text("the comment of a material lacks {key}=", key=missing[0]), text, "write ph=, pd=, ch= and fr=")
    values = {key: _value(key, value, units) for key, value in given.items()}
    return MaterialComment(option, 0 if option == 0 else number, name, values)


def _parameters(text: str) -> dict[str, str]:
    given: dict[str, str] = {}
    for part in text.split(","):
        key, equals, value = part.strip().partition("=")
        if not equals or (key not in PARAMETERS and key not in ("o", "nu", "na")):
            raise _bad(
                "not a parameter of a material's comment",
                part.strip(),
                Text("use o, nu, na, {parameters}", parameters=", ".join(PARAMETERS)),
            )
        if key in given:
            raise _bad(Text("{key}= is twice in a material's comment", key=key), part.strip(), "take one out")
        given[key] = value.strip()
    return given


def _whole(text: str, key: str, least: int, most: int) -> int:
    if not text.isdigit() or len(text) > 9 or not least <= int(text) <= most:
        raise _bad(
            Text("{key}= of a material has no such value", key=key),
            text,
            Text("write {least} to {most}", least=least, most=most),
        )
    return int(text)


def _value(key: str, text: str, units: str) -> float:
    """Return a value in mm, seconds or its own unit; raises ProgramError for one beyond the bounds of a chart."""
    own, is_length = PARAMETERS[key]
    value = float(text) * (UNIT_MM[units] if is_length else 1.0) if VALUE.fullmatch(text) else float("nan")
    rules = [rule for rule in CutData.model_fields[own].metadata if isinstance(rule, Bounds)]
    allowed = [rule.allows(int(value) if value.is_integer() else value) for rule in rules]
    allowed += [value.is_integer()] if own == "cut_mode" else []
    if not (all(allowed) if rules else value in (0.0, 1.0)):
        limit = rules[0].words if rules else Text("0 or 1")
        what = Text("{key}= of a material is out of its bounds", key=key)
        raise ProgramError("material", what, value=printable(text, 40), limit=limit, advice="correct the comment")
    return value


def _bad(what: str, value: str, advice: str) -> ProgramError:
    return ProgramError("material", what, value=printable(value, 60), advice=advice)
