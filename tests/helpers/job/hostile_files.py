# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutated job files, profiles, tool files and drawings, each from its seed; most of them stay readable.

A case is a good file with one to three mutations of its content (a number scaled, a key gone, a list of 20 000) or of
its bytes (a bit turned, the end cut off). What a mutation is called is kept, so that a run can see that each occurred.
"""

from __future__ import annotations

import io
import json
import math
import random
import tomllib
from collections.abc import Callable
from copy import deepcopy
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import ezdxf

ROOT = Path(__file__).parents[3]
JOBS = sorted((ROOT / "examples" / "jobs" / "cycles").glob("*.toml"))
PROFILES = sorted((ROOT / "CNCStepper" / "machine" / "profiles").glob("*.toml"))
BITS = sorted((ROOT / "tests" / "data" / "tools" / "Bit").glob("*.fctb"))
TABLE = "T1 P1 D6.0 Z+41.5 ;6 mm end mill\nT2 P2 D3 Z10 ;drill 3\nT3 P3 Z1.2 ;probe\nT4 P4 D12.5 X1 Y2 ;ball nose\n"
WILD_NUMBERS = (1e-308, 1e18, -1.0, 0.0, math.nan, math.inf, -math.inf, 1e5, 1e-9, 10**400, 2**63, -(10**9))
WILD_VALUES: tuple[Any, ...] = (True, "1.5", "", "\x1b]0;t\x07", [], {}, [[]], {"a": {"b": 1}}, "x" * 5000, 17, [1, 2])
NAMES = ("peça ç", "a b", "\u202e", "x" * 300, "名")
LONG = 20_000
DEEP = 3000
FILES = (".csv", ".dxf")  # that a job names, beside it

Place = tuple[Any, Any]  # a table or list, and a key or index in it


@dataclass
class Case:
    """A mutated file: its ending, its bytes, and the names of the mutations in it."""

    ending: str
    content: bytes
    mutations: list[str] = field(default_factory=list)


def places(content: Any, wanted: Callable[[Any], bool]) -> list[Place]:
    """Return where in nested tables and lists a wanted value stands."""
    items = content.items() if isinstance(content, dict) else enumerate(content) if isinstance(content, list) else ()
    found: list[Place] = []
    for key, value in list(items):
        if wanted(value):
            found.append((content, key))
        found += places(value, wanted)
    return found


def is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _chosen(dice: random.Random, content: Any, wanted: Callable[[Any], bool]) -> Place | None:
    found = places(content, wanted)
    return dice.choice(found) if found else None


def scaled(dice: random.Random, content: Any) -> None:
    if place := _chosen(dice, content, lambda value: isinstance(value, float)):
        place[0][place[1]] = round(place[0][place[1]] * dice.uniform(0.8, 1.2), dice.randint(2, 9))


def reordered(dice: random.Random, content: Any) -> None:
    keys = list(content)
    dice.shuffle(keys)
    for key in keys:
        content[key] = content.pop(key)


def whole(dice: random.Random, content: Any) -> None:
    if place := _chosen(dice, content, lambda value: isinstance(value, float) and value == int(value)):
        place[0][place[1]] = int(place[0][place[1]])


def renamed(dice: random.Random, content: Any) -> None:
    """Give each name another one, also where it is referred to."""
    texts = places(content, lambda value: isinstance(value, str))
    old = sorted({table[key] for table, key in texts if key in ("name", "label", "title")})
    new = {name: f"{dice.choice(NAMES)}{number}" for number, name in enumerate(old)}
    for table, key in texts:
        if table[key] in new and key != "cycle":
            table[key] = new[table[key]]


def halved(dice: random.Random, content: Any) -> None:
    if place := _chosen(dice, content, is_number):
        place[0][place[1]] = place[0][place[1]] / 2


def wild_number(dice: random.Random, content: Any) -> None:
    if place := _chosen(dice, content, is_number):
        place[0][place[1]] = dice.choice(WILD_NUMBERS)


def other_type(dice: random.Random, content: Any) -> None:
    if place := _chosen(dice, content, lambda value: True):
        place[0][place[1]] = deepcopy(dice.choice(WILD_VALUES))


def without_key(dice: random.Random, content: Any) -> None:
    if place := _chosen(dice, content, lambda value: True):
        del place[0][place[1]]


def unknown_key(dice: random.Random, content: Any) -> None:
    tables = [content, *(table[key] for table, key in places(content, lambda value: isinstance(value, dict)))]
    dice.choice(tables)[dice.choice(("speling", "points", "a.b", "", "curves"))] = dice.choice((17, "x", [1], {}))


def long_list(dice: random.Random, content: Any) -> None:
    if place := _chosen(dice, content, lambda value: isinstance(value, list) and len(value) > 0):
        place[0][place[1]] = place[0][place[1]] * (LONG // len(place[0][place[1]]))


def deep_list(dice: random.Random, content: Any) -> None:
    nested: Any = []
    for _ in range(DEEP):
        nested = [nested]
    if place := _chosen(dice, content, lambda value: True):
        place[0][place[1]] = nested


def other_text(dice: random.Random, content: Any) -> None:
    if place := _chosen(dice, content, lambda value: isinstance(value, str)):
        place[0][place[1]] = dice.choice(("", "none", "\x00", "/dev/zero", "..", "T1\n\x1b[2J", "å" * 400))


KIND = [scaled, reordered, whole, renamed]  # these mostly leave a file readable
MEAN = [halved, wild_number, other_type, without_key, unknown_key, long_list, deep_list, other_text]


def turned_bit(dice: random.Random, content: bytes) -> bytes:
    at = dice.randrange(len(content))
    return content[:at] + bytes([content[at] ^ (1 << dice.randrange(8))]) + content[at + 1 :]


def cut_off(dice: random.Random, content: bytes) -> bytes:
    return content[: dice.randrange(len(content))]


def twice(dice: random.Random, content: bytes) -> bytes:
    first, last = sorted(dice.randrange(len(content)) for _ in range(2))
    return content[:last] + content[first:]


def long_digits(dice: random.Random, content: bytes) -> bytes:
    digits = [at for at, byte in enumerate(content) if chr(byte).isdigit()]
    at = dice.choice(digits) if digits else 0
    return content[:at] + b"9" * dice.choice((30, 400, 5000)) + content[at:]


def comment(dice: random.Random, content: bytes) -> bytes:
    return content + b"\n" * dice.randint(1, 5)


BYTES = [turned_bit, cut_off, twice, long_digits]


def mutated(dice: random.Random, content: Any, seed: int) -> list[str]:
    """Mutate a content in place; return the names of what was done. Two in three are kind."""
    chosen = dice.choices(KIND, k=dice.randint(1, 2)) if dice.random() < 0.72 else [MEAN[seed % len(MEAN)]]
    for mutate in chosen:
        mutate(dice, content)
    return [mutate.__name__ for mutate in chosen]


def bytes_mutated(dice: random.Random, case: Case, share: float) -> Case:
    """Return the case with a mutation of its bytes, in a share of the cases."""
    mutate = dice.choice(BYTES) if dice.random() < share else comment
    return Case(case.ending, mutate(dice, case.content), [*case.mutations, mutate.__name__])


def toml(value: Any) -> str:
    """Return a value as TOML, tables within others inline."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key)} = {toml(each)}" for key, each in value.items()) + "}"
    if isinstance(value, list):
        return "[" * _depth(value) + ", ".join(map(toml, _core(value))) + "]" * _depth(value)
    return repr(value)


def _depth(value: list[Any]) -> int:
    """Return how often a list holds nothing but a list, itself counted: a deep one needs no recursion."""
    depth = 1
    while len(value) == 1 and isinstance(value[0], list):
        value, depth = value[0], depth + 1
    return depth


def _core(value: list[Any]) -> list[Any]:
    while len(value) == 1 and isinstance(value[0], list):
        value = value[0]
    return value


def _toml_file(content: dict[str, Any]) -> bytes:
    return "".join(f"{json.dumps(key)} = {toml(value)}\n" for key, value in content.items()).encode("utf-8", "replace")


def job_case(seed: int) -> Case:
    """Return a mutated job file."""
    dice = random.Random(f"job {seed}")
    content = tomllib.loads(dice.choice(JOBS).read_text("utf-8"))
    content["machine"] = dice.choice(("table-a", "table-b"))
    for table, key in places(content, lambda value: isinstance(value, str) and value.endswith(FILES)):
        table[key] = str((JOBS[0].parent / table[key]).resolve())
    done = mutated(dice, content, seed)
    return bytes_mutated(dice, Case(".toml", _toml_file(content), done), 0.12)


def profile_case(seed: int) -> Case:
    """Return a mutated machine profile."""
    dice = random.Random(f"profile {seed}")
    content = tomllib.loads(dice.choice(PROFILES).read_text("utf-8"))
    done = mutated(dice, content, seed)
    return bytes_mutated(dice, Case(".toml", _toml_file(content), done), 0.12)


def tool_case(seed: int) -> Case:
    """Return a mutated tool bit, library or table."""
    dice = random.Random(f"tools {seed}")
    ending = dice.choice((".fctb", ".fctl", ".tbl"))
    if ending == ".tbl":
        return bytes_mutated(dice, Case(ending, TABLE.encode(), [ending]), 0.3)
    content = json.loads(dice.choice(BITS).read_text("utf-8"))
    if ending == ".fctl":
        content = {"tools": [{"nr": k + 1, "path": bit.name} for k, bit in enumerate(BITS)], "version": 1}
    done = mutated(dice, content, seed)
    text = _json(content)
    return bytes_mutated(dice, Case(ending, text.encode("utf-8", "surrogatepass"), [*done, ending]), 0.12)


def _json(content: Any) -> str:
    """Return a content as JSON; a list of DEEP is deeper than json writes."""
    try:
        return json.dumps(content)
    except RecursionError:
        return json.dumps({key: value for key, value in content.items() if not _deep(value)}) + "[" * DEEP


def _deep(value: Any) -> bool:
    return bool(places_deeper(value))


def places_deeper(value: Any, most: int = 50) -> bool:
    """Return whether lists and tables are nested deeper than `most`."""
    level = [value]
    for _ in range(most):
        inner: list[Any] = []
        for each in level:
            inner += list(each.values()) if isinstance(each, dict) else each if isinstance(each, list) else []
        level = inner
    return bool(level)


def drawing_case(seed: int) -> Case:
    """Return a drawing of random entities with mutated groups."""
    dice = random.Random(f"drawing {seed}")
    document = ezdxf.new(dice.choice(("R12", "R2000", "R2010")), units=4)
    _draw(dice, document)
    stream = io.StringIO()
    document.write(stream)
    lines = stream.getvalue().splitlines()
    first = lines.index("BLOCKS") if "BLOCKS" in lines else 0
    done = []
    for _ in range(dice.randint(0, 2)):
        mutate = dice.choice([group_number, group_number, group_text, group_gone])
        mutate(dice, lines, first)
        done.append(mutate.__name__)
    return bytes_mutated(dice, Case(".dxf", ("\n".join(lines) + "\n").encode(), done), 0.15)


def _draw(dice: random.Random, document: Any) -> None:
    space, block = document.modelspace(), document.blocks.new("B")
    block.add_line((0, 0), (3, 4))
    for _ in range(dice.randint(3, 12)):
        x, y = dice.uniform(0, 100), dice.uniform(0, 100)
        kind = dice.randrange(6)
        if kind == 0:
            space.add_line((x, y), (x + 10, y), {"layer": "cut"})
        elif kind == 1:
            space.add_circle((x, y), dice.uniform(1, 9))
        elif kind == 2:
            space.add_arc((x, y), 5, 10, dice.uniform(20, 350))
        elif kind == 3 and document.dxfversion > "AC1009":
            space.add_open_spline([(x + 4 * k, y + dice.uniform(0, 9)) for k in range(dice.randint(4, 12))])
        elif kind == 4:
            space.add_blockref("B", (x, y)).grid(size=(dice.randint(1, 3), 2), spacing=(5, 5))
        else:
            space.add_polyline2d([(x, y), (x + 5, y), (x + 5, y + 5)])


def _values(lines: list[str], first: int, codes: set[str]) -> list[int]:
    return [at + 1 for at in range(first - first % 2, len(lines) - 1, 2) if lines[at].strip() in codes]


def group_number(dice: random.Random, lines: list[str], first: int) -> None:
    if found := _values(lines, first, {"10", "20", "11", "40", "42", "70", "71", "72", "73", "74", "50", "41"}):
        lines[dice.choice(found)] = dice.choice(("1e300", "nan", "-1", "0", "250", "1e18", "7.5", "999999999"))


def group_text(dice: random.Random, lines: list[str], first: int) -> None:
    if found := _values(lines, first, {"2", "8", "5", "330", "100"}):
        lines[dice.choice(found)] = dice.choice(("", "\x1b[31m", "B", "x" * 500, "FFFFFFFFFFFFFFFFFFFF", "0"))


def group_gone(dice: random.Random, lines: list[str], first: int) -> None:
    at = dice.choice(_values(lines, first, {"10", "20", "40", "2", "8", "73"}) or [1])
    del lines[at - 1 : at + 1]
