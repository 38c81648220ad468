# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values as a person types and reads them, by FreeCAD's own quantities and expressions, in the user's units."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import FreeCAD
import pytest
from PySide import QtCore

from CNCStepper.workbench import api
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.panels.unit_values import text_of, value_of_text, whole_of_text

METRIC, US, DECIMAL_INCH, CENTIMETRE = 0, 2, 3, 4


@pytest.fixture
def form(document: Any) -> Iterator[Any]:
    """A function that finds a property of a pocket or a tool, and its object, by key."""
    job = api.new_job(document)
    tool = api.add_tool(job)
    objects = (api.add_elliptical_pocket(job), tool)
    before = FreeCAD.Units.getSchema()

    def find(key: str) -> tuple[Any, Any]:
        return next((entry, obj) for obj in objects for entry in obj.Proxy.PROPERTIES if entry.key == key)

    FreeCAD.Units.setSchema(METRIC)
    yield find
    FreeCAD.Units.setSchema(before)


@pytest.mark.parametrize(
    ("schema", "key", "typed", "value"),
    [
        (METRIC, "depth_mm", "12,5", 12.5),
        (METRIC, "depth_mm", "12.5 mm", 12.5),
        (METRIC, "depth_mm", "10 mm + 2,5 mm", 12.5),
        (METRIC, "depth_mm", "1 in", 25.4),
        (METRIC, "depth_mm", '1/4"', 6.35),
        (METRIC, "depth_mm", "1 1/2 in", 38.1),
        (METRIC, "depth_mm", "3' 4\"", 1016.0),
        (METRIC, "depth_mm", "2 * (3 + 4)", 14.0),
        (METRIC, "depth_mm", "RadiusX / 4", 10.0),
        (METRIC, "depth_mm", "12 µm", 0.012),
        (METRIC, "rotation_deg", "45", 45.0),
        (METRIC, "rotation_deg", "45° + 1°", 46.0),
        (METRIC, "feed_mm_min", "800", 800.0),
        (METRIC, "feed_mm_min", "1,2 m/min", 1200.0),
        (METRIC, "feed_mm_min", "10 mm/s", 600.0),
        (METRIC, "spindle_rpm", "10000 rpm", 10000.0),
        (METRIC, "spindle_rpm", "12000", 12000.0),
        (DECIMAL_INCH, "depth_mm", "0,25", 6.35),
        (DECIMAL_INCH, "depth_mm", "5 mm", 5.0),
        (US, "depth_mm", "1/4", 6.35),
        (US, "feed_mm_min", "20", 508.0),
        (CENTIMETRE, "depth_mm", "1,5", 15.0),
    ],
)
def test_what_is_typed_is_read(form: Any, schema: int, key: str, typed: str, value: float) -> None:
    FreeCAD.Units.setSchema(schema)
    assert value_of_text(typed, *form(key)) == pytest.approx(value)


@pytest.mark.parametrize(
    ("key", "typed", "word"),
    [
        ("depth_mm", "5 kg", "no value in mm"),
        ("depth_mm", "5 mm/min", "no value in mm"),
        ("depth_mm", "45°", "no value in mm"),
        ("depth_mm", "10 mm + 2", "no number"),
        ("depth_mm", "12 mm mm", "no number"),
        ("depth_mm", "1e", "no number"),
        ("depth_mm", "nonesuch.x1", "no number"),
        ("depth_mm", "1e400", "too large"),
        ("depth_mm", "1/0", "too large"),
        ("depth_mm", "2 km", "too large"),
        ("feed_mm_min", "800 mm", "no value in mm/min"),
        ("spindle_rpm", "10 mm", "without a unit"),
    ],
)
def test_what_cannot_be_read_is_refused_without_a_word_in_the_report_view(
    form: Any, key: str, typed: str, word: str, capfd: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(Refused, match=word):
        value_of_text(typed, *form(key))
    assert "".join(capfd.readouterr()).strip() == ""


def test_a_whole_number_is_whole(form: Any) -> None:
    assert whole_of_text("7", *form("number")) == 7
    with pytest.raises(Refused, match="whole"):
        whole_of_text("7,5", *form("number"))


@pytest.mark.parametrize(
    ("schema", "key", "value", "text"),
    [
        (METRIC, "depth_mm", 10.0, "10.00 mm"),
        (METRIC, "tolerance_mm", 0.005, "0.005 mm"),
        (METRIC, "feed_mm_min", 800.0, "800.00 mm/min"),
        (METRIC, "rotation_deg", 30.0, "30.00 °"),
        (METRIC, "spindle_rpm", 10000.0, "10000 rpm"),
        (DECIMAL_INCH, "depth_mm", 6.35, "0.25 in"),
        (DECIMAL_INCH, "depth_mm", 40.0, "1.575 in"),
        (US, "feed_mm_min", 508.0, "20.00 in/min"),
        (CENTIMETRE, "depth_mm", 15.0, "1.50 cm"),
    ],
)
def test_a_value_is_shown_in_the_user_s_units_and_read_again(
    form: Any, schema: int, key: str, value: float, text: str
) -> None:
    FreeCAD.Units.setSchema(schema)
    entry, obj = form(key)
    shown = text_of(value, entry)
    assert shown == text.replace(".", str(QtCore.QLocale().decimalPoint()))
    assert value_of_text(shown, entry, obj) == pytest.approx(value, rel=5e-4)
