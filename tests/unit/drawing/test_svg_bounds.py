# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hostile SVG drawings: refused, or read with what is wrong told, in bounded time and memory; nothing is fetched."""

from __future__ import annotations

import gzip
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import pytest

from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import JobError

HEAD = '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50">'
BOX = '<rect width="5" height="4"/>'
GROWN = f'<!DOCTYPE svg [<!ENTITY x "{"x" * 200}">]>{HEAD}{BOX}<text>%s</text></svg>'
LONGEST_S, MOST_BYTES = 20.0, 400_000_000


def _nested_uses(levels: int, each: int) -> str:
    rows = [f'<g id="g{n}">' + f'<use href="#g{n - 1}"/>' * each + "</g>" for n in range(1, levels)]
    return f'{HEAD}<defs><g id="g0">{BOX}</g>{"".join(rows)}</defs><use href="#g{levels - 1}"/></svg>'


LAUGHS = "".join(f'<!ENTITY l{n} "{f"&l{n - 1};" * 10}">' for n in range(1, 12))
REFUSED = {
    "entities in each other": (
        f'<!DOCTYPE svg [<!ENTITY l0 "ha">{LAUGHS}]>{HEAD}<text>&l11;</text></svg>',
        "svg-entity",
    ),
    "entity of a file": (
        f'<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]>{HEAD}<text>&x;</text></svg>',
        "svg-entity",
    ),
    "parameter entity": (f"<!DOCTYPE svg [<!ENTITY % p \"<!ENTITY q 'q'>\"> %p;]>{HEAD}{BOX}</svg>", "svg-entity"),
    "long entity": (
        f'<!DOCTYPE svg [<!ENTITY x "{"x" * 99_999}">]>{HEAD}<text>{"&x;" * 9999}</text></svg>',
        "svg-entity",
    ),
    "entity often": (
        f'<!DOCTYPE svg [<!ENTITY x "{"x" * 256}">]>{HEAD}' + f'<rect id="{"&x;" * 1000}"/>' * 90 + "</svg>",
        "svg-large",
    ),
    "no end": (HEAD + BOX, "svg-file"),
    "no svg": ("<html/>", "svg-file"),
    "nothing": ("", "svg-file"),
    "deep groups": (HEAD + "<g>" * 100_000 + BOX + "</g>" * 100_000 + "</svg>", "svg-large"),
    "many elements": (HEAD + "<g/>" * 251_000 + "</svg>", "svg-large"),
    "uses of uses": (_nested_uses(12, 10), "svg-large"),
    "huge text": (f"{HEAD}{BOX}<text>{'a' * 30_000}</text></svg>", "svg-large"),
    "curves without end": (
        HEAD + '<path d="M0 0c9e5 0 1e5 0 9.5e5 0"/>' * 4000 + "</svg>",
        "svg-large",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_would_take_too_long_is_refused(tmp_path: Path, name: str) -> None:
    content, code = REFUSED[name]
    path = tmp_path / "hostile.svg"
    path.write_text(content, "utf-8")
    options = ReadOptions(tolerance_mm=0.0005)
    with pytest.raises(JobError) as refusal:
        bounded(lambda: read_drawing(path, options))
    assert refusal.value.code == code


def test_what_entities_add_to_a_file_is_counted_before_it_is_parsed(tmp_path: Path) -> None:
    path = tmp_path / "entities.svg"
    often = 4_000_000 // 200
    path.write_text(GROWN % "".join("&x;" for _ in range(often + 1)), "utf-8")
    with pytest.raises(JobError, match=r"too many characters with its entities in their places.*limit 4000000"):
        bounded(lambda: read_drawing(path, ReadOptions()))
    path.write_text(GROWN % "&x;", "utf-8")
    assert len(read_drawing(path, ReadOptions()).chains) > 200


def bounded(read: Callable[[], object]) -> None:
    """Call it; fail where it takes longer, or more memory, than anything may."""
    tracemalloc.start()
    begun_s = time.process_time()
    try:
        read()
    finally:
        spent_s, (_, peak) = time.process_time() - begun_s, tracemalloc.get_traced_memory()
        tracemalloc.stop()
        assert spent_s < LONGEST_S and peak < MOST_BYTES, (spent_s, peak)


@pytest.mark.parametrize(
    "body",
    [
        '<path d="M0 0L1e999 5 NaN inf"/>',
        '<path d="M1e300 1e300l-1e300 5"/>',
        '<path d="M0 0' + "L5 " * 9 + '"/>',
        '<path d="' + "M0 0z" * 50_000 + '"/>',
        '<path d="M0 0a1e300 1e-300 1e9 0 1 5 5"/>',
        '<circle r="NaN"/><circle r="1e400"/><circle r="-3"/><ellipse rx="1e300" ry="1e-300"/>',
        '<rect width="5" height="4" stroke="red" stroke-dasharray="' + "1e-9 " * 20_000 + '"/>',
        '<rect width="1" height="1" stroke="red" stroke-dasharray="1e-9"/>',
        '<g id="a"><use href="#a"/></g>',
        '<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>',
        '<use href="http://example.org/a.svg#b"/><image href="file:///dev/zero" width="9" height="9"/>',
        '<g transform="matrix(0 0 0 0 0 0)"><circle r="5"/></g>',
        '<g transform="' + "scale(9) " * 90_000 + '"><circle r="5"/></g>',
        '<g transform="scale(1e308) scale(1e308)"><circle r="5"/></g>',
        f"<style>{'a' * 300_000}{{</style>",
        f"<style>{'.a{fill:red}' * 20_000}</style>" + '<g class="a"/>' * 3000,
        f'<g style="{"fill:red;" * 100_000}"/>',
        '<text font-size="1e300">x</text><text x="NaN" font-family="' + "a," * 3000 + '">x</text>',
        '<text><textPath href="#none">x</textPath></text>',
        '<polygon points="' + "1e500,1 " * 9 + '"/>',
        '<rect width="3" height="3" fill="' + "x" * 90_000 + '"/>',
        '<rect id="' + "\u202e" * 9000 + '" width="3" height="3"/>',
        f"<switch>{'<g/>' * 50_000}</switch>",
        f'<path d="M0 0A{"2" * 200}"/>',
        '<path d="M0 0A' + f"5 5 0 1 0 1 2{' ' * 70}" * 20_000 + 'x"/>',
        f'<g transform="{" " * 300_000}scale("/>',
    ],
    ids=range(26),
)
def test_senseless_things_do_not_keep_the_rest_from_being_read(tmp_path: Path, body: str) -> None:
    path = tmp_path / "hostile.svg"
    path.write_text(f"{HEAD}{BOX}{body}</svg>", "utf-8")
    bounded(lambda: read_drawing(path, ReadOptions()))
    read = read_drawing(path, ReadOptions())
    assert any(abs(abs(chain.curve.area_mm2) - 20.0) < 1e-9 for chain in read.chains)
    assert "\u202e" not in "".join(chain.attributes.name for chain in read.chains)


def test_a_packed_file_that_grows_without_end_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "bomb.svgz"
    path.write_bytes(gzip.compress(b" " * 150_000_000, 1))
    with pytest.raises(JobError) as refusal:
        bounded(lambda: read_drawing(path, ReadOptions()))
    assert refusal.value.code == "svg-large"


def test_short_entities_of_plain_text_are_taken_as_illustrator_writes_them(tmp_path: Path) -> None:
    path = tmp_path / "illustrator.svg"
    declared = '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/x.dtd" [<!ENTITY ns "http://www.w3.org/2000/svg">]>'
    path.write_text(f'{declared}<svg xmlns="&ns;" width="9mm" height="9mm" viewBox="0 0 9 9">{BOX}</svg>', "utf-8")
    (chain,) = read_drawing(path, ReadOptions()).chains
    assert abs(chain.curve.area_mm2) == pytest.approx(20.0)
