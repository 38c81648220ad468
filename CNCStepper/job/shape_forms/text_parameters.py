# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of a text, named as in a job file; FreeCAD's properties and panel follow from them."""

from typing import Annotated, Literal

from CNCStepper.cycles.parameter import Parameter, Parameters
from CNCStepper.quantities import Bounds, Height

WORDS, SETTING, ALONG = "Text", "Setting", "Along a line or arc"
Align = Literal["left", "center", "right"]
Size = Literal["cap", "em"]
Part = Literal["all", "outlines", "holes"]


class TextParameters(Parameters):
    """The keys of a text that are shown in a window; its place is a matter of the document there."""

    text: Annotated[str, Parameter(WORDS, "Text", "What is written; several lines are set below each other", "Text")]
    font: Annotated[
        str, Parameter(WORDS, "Font", "A font of the system, or a single-line font for engraving", "sans-serif")
    ]
    style: Annotated[str, Parameter(WORDS, "Style", "Of the font, such as Bold; empty: the regular one", "")]
    file: Annotated[str, Parameter(WORDS, "Font file", "A TrueType or OpenType file, instead of the font")] = ""
    height_mm: Annotated[Height, Parameter(WORDS, "Height", "Of the capitals, or of the em", 10.0)]
    size: Annotated[Size, Parameter(SETTING, "Height of", "What the height is measured of")] = "cap"
    align: Annotated[Align, Parameter(WORDS, "Alignment", "Where the text stands about its zero, or on its line")] = (
        "left"
    )
    spacing_mm: Annotated[
        float, Bounds("coordinate", -1000.0, 1000.0), Parameter(SETTING, "Spacing", "Added between letters")
    ] = 0.0
    line_spacing: Annotated[
        float, Bounds("factor", 0.1, 10.0), Parameter(SETTING, "Line spacing", "A factor of the font's own")
    ] = 1.0
    slant_deg: Annotated[
        float, Bounds("angle", -60.0, 60.0), Parameter(SETTING, "Slant", "How far letters lean to the right")
    ] = 0.0
    kerning: Annotated[bool, Parameter(SETTING, "Kerning", "Pairs of letters stand as near as the font says", True)]
    part: Annotated[Part, Parameter(SETTING, "Curves", "All, the outlines of letters, or the holes in them")] = "all"
    tolerance_mm: Annotated[
        float,
        Bounds("tolerance", most=1.0),
        Parameter(SETTING, "Tolerance", "How far lines and arcs may leave the letters"),
    ] = 0.005
