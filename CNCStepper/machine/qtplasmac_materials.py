# SPDX-License-Identifier: LGPL-2.1-or-later
"""QtPlasmaC's material file (`<machine>_material.cfg`) as rows of a cut chart, and back.

    # units: mm                  a comment for QtPlasmaC, of use for us: the file itself does not say its unit
    [MATERIAL_NUMBER_3]          1 to 999999, in any order; M190 P3 chooses it
    NAME               = mild-steel 3 mm 45A
    KERF_WIDTH         = 1.5     material, thickness and consumable are read from NAME: "3mm Mild Steel 45A",
    PIERCE_HEIGHT      = 3.8 *   "1/8 in Aluminum", "16ga Stainless FineCut"
    PIERCE_DELAY       = 0.4 *
    CUT_HEIGHT         = 1.5 *   * must be there, the others count as 0
    CUT_SPEED          = 3850 *
    ...

Pressures are bar in a file of mm and psi in one of inches. A key that is not QtPlasmaC's is refused, so that none is
lost.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import read_input
from CNCStepper.machine.cut_data import CutData
from CNCStepper.quantities import MOST_ITEMS, Bounds
from CNCStepper.safe_text import printable
from CNCStepper.units import MM_PER_INCH, UNIT_MM
from CNCStepper.word_pattern import DECIMAL

MOST_BYTES, LONGEST_NUMBER = 4_000_000, 40
LARGEST_NUMBER = 999_999  # from 1000000 QtPlasmaC numbers its temporary materials
BAR_PER_PSI = 0.0689475729
KEYS = {  # of the file: (key of CutData, kind of its unit)
    "KERF_WIDTH": ("kerf_mm", "length"),
    "THC": ("thc", ""),
    "PIERCE_HEIGHT": ("pierce_height_mm", "length"),
    "PIERCE_DELAY": ("pierce_delay_s", ""),
    "PUDDLE_JUMP_HEIGHT": ("puddle_jump_height_percent", ""),
    "PUDDLE_JUMP_DELAY": ("puddle_jump_delay_s", ""),
    "CUT_HEIGHT": ("cut_height_mm", "length"),
    "CUT_SPEED": ("feed_mm_min", "length"),
    "CUT_AMPS": ("amperes", ""),
    "CUT_VOLTS": ("volts", ""),
    "PAUSE_AT_END": ("pause_at_end_s", ""),
    "GAS_PRESSURE": ("pressure_bar", "pressure"),
    "CUT_MODE": ("cut_mode", ""),
}
MANDATORY = ("PIERCE_HEIGHT", "PIERCE_DELAY", "CUT_HEIGHT", "CUT_SPEED")
HELD = {"process", "material", "thickness_mm", "consumable", "number", "name", *(key for key, _ in KEYS.values())}
SECTION = re.compile(r"\[MATERIAL_NUMBER_(\d{1,12})\]")
UNITS_LINE = re.compile(r"#\s*units:\s*(mm|inch)\b", re.IGNORECASE)
NUMBER = re.compile(rf"{DECIMAL}(?:[eE][-+]?\d{{1,3}})?")
THICKNESS = re.compile(
    r"(?<![\w.,/])(?:(?P<whole>\d{1,3})[ -](?=\d+/))?(?P<number>\d{1,4}/\d{1,4}|\d{1,5}(?:[.,]\d{1,4})?|[.]\d{1,4})"
    r"\s*(?P<unit>mm\b|inch\b|in\b|\"|ga(?:uge)?\b|gage\b)?",
    re.IGNORECASE,
)
LEAST_PIERCE_MM, MOST_PIERCE_INCH = 0.6, 1.0  # beyond them a file is in the other unit: no torch pierces there
_SHEET_STEEL = "1793 1644 1495 1345 1196 1046 0897 0747 0673 0598 0538 0478 0418 0359 0329 0299 0269 0239"
STEEL_GAUGES_INCH = {gauge: int(digits) / 1e4 for gauge, digits in enumerate(_SHEET_STEEL.split(), start=7)}
STAINLESS_GAUGES_INCH = {10: 0.1406, 11: 0.125, 12: 0.1094, 14: 0.0781, 16: 0.0625, 18: 0.05, 20: 0.0375, 22: 0.0312}


def read_materials(path: Path, units: str = "") -> list[CutData]:
    """Return the materials of a file as rows of a chart of plasma; raises JobError that names the line and the key.

    units: "mm" or "inch", of the machine; "" is what the file's own comment says, else mm.
    """
    text = read_input(path, MOST_BYTES).decode("utf-8-sig", errors="replace")
    said = UNITS_LINE.search(text)
    units = units or (said[1].lower() if said else "mm")
    materials = list(_materials(text, str(path)))
    _refuse_other_units([words for _, words, _ in materials], units, bool(said), Place(str(path)))
    return [_row(number, words, units, place) for number, words, place in materials]


def write_materials(path: Path, rows: Sequence[CutData], units: str = "mm") -> list[str]:
    """Write rows of plasma as a material file in a machine's units; return what of them such a file cannot hold.

    Rows without a number get free ones. Raises JobError for a row of another process and for a number used twice.
    """
    numbers = _numbers(rows, Place(str(path)))
    sections = [_section(row, number, units) for row, number in zip(rows, numbers, strict=True)]
    head = f"# QtPlasmaC material file, made by CNCStepper\n# units: {units}\n\n"
    write_whole(path, (head + "\n".join(sections)).encode("utf-8"))
    lost = {key for row in rows for key in row.model_dump(exclude_defaults=True)} - HELD
    return [Text("a material file has no {key}: left out", key=key) for key in sorted(lost)]


def material_name(row: CutData) -> str:
    """Return the NAME of a row: its own, else material, thickness and consumable."""
    return row.name or f"{row.material} {row.thickness_mm:g} mm {row.consumable}".strip()


# reading


def _materials(text: str, file: str) -> Iterator[tuple[int, dict[str, str], Place]]:
    """Yield number, words and place of each section."""
    number, words, place = 0, dict[str, str](), Place(file)
    seen: set[int] = set()
    for line_number, raw in enumerate(text.splitlines(), start=1):
        line, here = raw.strip(), Place(file, line_number)
        if not line or line.startswith("#"):
            continue
        if section := SECTION.fullmatch(line):
            if number:
                yield number, words, place
            number, words, place = _new_number(int(section[1]), seen, here), {}, here
            continue
        _take_word(line, words, here, inside=bool(number))
    if number:
        yield number, words, place


def _new_number(number: int, seen: set[int], place: Place) -> int:
    if not 1 <= number <= LARGEST_NUMBER:
        raise JobError(
            "material-file",
            "this material number is none of a material file",
            value=f"{number}",
            limit=f"1 to {LARGEST_NUMBER}",
            advice="give it another number",
            place=place,
        )
    if number in seen:
        raise JobError(
            "material-file",
            "a material number is used twice",
            value=f"{number}",
            advice="give each material its own number",
            place=place,
        )
    if len(seen) >= MOST_ITEMS["cuts"]:
        raise JobError(
            "material-file",
            "the file has too many materials",
            limit=f"{MOST_ITEMS['cuts']}",
            advice="split the file",
            place=place,
        )
    seen.add(number)
    return number


def _take_word(line: str, words: dict[str, str], place: Place, inside: bool) -> None:
    key, equals, value = (part.strip() for part in line.partition("="))
    if not equals or not inside:
        raise JobError(
            "material-file",
            Text("not a line of a material file: '{line}'", line=printable(line, 60)),
            advice="write [MATERIAL_NUMBER_n] and below it lines such as: CUT_SPEED = 3850",
            place=place,
        )
    if key != "NAME" and key not in KEYS:
        raise JobError(
            "material-file",
            Text("QtPlasmaC has no key {key}", key=printable(key, 60)),
            advice=Text("take it out, or use one of: NAME, {keys}", keys=", ".join(KEYS)),
            place=place,
        )
    if key in words:
        raise JobError(
            "material-file",
            Text("{key} is twice in one material", key=key),
            advice="take one of them out",
            place=place,
        )
    words[key] = value


def _refuse_other_units(materials: Sequence[dict[str, str]], units: str, said: bool, place: Place) -> None:
    """Raise JobError where the pierce heights of a file that does not say its unit make no sense in `units`."""
    heights = [float(words["PIERCE_HEIGHT"]) for words in materials if _is_number(words.get("PIERCE_HEIGHT", ""))]
    heights = [height for height in heights if height > 0]
    if said or not heights:
        return
    if units == "mm" and max(heights) < LEAST_PIERCE_MM:
        value, other = f"{max(heights):g}", "inch"
    elif units == "inch" and min(heights) > MOST_PIERCE_INCH:
        value, other = f"{min(heights):g}", "mm"
    else:
        return
    raise JobError(
        "material-units",
        Text("the pierce heights make no sense in {units}: the file seems to be in {other}", units=units, other=other),
        value=value,
        advice=Text("begin the file with the line '# units: {other}', or say that unit", other=other),
        place=place,
    )


def _row(number: int, words: dict[str, str], units: str, place: Place) -> CutData:
    missing = [key for key in MANDATORY if not words.get(key)]
    if missing:
        raise JobError(
            "material-file",
            Text("material {number} has no {key}", number=number, key=missing[0]),
            advice=Text("add {key} = and its value", key=missing[0]),
            place=place,
        )
    name = words.get("NAME", "")
    material, thickness_mm, consumable = _from_name(name, number, place)
    given = {own: _value(key, words.get(key, ""), units, number, place) for key, (own, _) in KEYS.items()}
    return CutData(
        process="plasma",
        material=material,
        thickness_mm=thickness_mm,
        consumable=consumable,
        number=number,
        name=name,
        **given,
    )


def _value(key: str, text: str, units: str, number: int, place: Place) -> Any:
    """Return the value of a key in our own unit, within the bounds of ours; one that is not given is 0."""
    own, kind = KEYS[key]
    if text and not _is_number(text):
        raise _bad_value(key, text, number, place)
    value = float(text or 0)
    if own == "thc":
        if value not in (0, 1):
            raise _bad_value(key, text, number, place, "0 or 1")
        return bool(value)
    if own == "cut_mode":
        if value not in (0, 1, 2, 3):
            raise _bad_value(key, text, number, place, "0 to 3")
        return int(value)
    says = Text("{key} of material {number}", key=key, number=number)
    bounds = next(rule for rule in CutData.model_fields[own].metadata if isinstance(rule, Bounds))
    return bounds.require(round(value * _scale(kind, units), 9), says, place)


def _bad_value(key: str, text: str, number: int, place: Place, limit: str = "") -> JobError:
    what = Text("{key} of material {number} has no such value", key=key, number=number)
    return JobError(
        "material-file",
        what,
        value=printable(text, 60),
        limit=limit or "a number",
        advice="correct that line",
        place=place,
    )


def _is_number(text: str) -> bool:
    return len(text) <= LONGEST_NUMBER and NUMBER.fullmatch(text) is not None


def _scale(kind: str, units: str) -> float:
    if kind == "pressure":
        return BAR_PER_PSI if units == "inch" else 1.0
    return UNIT_MM[units] if kind == "length" else 1.0


# names


def _from_name(name: str, number: int, place: Place) -> tuple[str, float, str]:
    """Return material, thickness in mm and consumable that a name speaks of: before, at and behind the thickness."""
    for found in THICKNESS.finditer(name):
        before, behind = name[: found.start()].strip(" -,:"), name[found.end() :].strip(" -,:")
        material, consumable = (before, behind) if before else _split_behind(behind)
        thickness_mm = _thickness_mm(found, material)
        if material and thickness_mm:
            Bounds("depth").require(thickness_mm, Text("the thickness of material {number}", number=number), place)
            return _slug(material), thickness_mm, consumable
    raise JobError(
        "material-name",
        Text("the NAME of material {number} names no material and thickness", number=number),
        value=printable(name, 60),
        advice="write both, as in: NAME = mild-steel 3 mm 45A",
        place=place,
    )


def _split_behind(text: str) -> tuple[str, str]:
    """Return material and consumable of "Mild Steel 45A FineCut": the latter begins at the current."""
    current = re.search(r"\b\d{1,3} ?A(?:mps?)?\b", text, re.IGNORECASE)
    return (text[: current.start()].strip(" -,:"), text[current.start() :].strip()) if current else (text, "")


def _thickness_mm(found: re.Match[str], material: str) -> float:
    """Return the thickness in mm, 0 for a number that is none; a bare fraction is of an inch."""
    unit = (found["unit"] or "").lower()
    top, _, bottom = found["number"].replace(",", ".").partition("/")
    if (bottom and not float(bottom)) or not (unit or bottom):
        return 0.0
    value = float(found["whole"] or 0) + float(top) / float(bottom or 1)
    if unit.startswith("ga"):
        return round(_gauge_inch(int(value), material) * MM_PER_INCH, 4)
    return round(value * (1.0 if unit == "mm" else MM_PER_INCH), 4)


def _gauge_inch(gauge: int, material: str) -> float:
    """Return the thickness of a gauge, which differs from metal to metal; 0 for one that there is not."""
    if "alum" in material.lower():
        return 0.005 * 92 ** ((36 - gauge) / 39) if 0 < gauge <= 40 else 0.0  # Brown and Sharpe
    table = STAINLESS_GAUGES_INCH if "stainless" in material.lower() else STEEL_GAUGES_INCH
    return table.get(gauge, 0.0)


def _slug(material: str) -> str:
    return "-".join(material.lower().split())[:80]


# writing


def _numbers(rows: Sequence[CutData], place: Place) -> list[int]:
    """Return a number for each row: its own, or the next free one."""
    for row in rows:
        if row.process != "plasma":
            raise JobError(
                "material-file",
                Text("a material file holds no rows of {process}", process=row.process),
                advice="write the chart as TOML",
                place=place,
            )
    taken = [row.number for row in rows if row.number]
    twice = next((number for number in taken if taken.count(number) > 1), 0)
    if twice:
        raise JobError(
            "material-file",
            "a material number is used twice",
            value=f"{twice}",
            advice="give each row its own number",
            place=place,
        )
    free = (number for number in range(1, LARGEST_NUMBER + 1) if number not in set(taken))
    return [row.number or next(free) for row in rows]


def _section(row: CutData, number: int, units: str) -> str:
    lines = [f"[MATERIAL_NUMBER_{number}]", f"NAME               = {material_name(row)}"]
    for key, (own, kind) in KEYS.items():
        lines.append(f"{key:18} = {_written(getattr(row, own) / _scale(kind, units))}")
    return "\n".join(lines) + "\n"


def _written(value: float) -> str:
    """Return a number with as many digits as a length in inches needs to be the same one in mm."""
    return f"{value:.7f}".rstrip("0").rstrip(".")
