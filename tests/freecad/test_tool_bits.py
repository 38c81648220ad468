# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool bits that we write are those of FreeCAD's own CAM workbench, in each of its versions."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from CNCStepper.machine.tools.stored_tool import StoredTool
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_files import read_tools, write_tools

TOOLS = [
    (Tool(number=1, shape="flat", diameter_mm=6, flute_length_mm=22, feed_mm_min=800), {"Diameter": 6.0}),
    (Tool(number=2, shape="bullnose", diameter_mm=8, corner_radius_mm=1), {"Diameter": 8.0}),
    (Tool(number=3, shape="v", diameter_mm=10, tip_angle_deg=60, tip_diameter_mm=1), {"CuttingEdgeAngle": 60.0}),
    (Tool(number=4, shape="drill", diameter_mm=3.3, point_angle_deg=118), {"Diameter": 3.3, "TipAngle": 118.0}),
    (Tool(number=5, shape="ball", diameter_mm=2), {"Diameter": 2.0}),
]


def loaded(path: Path) -> Any:
    """Return the document object that FreeCAD itself makes of a tool bit."""
    try:
        from Path.Tool.toolbit import ToolBit  # 1.1
    except ImportError:
        try:
            from Path.Tool.Bit import Factory  # 1.0
        except ImportError:
            from PathScripts.PathToolBit import Factory  # 0.20
        return Factory.CreateFrom(str(path), "Bit")
    import json

    bit = ToolBit.from_dict(json.loads(path.read_text("utf-8")))
    return bit.obj


@pytest.mark.parametrize(("tool", "values"), TOOLS, ids=lambda value: getattr(value, "shape", ""))
def test_freecad_loads_the_bits_that_we_write(
    document: Any, tmp_path: Path, tool: Tool, values: dict[str, float]
) -> None:
    path = tmp_path / "broca 1.fctb"
    write_tools([StoredTool(tool.number, tool.words, tool)], path)
    bit = loaded(path)
    for name, value in values.items():
        assert float(getattr(bit, name).Value) == pytest.approx(value)
    assert read_tools(path)[0].tool == tool.model_copy(update={"number": 1})
