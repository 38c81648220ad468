# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of parameters that several cycles have, as pydantic reads them from a job file and writes them into JSON."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BeforeValidator, PlainSerializer

from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.curve import Curve


def _curve(content: Any) -> Curve:
    if isinstance(content, Curve):
        return content
    try:
        return Curve(content["xy"], content["bulge"])
    except (KeyError, TypeError, GeometryError) as error:
        raise ValueError(Text("not a curve with xy and bulge: {error}", error=error)) from error


CurveField = Annotated[
    Curve,
    BeforeValidator(_curve),
    PlainSerializer(lambda curve: {"xy": curve.xy.tolist(), "bulge": curve.bulge.tolist()}),
]
