# SPDX-License-Identifier: LGPL-2.1-or-later
"""Path edits of lathe programs: arcs with X as a diameter, and what is refused with the reason."""

from __future__ import annotations

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.transform_verbs import mirror, offset, scale

TURNED = "G21 G18 G7 G90 G94\nG0 X40 Z0\nG1 X40 Z-10 F100\nG2 X48 Z-14 I4 K0\nM2\n"
FANUC = "G21 G18\nT0101\nG97 S800 M3\nG99\nG0 X54. Z2.\n"


def test_a_centre_is_scaled_as_exactly_as_its_ends_where_x_is_a_diameter():
    lines = scale(TURNED, 1.0005, dialect="linuxcnc").text.splitlines()
    assert lines[3].split()[3:] == ["I4.002", "K0"] or lines[3].endswith("I4.002 K0.000")


@pytest.mark.parametrize(
    ("text", "dialect", "edit", "code", "advice"),
    [
        (TURNED, "linuxcnc", lambda *words: mirror(words[0], "X", dialect=words[1]), "edit-mirror", "offset"),
        (
            FANUC + "G71 U2. R0.5\nG71 P1 Q2 U0. W0. F0.2\nN1 G0 X20.\nN2 G1 Z-9.\nM30\n",
            "fanuc-lathe",
            lambda *words: offset(words[0], z_mm=1.0, dialect=words[1]),
            "edit-flow",
            "canned = false",
        ),
        (
            "G21 G18 G90\nG0 X20 Z3\nS500 M3\nG76 P2 Z-20 I-1 J0.3 K1.2\nM2\n",
            "linuxcnc",
            lambda *words: scale(words[0], 2.0, dialect=words[1]),
            "edit-code",
            "canned = false",
        ),
    ],
)
def test_what_a_path_edit_cannot_do_is_named_with_what_would_do(text, dialect, edit, code, advice):
    with pytest.raises(ProgramError) as refusal:
        edit(text, dialect)
    assert refusal.value.code == code and advice in refusal.value.advice
