# SPDX-License-Identifier: LGPL-2.1-or-later
"""All icons are there and drawn by one hand: one grid, one outline, one palette."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from CNCStepper.machine.tools.tool_shapes import SHAPES as TOOLS

ROOT = Path(__file__).parents[3]
ICONS = sorted((ROOT / "resources" / "icons").glob("*.svg"))
SVG = "{http://www.w3.org/2000/svg}"
OUTLINE = "#1b3556"
PALETTE = {
    "none", OUTLINE, "#a9cdf0", "#5e97d3", "#3f74b0", "#1f4a78", "#f7b92f", "#f3f6f9", "#36b56c", "#e5484d", "#6b7785",
    "#ffffff",
}  # fmt: skip
SHAPES = {f"{SVG}{name}" for name in ("svg", "title", "path", "rect", "circle", "ellipse")}  # what Qt draws for certain
NAMED = re.compile(r"CNCStepper_[A-Za-z_]+")


def shapes(path: Path) -> list[ET.Element]:
    return [element for element in ET.parse(path).iter() if element.tag not in (f"{SVG}svg", f"{SVG}title")]


@pytest.mark.parametrize("path", ICONS, ids=lambda path: path.stem)
def test_an_icon_is_of_the_one_hand(path: Path) -> None:
    root = ET.parse(path).getroot()
    assert (root.get("width"), root.get("height"), root.get("viewBox")) == ("64", "64", "0 0 64 64")
    assert root.findtext(f"{SVG}title")
    assert {element.tag for element in root.iter()} <= SHAPES
    colours = {element.get(key) for element in shapes(path) for key in ("fill", "stroke")} - {None}
    assert colours <= PALETTE
    assert OUTLINE in colours
    widths = {float(element.get("stroke-width", "4")) for element in shapes(path)}
    assert min(widths) >= 3, "a thinner line is gone at 16 px"


def test_every_command_and_every_object_has_an_icon() -> None:
    there = {path.stem for path in ICONS}
    commands = {
        name
        for path in (ROOT / "CNCStepper" / "workbench" / "commands").glob("*.py")
        for name in re.findall(r'^    name = "(CNCStepper_\w+)"', path.read_text("utf-8"), re.MULTILINE)
    }
    objects = {
        name
        for path in (ROOT / "CNCStepper" / "workbench" / "features").rglob("*.py")
        for name in re.findall(r'^    Type = "(CNCStepper_\w+)"', path.read_text("utf-8"), re.MULTILINE)
    }
    assert len(commands) == 55
    assert len(objects) == 35
    assert commands | objects | {"CNCStepper"} <= there


def test_every_shape_of_tool_has_an_icon_of_its_own() -> None:
    pictures = {shape: (ROOT / f"resources/icons/CNCStepper_Tool_{shape}.svg").read_text("utf-8") for shape in TOOLS}
    drawings = {text.partition("</title>")[2] for text in pictures.values()}
    assert len(drawings) == len(TOOLS)
