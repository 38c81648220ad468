# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layer, colour, name and groups of DXF entities, in blocks too."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest

from CNCStepper.drawing.dxf.reader import read_dxf

RED, GREEN, BLUE, BLACK = "#ff0000", "#00ff00", "#0000ff", "#000000"


def colours(document: Any, folder: Path) -> list[str]:
    path = folder / "colours.dxf"
    document.saveas(path)
    return [chain.attributes.colour for chain in read_dxf(path, 0.01).chains]


@pytest.mark.parametrize("ordinary", [True, False])
def test_colours_by_index_layer_and_true_colour(tmp_path: Path, ordinary: bool) -> None:
    document = ezdxf.new("R2010")
    document.layers.add("red", color=1)
    document.layers.add("true", true_color=0x123456)
    document.layers.add("blue", color=5)
    own: list[dict[str, Any]] = [
        {"layer": "red"},
        {"layer": "red", "color": 3},
        {"layer": "red", "color": 3, "true_color": 0xAB00CD},
        {"layer": "true"},
        {"color": 7},
        {"color": 0},
        {"layer": "none"},
        {"layer": "blue"},
    ]
    for number, attributes in enumerate(own):
        bounds = {} if ordinary else {"extrusion": (0, 0, -1)}
        document.modelspace().add_circle((9 * number, 0), 1, attributes | bounds)
    assert colours(document, tmp_path) == [RED, GREEN, "#ab00cd", "#123456", BLACK, BLACK, BLACK, BLUE]


def test_a_block_gives_layer_0_and_colour_by_block_and_its_name(tmp_path: Path) -> None:
    document = ezdxf.new("R2010")
    document.layers.add("plate", color=1)
    inner, outer = document.blocks.new("hole"), document.blocks.new("flange")
    inner.add_circle((0, 0), 1, {"color": 0})
    inner.add_circle((0, 0), 2, {"layer": "plate"})
    outer.add_blockref("hole", (5, 0), {"color": 0})
    outer.add_circle((0, 0), 3)
    document.modelspace().add_blockref("flange", (0, 0), {"layer": "plate", "color": 3})
    document.modelspace().add_circle((0, 0), 50)
    path = tmp_path / "blocks.dxf"
    document.saveas(path)
    found = [chain.attributes for chain in read_dxf(path, 0.01).chains]
    assert [(each.layer, each.colour, each.name, each.groups) for each in found[:3]] == [
        ("plate", GREEN, "hole", ("flange", "hole")),
        ("plate", RED, "hole", ("flange", "hole")),
        ("plate", RED, "flange", ("flange",)),
    ]
    alone = found[3]
    assert alone.groups == () and document.entitydb[alone.name].dxf.radius == 50


def test_names_and_texts_outside_of_the_code_page_are_read_in_their_letters(tmp_path: Path) -> None:
    document = ezdxf.new("R2004", setup=True, units=ezdxf.units.MM)
    space = document.modelspace()
    document.blocks.new("furo 孔").add_circle((0, 0), 1, dxfattribs={"layer": "切断"})
    space.add_circle((0, 0), 5, dxfattribs={"layer": "切断"})
    space.add_blockref("furo 孔", (9, 9))
    document.styles.new("sans", dxfattribs={"font": "DejaVuSans.ttf"})
    space.add_text("Ω", dxfattribs={"layer": "çã", "style": "sans", "height": 2.5})
    space.add_mtext("Ω", dxfattribs={"layer": "çã", "style": "sans", "char_height": 2.5})
    path = tmp_path / "escaped.dxf"
    document.saveas(path)
    assert b"\\U+5207" in path.read_bytes()
    chains = read_dxf(path, 0.01).chains
    found = [chain.attributes for chain in chains]
    assert [each.layer for each in found] == ["切断", "切断", "çã", "çã"] and found[1].name == "furo 孔"
    boxes = [chain.curve.box_mm for chain in chains[2:]]
    assert [np.ptp(np.reshape(box, (2, 2)), axis=0).tolist() for box in boxes] == [
        pytest.approx([2.3, 2.5], abs=0.4)
    ] * 2


@pytest.mark.parametrize("binary", [False, True])
def test_groups_are_kept_of_plain_entities_and_blocks(tmp_path: Path, binary: bool) -> None:
    document = ezdxf.new("R2010")
    space = document.modelspace()
    document.blocks.new("hole").add_circle((0, 0), 1)
    inside = [space.add_circle((0, 0), 5), space.add_blockref("hole", (9, 9))]
    space.add_circle((50, 0), 5)
    document.groups.new("peça").set_data(inside)
    document.groups.new("first").set_data(inside[:1])
    path = tmp_path / "groups.dxf"
    document.saveas(path, fmt="bin" if binary else "asc")
    found = [chain.attributes.groups for chain in read_dxf(path, 0.01).chains]
    assert sorted(found) == [(), ("peça", "first"), ("peça", "hole")]


def test_solids_are_areas_and_external_references_are_named(tmp_path: Path) -> None:
    document = ezdxf.new("R2010", units=ezdxf.units.MM)
    space = document.modelspace()
    space.add_solid([(0, 0), (10, 0), (0, 5), (10, 5)])
    space.add_trace([(20, 0), (24, 0), (20, 3)])
    document.add_xref_def("other.dxf", "other")
    space.add_blockref("other", (0, 0))
    path = tmp_path / "solids.dxf"
    document.saveas(path)
    drawing = read_dxf(path, 0.01)
    assert [abs(chain.curve.area_mm2) for chain in drawing.chains] == pytest.approx([50.0, 6.0])
    assert all(chain.attributes.filled and chain.curve.closed for chain in drawing.chains)
    assert [(each.kind, each.handle, each.why) for each in drawing.skipped] == [
        ("INSERT", "other", "an external reference, whose file is not opened")
    ]


def test_layers_that_differ_by_case_alone_are_one_named_as_the_table_names_it(tmp_path: Path) -> None:
    document = ezdxf.new("R2010", units=ezdxf.units.MM)
    document.layers.add("Corte", color=1)
    space = document.modelspace()
    for number, layer in enumerate(("CORTE", "corte", "other", "Other")):
        space.add_line((0, number), (5, number), {"layer": layer})
        space.add_lwpolyline([(5, number, 0), (9, number, 9)][:2], "xyb", dxfattribs={"layer": layer.swapcase()})
        space.add_ellipse((20, 9 * number), (5, 0), 0.5, dxfattribs={"layer": layer.swapcase()})
    path = tmp_path / "case.dxf"
    document.saveas(path)
    drawing = read_dxf(path, 0.01)
    assert [(layer.name, len(layer.curves)) for layer in drawing.layers] == [("Corte", 4), ("other", 4)]
    assert {(chain.attributes.layer, chain.attributes.colour) for chain in drawing.chains} == {
        ("Corte", RED),
        ("other", BLACK),
    }
