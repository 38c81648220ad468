# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values in the user's units: shown as FreeCAD's preferences say, read as FreeCAD reads quantities and expressions.

    schema (preferences)                 lengths   feeds
    metric                               mm        mm/min (FreeCAD's own mm/s is nobody's word for a feed)
    building Euro                        cm        mm/min
    US customary, imperial, building US  in        in/min

A number typed without a unit has the unit that is shown.
"""

from __future__ import annotations

import locale
import math
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from CNCStepper.units import MM_PER_INCH, S_PER_MIN
from CNCStepper.workbench.features.base import ANGLE, DISTANCE, INTEGER, POINTS, POSITION, SPEED, Property
from CNCStepper.workbench.panels.number_input import LARGEST, Refused, shortened, shown, tidied
from CNCStepper.workbench.services.translation import later

IMPERIAL, CENTIMETRES = (2, 3, 5, 7), (4,)  # numbers of FreeCAD's schemas
MM_PER_CM = 10.0
PLAIN_UNITS = {  # FreeCAD converts none of them
    "_mm_rev": "mm/rev",
    "_m_min": "m/min",
    "_rpm": "rpm",
    "_s": "s",
    "_percent": "%",
    "amperes": "A",
}


@dataclass(frozen=True)
class Measure:
    """The quantity of a field.

    unit: as it is shown. factor: from it to the unit of the property's key. quantity: the name of FreeCAD's unit, ""
    for plain numbers. per_freecad: from FreeCAD's own unit to the key's.
    """

    unit: str
    factor: float = 1.0
    quantity: str = ""
    per_freecad: float = 1.0


def measure_of(entry: Property) -> Measure:
    """Return how values of a property are shown to this user."""
    imperial, centimetres = schema() in IMPERIAL, schema() in CENTIMETRES
    if entry.type in (DISTANCE, POSITION, POINTS):
        unit, factor = ("in", MM_PER_INCH) if imperial else ("cm", MM_PER_CM) if centimetres else ("mm", 1.0)
        return Measure(unit, factor, "Length")
    if entry.type == SPEED:
        unit, factor = ("in/min", MM_PER_INCH) if imperial else ("mm/min", 1.0)
        return Measure(unit, factor, "Velocity", S_PER_MIN)
    if entry.type == ANGLE:
        return Measure("°", 1.0, "Angle")
    return Measure(next((unit for end, unit in PLAIN_UNITS.items() if entry.key.endswith(end)), ""))


def schema() -> int:
    """Return the number of the user's unit schema."""
    import FreeCAD

    return int(FreeCAD.Units.getSchema())


def text_of(value: float, entry: Property, with_unit: bool = True) -> str:
    """Return a value, in the unit of its key, as this user reads it."""
    import FreeCAD
    from PySide import QtCore

    if entry.type == INTEGER:
        return str(value)
    measure = measure_of(entry)
    preferences = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units")
    point = str(QtCore.QLocale().decimalPoint())
    number = shown(value / measure.factor, 0 if measure.unit == "rpm" else preferences.GetInt("Decimals", 2), point)
    return f"{number} {measure.unit}".rstrip() if with_unit else number


def value_of_text(text: str, entry: Property, obj: Any) -> float:
    """Return what a person typed, in the unit of the property's key; raises Refused.

    Sums with units and names of other values of `obj` are read by FreeCAD's expressions.
    """
    measure = measure_of(entry)
    tidy = tidied(text)
    if measure.unit in PLAIN_UNITS.values():
        tidy = re.sub(rf"\s*{measure.unit}$", "", tidy, flags=re.IGNORECASE)
    value = _converted(_quantity(tidy, text, obj), measure, text)
    if not math.isfinite(value) or abs(value) > LARGEST:
        raise Refused(later("'{0}' is too large"), shortened(text))
    return value


def whole_of_text(text: str, entry: Property, obj: Any) -> int:
    """Return a whole number that a person typed; raises Refused."""
    value = value_of_text(text, entry, obj)
    if value != round(value):
        raise Refused(later("'{0}' is no whole number"), shortened(text))
    return round(value)


def _quantity(tidy: str, text: str, obj: Any) -> Any:
    """Return FreeCAD's quantity; its expressions know sums with units, its quantities know 1/4\" and 3' 4\"."""
    import FreeCAD

    reasons = []
    for read in (FreeCAD.Units.Quantity, obj.evalExpression):
        try:
            with _decimal_points():
                return FreeCAD.Units.Quantity(read(tidy))
        except Exception as reason:  # FreeCAD raises many kinds here, of which several are no more than Exception
            reasons.append(reason)
    raise Refused(later("'{0}' is no number"), shortened(text)) from reasons[-1]


@contextmanager
def _decimal_points() -> Iterator[None]:
    """Let the C library read numbers with a point: FreeCAD reads by it, and with its comma 12.5 would become 12."""
    before = locale.setlocale(locale.LC_NUMERIC)
    locale.setlocale(locale.LC_NUMERIC, "C")
    try:
        yield
    finally:
        locale.setlocale(locale.LC_NUMERIC, before)


def _converted(quantity: Any, measure: Measure, text: str) -> float:
    import FreeCAD

    if quantity.Unit == FreeCAD.Units.Unit():
        return float(quantity.Value) * measure.factor
    if not measure.quantity:
        raise Refused(later("This needs a number without a unit, not '{0}'"), shortened(text))
    if quantity.Unit != getattr(FreeCAD.Units, measure.quantity):
        raise Refused(later("'{0}' is no value in {1}"), shortened(text), measure.unit)
    return float(quantity.Value) * measure.per_freecad
