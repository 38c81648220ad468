# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fanuc's G70 to G73 and G76 in two blocks, and U and W, as the reader executes them."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CW, LINE, RAPID

LANGUAGE = "fanuc-lathe"
HEAD = "G21 G18\nG40 G97 G98\nT0101\nS800 M3\nG99\nG0 X54. Z2.\n"
SHAPE = """N10 G0 X20.
G1 Z-20. F0.1
G2 X30. Z-25. R5.
G1 X40. Z-40.
N20 X54.
"""
ROUGH = "G71 U3. R0.5\nG71 P10 Q20 U0.8 W0.2 F0.3\n"


def rows(body: str):
    """Return kind, X as a diameter, Z, feed and line of the rows of a program, behind its first move."""
    table = interpret(HEAD + body + "M30\n", Start(), LANGUAGE).table()
    ends = (table.end[:, [0, 2]] * (2.0, 1.0)).round(6).tolist()
    return list(zip(table.kind.tolist(), ends, table.feed.tolist(), table.line.tolist(), strict=True))[1:]


def cuts(found):
    return [end for kind, end, _, _ in found if kind != RAPID]


def test_g71_roughs_level_by_level_and_leaves_u_and_w():
    found = rows(ROUGH + SHAPE)
    level = [(one[1], before[1]) for before, one in pairwise(found) if one[0] == LINE]
    ends = [end for end, begin in level if end[0] == begin[0]]
    assert [x for x, _ in ends[:4]] == pytest.approx([48.8, 42.8, 36.8, 30.8])  # from X54.8, 6 a pass
    assert ends[0][1] == pytest.approx(-39.8) and ends[3][1] > ends[2][1]
    assert [20.8, -19.8] in cuts(found) and min(x for x, _ in cuts(found)) == pytest.approx(20.8)
    assert {feed for kind, _, feed, _ in found if kind != RAPID} == {0.3 * 800}
    assert found[-1][:2] == (RAPID, [54.0, 2.0])


def test_g70_runs_the_blocks_with_their_own_feed_and_goes_back():
    found = rows(ROUGH + SHAPE + "G70 P10 Q20\n")
    finish = found[-6:]
    assert [kind for kind, *_ in finish] == [RAPID, LINE, ARC_CW, LINE, LINE, RAPID]
    assert [end for _, end, _, _ in finish] == [[20, 2], [20, -20], [30, -25], [40, -40], [54, -40], [54, 2]]
    assert finish[1][2] == pytest.approx(0.1 * 800) and [line for *_, line in finish[:5]] == [9, 10, 11, 12, 13]


def test_g72_faces_from_the_chuck_to_the_end():
    found = rows("G72 W4. R0.5\nG72 P1 Q2 U0. W0. F0.2\nN1 G0 Z-40.\nG1 X40.\nX30. Z-10.\nN2 Z2.\n")
    places = sorted({round(z, 3) for (kind, (_, z), _, _) in found if kind == LINE})
    assert {-2.0, -6.0, -10.0} <= {*places}
    assert min(x for x, _ in cuts(found)) == pytest.approx(30.0) and found[-1][1] == [54.0, 2.0]


def test_g73_repeats_the_profile_from_afar():
    found = rows("G73 U6. W1. R3\nG73 P10 Q20 U0.4 W0. F0.2\n" + SHAPE)
    bottoms = [end for kind, end, _, _ in found if kind == ARC_CW]
    assert bottoms == [[42.4, -24.0], [36.4, -24.5], [30.4, -25.0]]
    assert found[-1][1] == [54.0, 2.0]


def test_g76_cuts_the_square_root_of_the_pass_and_finishes_as_often_as_asked():
    found = rows("G0 X32. Z5.\nG76 P021060 Q20 R0.05\nG76 X26.32 Z-30. R0. P1840 Q400 F3.\n")[1:]
    ends = cuts(found)[::2]
    depth = [(26.32 + 2 * 1.84 - x) / 2 for x, _ in ends]
    rough = [min(0.4 * math.sqrt(number), 1.79) for number in range(1, 22)]
    assert depth[:-2] == pytest.approx(rough[: len(depth) - 2]) and depth[-3:] == pytest.approx([1.79, 1.84, 1.84])
    assert ends[0][1] == pytest.approx(-27.0) and found[-1][1] == [32.0, 5.0]
    begins = [one[1][1] for one, after in pairwise(found) if one[0] == RAPID and after[0] == LINE]
    assert begins[-1] == pytest.approx(5.0 - 1.84 * math.tan(math.radians(30.0)), abs=1e-6)
    assert {round(feed) for kind, _, feed, _ in found if kind == LINE} >= {2400}


def test_the_least_cut_of_g76_holds():
    found = rows("G0 X32. Z5.\nG76 P010000 Q300 R0.\nG76 X28. Z-10. P2000 Q500 F2.\n")[1:]
    depth = np.array([(32.0 - x) / 2 for x, _ in cuts(found)])
    assert np.diff(depth)[:-2].min() >= 0.3 - 1e-9 and depth[-1] == depth[-2] == 2.0
    assert {z for (kind, (_, z), _, _) in found if kind == LINE} == {-10.0}


def test_u_and_w_are_from_where_the_tool_is():
    found = rows("G1 U-4. W-1. F0.2\nU1. Z-8.\nG2 U10. W-5. R5.\n")
    assert [end for _, end, _, _ in found] == [[50, 1], [51, -8], [61, -13]]


@pytest.mark.parametrize(
    ("body", "code", "words"),
    [
        ("G71 P10 Q20 U0. W0. F0.2\n" + SHAPE, "missing-word", "needs its first block"),
        ("G71 U2. R0.5\nG71 P10 Q99 U0. W0. F0.2\n" + SHAPE, "no-block", "no block N99"),
        ("G71 U0. R0.5\nG71 P10 Q20 U0. W0. F0.2\n" + SHAPE, "bad-value", "must be above 0"),
        ("G1 X50. U1. F0.2\n", "axis-conflict", "U and X are the same axis"),
        ("G76 P021060 Q100 R0.05\nG76 X26. Z-30. P1.8 Q400 F3.\n", "bad-value", "has no point"),
        ("G76 P60 Q100 R0.05\nG76 X26. Z-30. P1800 Q400 F3.\n", "bad-value", "six digits"),
        ("G76 P020060 Q100 R0.05\nG76 X26. Z-30. P1800 Q2000 F3.\n", "bad-value", "first cut"),
        ("G71 X3. U2. R0.5\n", "unused-word", "takes no X"),
    ],
)
def test_what_cannot_be_cut_is_refused_with_the_reason(body, code, words):
    with pytest.raises(ProgramError) as refusal:
        rows(body)
    assert refusal.value.code == code and words in str(refusal.value) and refusal.value.place


def test_a_profile_needs_the_whole_program():
    reader = Interpreter(Start(), LANGUAGE)
    for line in (HEAD + ROUGH).splitlines()[:-1]:
        reader.line(line)
    with pytest.raises(ProgramError, match="whole program"):
        reader.line(ROUGH.splitlines()[-1])
