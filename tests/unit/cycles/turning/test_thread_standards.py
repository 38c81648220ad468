# SPDX-License-Identifier: LGPL-2.1-or-later
"""Standard threads by their designations, against printed tables of diameters and fits."""

from __future__ import annotations

import pytest

from CNCStepper.cycles.turning.thread_standards import thread_named, thread_table
from CNCStepper.errors import JobError

INCH = 25.4
# designation: major, pitch diameter, root outside, crest inside, mm, as printed tables have them
PRINTED = {
    "M20x2.5": (20.0, 18.376, 16.933, 17.294),
    "M10": (10.0, 9.026, 8.160, 8.376),
    "M12x1.5": (12.0, 11.026, 10.160, 10.376),
    "1/2-13 UNC": (0.5 * INCH, 0.4500 * INCH, 0.4056 * INCH, 0.4167 * INCH),
    "#10-24 UNC": (0.190 * INCH, 0.1629 * INCH, 0.1389 * INCH, 0.1449 * INCH),
    "1/4-28 UNF": (0.25 * INCH, 0.2268 * INCH, 0.2062 * INCH, 0.2113 * INCH),
    "1/2-12 BSW": (12.7, 11.345, 9.989, 9.989),
    "G1/2": (20.955, 19.793, 18.631, 18.631),
    "Tr20x4": (20.0, 18.0, 15.5, 16.0),
    "Tr40x7": (40.0, 36.5, 32.0, 33.0),
}
# limits of the crest and of the pitch diameter, as printed
PRINTED_FITS = {
    ("M20x2.5", "outside"): ((19.623, 19.958), (18.164, 18.334)),
    ("M20x2.5", "inside"): ((17.294, 17.744), (18.376, 18.600)),
    ("M10", "outside"): ((9.732, 9.968), (8.862, 8.994)),
    ("M10", "inside"): ((8.376, 8.676), (9.026, 9.206)),
    ("1/2-13 UNC", "outside"): ((0.4876 * INCH, 0.4985 * INCH), (0.4435 * INCH, 0.4485 * INCH)),
    ("1/2-13 UNC", "inside"): ((0.417 * INCH, 0.434 * INCH), (0.4500 * INCH, 0.4565 * INCH)),
    ("Tr20x4", "outside"): ((19.700, 20.000), (17.640, 17.905)),
    ("Tr20x4", "inside"): ((16.000, 16.375), (18.000, 18.355)),
}


@pytest.mark.parametrize("designation", PRINTED)
def test_diameters_are_those_of_printed_tables(designation):
    form = thread_named(designation)
    found = (form.major_mm, form.pitch_line_mm, form.root_mm("outside"), form.crest_mm("inside"))
    assert found == pytest.approx(PRINTED[designation], abs=0.004)


@pytest.mark.parametrize(("designation", "side"), PRINTED_FITS)
def test_fits_are_those_of_printed_tables(designation, side):
    fit = thread_named(designation).fit(side)
    crest, line = PRINTED_FITS[designation, side]
    assert fit.crest_mm == pytest.approx(crest, abs=0.011)
    assert fit.pitch_line_mm == pytest.approx(line, abs=0.015)  # tables round the tolerances


@pytest.mark.parametrize("side", ["outside", "inside"])
def test_the_floor_brings_the_pitch_diameter_to_the_middle_of_its_fit(side):
    form = thread_named("M20x2.5")
    low, high = form.fit(side).pitch_line_mm
    assert form.floor_mm(side) - form.root_mm(side) == pytest.approx((low + high) / 2 - form.pitch_line_mm)


def test_an_inner_trapezoidal_thread_ends_above_the_major_diameter():
    assert thread_named("Tr20x4").root_mm("inside") == pytest.approx(20.5)


def test_starts_and_hand():
    form = thread_named("Tr40x14P7-LH")
    assert (form.pitch_mm, form.lead_mm, form.starts, form.left) == (7.0, 14.0, 2, True)
    assert thread_named("M20").pitch_mm == 2.5 and thread_named(" M20x2 ").pitch_mm == 2.0


def test_every_thread_of_the_table_can_be_named_and_made():
    table = thread_table()
    names = [f"M{row[0]:g}" for row in table["metric"]["coarse"]]
    names += [f"{row[0]}-{row[1]:g} {key.upper()}" for key in ("unc", "unf") for row in table["unified"][key]]
    names += [f"{row[0]}-{row[1]:g} BSW" for row in table["whitworth"]["bsw"]]
    names += [f"G{row[0]}" for row in table["whitworth"]["g"]]
    names += [f"Tr{row[0]:g}x{pitch:g}" for row in table["trapezoidal"]["pitches"] for pitch in row[1:]]
    for name in names:
        form = thread_named(name)
        assert 0 < form.root_mm("outside") < form.pitch_line_mm < form.major_mm, name
        low, high = form.fit("outside").pitch_line_mm
        assert low <= high <= form.pitch_line_mm, name


@pytest.mark.parametrize(
    ("designation", "words"),
    [
        ("X20", "no designation"),
        ("M20x2.6", "not in the table"),
        ("M7.3", "not in the table"),
        ("M3x2", "1 mm"),
        ("1/2-14 UNC", "1/2-13"),
        ("Tr20x5", "Tr20x2, Tr20x4"),
        ("Tr40x10P7", "Tr40x7P7"),
        ("G9", "G1/8"),
    ],
)
def test_what_is_not_there_is_refused_with_what_is(designation, words):
    with pytest.raises(JobError) as refusal:
        thread_named(designation)
    assert words in str(refusal.value)
