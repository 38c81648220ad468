# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several codes on one line: what `rs274` takes we take, with the same calls, and what it refuses we refuse."""

from __future__ import annotations

import os
import re
from dataclasses import replace

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.state import Start
from helpers.gcode.modal_lines import PAIRED, Case, Difference, differences, pairs, random_cases

CASES = int(os.environ.get("CNCSTEPPER_CASES", "0"))
FEW, MANY = 150, max(3000, 40 * CASES)
GROUP_0 = "Non-modal codes (Group 0): G4, G10 G28, G30, G52, G53, G92, G92.1, G92.2, G92.3"
# Refusals of ours where rs274 2.9 goes on, each with the sentence of its documents or what it does then.
STRICTER = {
    r"modal-conflict: .*G92\.[123]": GROUP_0,  # "two G words from the same modal group may not appear on one line"
    r"axis-conflict: .*G43\.1": "It is an error if: motion is commanded on the same line as G43.1",
    r"compensation: axis offsets": "passes over G92.1 to G92.3 without a word while the radius is compensated",
    r"no-feed: ": "G5, G5.1, G5.2 and probing begin at a feed of 0, and so never end",
    r"feed-mode: no spline": "G93 has no effect on a spline: it is cut at the feed that was in force before",
    r"plane: G5\.2 is not read in G1[789]\.1": "the control points are X and Y, which lie in no plane of U, V and W",
    r"plane: G(74|84) is read in the plane XY only": "taps along other axes than the plane's",
    r"spline-open: ": "takes the control points of the open G5.2 for those of the G5",
    r"not-supported: the tool table cannot": "G10 L0 reads the tool table again, whose lengths may be others then",
    r"machine-move: .*": "G5.2 heeds no G53: the point is one of the work system",
}


def unexplained(found: list[Difference]) -> list[Difference]:
    return [one for one in found if one.theirs or not any(re.match(reason, one.ours) for reason in STRICTER)]


def test_a_few_random_lines_are_read_as_rs274_reads_them(tmp_path):
    cases = list(random_cases(7, FEW))
    found = differences(cases, tmp_path)
    assert not unexplained(found)
    assert len(found) < 0.1 * FEW


@pytest.mark.slow
def test_every_pair_of_codes_is_read_as_rs274_reads_it(tmp_path):
    cases = list(pairs())
    assert len(cases) == 3 * len(PAIRED) * (len(PAIRED) - 1) // 2
    found = differences(cases, tmp_path)
    assert not unexplained(found)
    told = {reason for reason in STRICTER for one in found if re.match(reason, one.ours)}
    assert len(told) >= len(STRICTER) - 2  # of a departure that is none any more nothing is told


@pytest.mark.slow
@pytest.mark.parametrize("batch", range(MANY // 1000))
def test_random_lines_are_read_as_rs274_reads_them(batch, tmp_path):
    assert not unexplained(differences(list(random_cases(100 + batch, 1000)), tmp_path))


def test_the_judge_sees_what_differs(tmp_path):
    cases = [Case(("G0", "G80"), "X1"), Case(("G92", "G92.1"))]
    (stricter,) = differences(cases, tmp_path)
    assert stricter.case.line == "G92 G92.1 X1" and stricter.ours.startswith("modal-conflict")


@pytest.mark.parametrize("line", ["G0 G80 X3", "G80 G0 X3", "X3 G80 G0 G80"])
def test_a_motion_counts_beside_g80(line):
    path = interpret(f"G21 G90 G0 X1\n{line}\nX5\nM2\n", Start.at_zero(), "linuxcnc")
    assert path.table().end[:, 0].tolist() == [1, 3, 5]
    with pytest.raises(ProgramError, match="share a line"):
        interpret(f"G21 G90 G0 X1\n{line}\n", Start.at_zero(), "grbl")


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("G4 P1 G2 X1 I.5", "modal-conflict"),
        ("G80 G43.1 Z1", "axis-unused"),
        ("G43.2 H1 G0 X1", "axis-conflict"),
        ("M3 M8 M48 M64 P1 M0", "m-codes-many"),
        ("G18 G84 X1 Y-2 Z1 R2", "plane"),
        ("G93 G5.1 X1 Y1 I1 J1 F2", "feed-mode"),
    ],
)
def test_what_linuxcnc_cannot_do_on_one_line_is_refused(line, code):
    with pytest.raises(ProgramError) as caught:
        interpret(f"F100 M3 S100 T1 M6\n{line}\nM2\n", Start.at_zero(), "linuxcnc")
    assert caught.value.code == code


def test_a_tap_leaves_the_overrides_off_that_were_off():
    calls = [call for call in canonical_calls("F100 M3 S100 M50 P0\nN7 G84 X1 Z-1 R1\nM2\n") if "N7" in call]
    assert not any("ENABLE_FEED_OVERRIDE" in call for call in calls)
    assert sum("ENABLE_SPEED_OVERRIDE" in call for call in calls) == 1


def test_home_of_one_axis_is_that_of_the_turned_work_system():
    start = replace(Start.at_zero(), parameters={5161: 7.0, 5162: 8.0, 5163: 9.0})
    path = interpret("G10 L2 P1 X4 R90\nG0 X0 Y0 Z0\nG28 X1\nM2\n", start, "linuxcnc")
    assert path.table().end[-1].tolist() == pytest.approx([4.0, 8.0, 0.0])  # along its X, the machine's Y
