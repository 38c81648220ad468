# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper feeds --turn`: the published example, preset speeds, and options that do not go together."""

from __future__ import annotations

import pytest

from helpers.cli.command_line import called

EXAMPLE = ("feeds", "--material", "pvc", "--turn", "100", "--depth", "3", "--feed", "3")


def test_the_published_example():
    said = called(*EXAMPLE, "--power", "386").stdout
    for figure in ("95.6 N/mm²", "860.4 N", "0.449 m/s", "85.7 rpm", "386 W", "43.0 Nm"):
        assert figure in said, said
    assert "warning" not in said


def test_the_nearest_preset_of_the_mini_lathe_needs_more_than_the_motor_has():
    said = called(*EXAMPLE, "--power", "386", "--machine", "mini-lathe").stdout
    assert "90.0 rpm, the nearest preset to 85.7" in said
    assert "warning: the cut needs more power than the motor has (value 405 W, limit 386 W)" in said


def test_the_speed_of_the_material_where_nothing_bounds_it():
    said = called(*EXAMPLE, "--hss", "--stickout", "300", "--tailstock", "--grip", "9000").stdout
    assert "v_c        146.97 m/min" in said  # the middle of 90 to 240
    assert "bar        L/D 3, bends by" in said


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--turn", "50", "--depth", "1"], "--turn needs --depth and --feed"),
        (["--turn", "50", "--tool", "flat:6"], "--tool for a mill, or --turn for a lathe"),
        ([], "--tool for a mill, or --turn for a lathe"),
        (["--tool", "flat:6", "--stickout", "30"], "belong to --turn"),
    ],
)
def test_options_that_do_not_go_together_are_refused(arguments, words):
    result = called("feeds", "--material", "pvc", *arguments)
    assert result.returncode == 2 and words in result.stderr
