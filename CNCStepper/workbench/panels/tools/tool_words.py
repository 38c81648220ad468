# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a tool is named: in lists, and in the tree by what it is until a person names it.

"T2  6 mm  V-bit – Signs" in lists; "T2 V-bit 6 mm 60°" in the tree. Of a lathe's tools "T1 CNMG 120408" and
"T3 parting 3 mm" in both.
"""

from __future__ import annotations

import re
from typing import Any

from CNCStepper.machine.tools.tool_shapes import POINTED, SHAPES
from CNCStepper.workbench.features.base import entry_of, proxy_type, value_of
from CNCStepper.workbench.features.turning.turning_tool import (
    BORING,
    DRILL,
    PARTING,
    THREADING,
    TURNING,
    TurningTool,
)
from CNCStepper.workbench.panels.unit_values import text_of
from CNCStepper.workbench.services.choice_labels import WORDS, words_of
from CNCStepper.workbench.services.translation import later, tr

SIZES = {
    PARTING: "width_mm",
    DRILL: "diameter_mm",
    THREADING: "tip_angle_deg",
}  # by which a tool without insert is known
KINDS = {
    TURNING: later("turning"),
    BORING: later("boring"),
    PARTING: later("parting"),
    DRILL: later("drill"),
    THREADING: later("threading"),
}
INSERT_CODE = r"(?=[^°]*\d)[A-Z\d./-]+( [A-Z\d./-]+)*"


def tool_words(tool: Any) -> str:
    """Return how a tool is listed: its number, form and diameter, and its own name where it was given one.

    A lathe's is listed as it stands in the tree.
    """
    if proxy_type(tool) == TurningTool.Type:
        return _turning_tree_words(tool)
    own = f" – {tool.Label}" if has_own_name(tool) else ""
    return f"T{tool.Number}  {_text(tool, 'diameter_mm')}  {words_of(tool.ToolShape)}{own}"


def tree_words(tool: Any) -> str:
    """Return what a tool is called in the tree: number, form, diameter, and the angle of a pointed one."""
    if proxy_type(tool) == TurningTool.Type:
        return _turning_tree_words(tool)
    is_pointed = tool.ToolShape in POINTED and tool.TipAngle
    angle = f" {_short(_text(tool, 'tip_angle_deg')).replace(' ', '')}" if is_pointed else ""
    return f"T{tool.Number} {words_of(tool.ToolShape)} {_short(_text(tool, 'diameter_mm'))}{angle}"


def _turning_tree_words(tool: Any) -> str:
    """Return what a lathe's tool is called in the tree: number, kind unless the insert says it, insert or size."""
    insert = tool.Insert.strip().upper() if tool.Kind not in (PARTING, DRILL) else ""
    kind = "" if insert and tool.Kind != BORING else tr(KINDS[tool.Kind])
    key = "" if insert else SIZES.get(tool.Kind, "nose_radius_mm")
    size = _short(_text(tool, key)).replace(" °", "°") if key and value_of(tool, entry_of(tool.Proxy, key)) else ""
    return " ".join(filter(None, (f"T{tool.Number}", kind, insert, size)))


def has_own_name(tool: Any) -> bool:
    """Return whether a person has named a tool; FreeCAD adds digits to a name that is taken."""
    if proxy_type(tool) == TurningTool.Type:
        kinds = "|".join(re.escape(words) for each in KINDS.values() for words in {each, tr(each)})
        form = rf"({kinds})( {INSERT_CODE})?( \S+ \w+| [\d.,]+°)?|{INSERT_CODE}"
    else:
        forms = "|".join(re.escape(words) for shape in SHAPES for words in {WORDS[shape], words_of(shape)})
        form = rf"({forms}) \S+ \w+( [\d.,]+°)?"
    given = rf"(Tool|{re.escape(tr('Tool'))})\d*|T\d+ ({form})\d*"
    return re.fullmatch(given, tool.Label) is None


def _short(text: str) -> str:
    """Return a quantity without zeros at the end of its number."""
    number, _, unit = text.partition(" ")
    return f"{number.rstrip('0').rstrip('.,') if set('.,') & set(number) else number} {unit}"


def _text(tool: Any, key: str) -> str:
    entry = entry_of(tool.Proxy, key)
    return text_of(float(value_of(tool, entry)), entry)
