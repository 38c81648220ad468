# SPDX-License-Identifier: LGPL-2.1-or-later
"""The refusal of a controller with other settings can be translated whole, each difference too."""

from __future__ import annotations

import pytest

from CNCStepper.control.protocol.grbl.readiness import check_offsets, offset_differences
from CNCStepper.control.protocol.grbl.settings import check_settings
from CNCStepper.errors import MachineRefusal, Text

PORTUGUESE = {
    "the controller is set up for another machine: {differences}": "outra máquina: {differences}",
    "${number} is {value:g}, wanted {wanted:g}": "${number} é {value:g}, esperado {wanted:g}",
    "the highest spindle speed, which every S is scaled by": "a rotação máxima",
    "the work zero is not where the program was proven: {differences}": "outro zero: {differences}",
    "{name} is {offset}, wanted {wanted} mm": "{name} é {offset}, esperado {wanted} mm",
}


def translated(refused: MachineRefusal) -> str:
    assert isinstance(refused.what, Text)
    return refused.what.translated(lambda text: PORTUGUESE.get(text, text))


def test_each_setting_is_translated() -> None:
    with pytest.raises(MachineRefusal) as refused:
        check_settings({30: 24000.0, 100: 400.0}, {30: 1000.0, 100: 200.0})
    assert str(refused.value).startswith("the controller is set up for another machine: $30 is 24000, wanted 1000 (")
    assert translated(refused.value) == (
        "outra máquina: $30 é 24000, esperado 1000 (a rotação máxima); $100 é 400, esperado 200"
    )


def test_each_offset_is_translated() -> None:
    found = offset_differences({"G54": (1.0, 0.0, 0.0)}, "G54", {"G54": (0.0, 0.0, 0.0)}, "G54")
    with pytest.raises(MachineRefusal) as refused:
        check_offsets(found)
    assert translated(refused.value) == "outro zero: G54 é 1.000,0.000,0.000, esperado 0.000,0.000,0.000 mm"
