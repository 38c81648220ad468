# SPDX-License-Identifier: LGPL-2.1-or-later
"""Threads: depths, infeed, taper, starts; as G33 and as G76, judged by rs274; on the mini-lathe by its twin."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import atan, hypot, radians, tan

import numpy as np
import pytest

from CNCStepper.cycles.turning.thread import ThreadCut, add_thread, check_cylinder, check_thread, timer_warnings
from CNCStepper.cycles.turning.thread_standards import thread_named
from CNCStepper.errors import CycleError, ProgramError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.write import WriteOptions, write
from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.profile import load_machine
from CNCStepper.state import Start, State
from CNCStepper.toolpath import LINE, TableBuilder, Toolpath
from CNCStepper.virtual.lathe.machine import Lathe
from helpers.control.twin_bench import send
from helpers.gcode.rs274_runs import NUMBER, rs274_calls, same_call

RPM = 90.0
MOVES = ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "START_SPEED_FEED_SYNC")


def cut_of(designation: str = "M20x2.5", side: str = "outside", **more: object) -> ThreadCut:
    form = thread_named(designation)
    options = {
        "crest_radius_mm": form.crest_mm(side) / 2,
        "floor_radius_mm": form.floor_mm(side) / 2,
        "z_start_mm": 0.0,
        "z_end_mm": -30.0,
        "rpm": RPM,
        "approach_mm": 5.0,
        "clearance_mm": 1.0,
        "first_depth_mm": 0.4,
        **more,
    }
    return ThreadCut(form=form, side=side, **options)


class Rows:
    """The rows as they are, in a table."""

    def __init__(self, table: TableBuilder):
        self.table = table

    def rapid_tip(self, z_mm, r_mm):
        self.table.rapid((r_mm, 0.0, z_mm))

    def thread_tip(self, z_mm, r_mm, lead_mm, rpm):
        x, _, z = self.table.position_mm[:3]
        share = hypot(r_mm - x, z_mm - z) / abs(z_mm - z)
        self.table.event("synchronised", lead_mm * share, "G33")
        self.table.feed((r_mm, 0.0, z_mm), lead_mm * share * rpm)

    def open_cycle(self, name, words):
        self.table.open_span("turning_cycle", name, **words)

    def close_cycle(self):
        self.table.close_span()


def table_of(cut: ThreadCut) -> Toolpath:
    state = State(spindle="cw", spindle_rpm=cut.rpm, tool=1, plane="ZX")
    table = TableBuilder(Start(position_mm=(40.0, 0.0, 50.0)), state)
    add_thread(cut, Rows(table))
    return table.toolpath()


def text_of(cut: ThreadCut, dialect: str = "linuxcnc", whole: bool = False) -> str:
    leave_out = ("spindle", "tool") if dialect.startswith("mini-lathe") else ()
    return write(table_of(cut), dialect, WriteOptions(retract=False, turning_cycles=whole, leave_out=leave_out))


def moves_of(calls: list[str]) -> list[tuple[str, list[float]]]:
    """Return the moves and what they follow, without those that lead nowhere."""
    found: list[tuple[str, list[float]]] = []
    for call in calls:
        for name in MOVES:
            if name in call:
                numbers = [float(word) for word in NUMBER.findall(call[call.index(name) :])]
                if not (found and name == "STRAIGHT_TRAVERSE" and found[-1][1] == numbers):
                    found.append((name, numbers))
    return found


THREADS = {
    "outside": cut_of(),
    "inside": cut_of("M24", "inside", z_end_mm=-18.0),
    "flank": cut_of(infeed="flank", infeed_deg=29.5, spring=2),
    "pull-out": cut_of("1/2-13 UNC", infeed="flank", infeed_deg=29.0, pull_out_mm=2.0, first_depth_mm=0.2),
    "two starts": cut_of("Tr40x14P7", z_end_mm=-60.0, first_depth_mm=0.7, degression=1.5, rpm=50.0),
}
EXPANDED = {
    **THREADS,
    "alternating": cut_of(infeed="alternating", infeed_deg=29.0),
    "cone": cut_of(slope=tan(radians(3.0))),
    "cone with pull-out": cut_of(slope=-0.1, pull_out_mm=3.0),
}


@pytest.mark.parametrize("name", THREADS)
def test_rs274_drives_the_same_moves_for_g76_and_for_its_passes_in_g33(name, tmp_path):
    traces = []
    for whole in (True, False):
        text = text_of(THREADS[name], whole=whole)
        assert ("G76" in text) == whole and ("G33" in text) != whole
        theirs, accepted = rs274_calls(text, tmp_path)
        assert accepted, theirs[-1]
        ours = [call.rstrip() for call in canonical_calls(text) if call.strip()]
        assert all(map(same_call, ours, theirs)) and len(ours) == len(theirs)
        traces.append(moves_of(theirs))
    assert len(traces[0]) == len(traces[1]) > 20
    for (name, numbers), (other, others) in zip(*traces, strict=True):
        assert name == other and numbers == pytest.approx(others, abs=0.00101)  # a last digit of the text


@pytest.mark.parametrize("name", EXPANDED)
def test_the_text_has_the_rows_of_the_table_and_is_written_again_the_same(name):
    meant, text = table_of(EXPANDED[name]), text_of(EXPANDED[name])
    start = Start(position_mm=(40.0, 0.0, 50.0), zero_known=True)
    read = interpret(text, start, "linuxcnc")
    assert np.abs(read.table().end - meant.table().end).max() < 0.00051
    assert read.table().feed == pytest.approx(meant.table().feed, rel=1e-3)
    assert [event.value for event in read.events if event.kind == "synchronised"] == pytest.approx(
        [event.value for event in meant.events if event.kind == "synchronised"], rel=1e-6
    )
    again = write(read, "linuxcnc", WriteOptions(retract=False))
    assert [line for line in again.splitlines() if "G33" in line] == [
        line for line in text.splitlines() if "G33" in line
    ]


@pytest.mark.parametrize("name", EXPANDED)
def test_z_goes_on_by_one_lead_a_turn_and_every_pass_of_a_start_meets_the_groove(name):
    """At each turn of the spindle the tool's flank is where the groove of the last pass is, or inside it."""
    cut = EXPANDED[name]
    path = table_of(cut)
    begins, table = path.begins(), path.table()
    flank = tan(radians(cut.form.angle_deg / 2))
    entries = []
    for row in np.flatnonzero(table.kind == LINE):
        run = table.end[row] - begins[row]
        turns = hypot(run[0], run[2]) / table.feed[row] * cut.rpm
        assert abs(run[2]) == pytest.approx(turns * cut.form.lead_mm)
        if table.kind[row - 1] != LINE:
            x, _, z = begins[row]
            entries.append((abs(x - cut.crest_at_mm(z)), z))
    per_start = np.array(entries).reshape(cut.form.starts, -1, 2)
    middles = per_start[:, -1, 1]
    assert -np.diff(middles) == pytest.approx([-cut.form.pitch_mm] * (cut.form.starts - 1))
    for passes, middle in zip(per_start, middles, strict=True):
        room = (cut.depth_mm - passes[:, 0]) * flank
        assert (np.abs(passes[:, 1] - middle) <= room + 1e-9).all()
        assert passes[-1, 0] == pytest.approx(cut.depth_mm)
        if cut.infeed == "alternating":
            off = (passes[:, 1] - middle)[:-2]
            assert (off[1:] * off[:-1] < 0).all()


def test_with_a_degression_of_2_every_pass_takes_the_same_area():
    cut = cut_of(spring=0)
    depths = np.array([0.0, *cut.depths_mm()])
    areas = np.diff(depths**2)
    assert areas[:-1] == pytest.approx(areas[0]) and areas[0] * 0.95 < areas[-1] <= areas[0] * 1.001
    assert depths[1] <= cut.first_depth_mm and depths[-1] == cut.depth_mm


@pytest.mark.parametrize("dialect", ["grbl", "mini-lathe", "marlin"])
def test_a_feed_that_does_not_follow_the_spindle_is_refused_with_what_to_do(dialect):
    with pytest.raises(ProgramError) as refusal:
        text_of(cut_of(), dialect)
    assert refusal.value.code == "no-thread"
    words = "thread_start=index" if dialect == "mini-lathe" else "G33"
    assert words in refusal.value.advice


@pytest.mark.parametrize("name", ["outside", "inside", "cone", "two starts"])
def test_the_mini_lathe_cuts_all_passes_in_the_same_groove(name):
    cut = replace(EXPANDED[name], pull_out_mm=0.0)
    path = table_of(cut)
    path.start = Start.at_zero()
    text = text_of(cut, "mini-lathe:thread_start=index")
    assert f"F{cut.feed_mm_min * hypot(1, cut.slope) / 60:.4f}".rstrip("0").rstrip(".") in text
    twin = Lathe(thread_start=True, spindle_rpm=cut.rpm, buffer_bytes=100_000)
    send(twin, b"Y")
    rows = np.array(send(twin, text.encode()))
    assert not twin.refused
    phases: dict[float, set[float]] = {}
    begin_z = {round(cut.begin_z_mm(start), 4): start for start in range(cut.form.starts)}
    for before, row in pairwise(rows):
        if any(abs(before[2] - z) < 1e-9 for z in begin_z) and row[2] < before[2]:
            phases.setdefault(round(float(before[2]), 3), set()).add(round(float(row[0]) * cut.rpm / 60 % 1.0, 4))
    many = len(cut.depths_mm())
    assert phases and many > 3
    assert all(len(seen) <= 2 for seen in phases.values()), phases


def test_lead_times_speed_above_the_axis_is_refused_with_the_speed_that_would_do():
    machine = load_machine("mini-lathe")
    with pytest.raises(CycleError) as refusal:
        check_thread(cut_of(rpm=600.0), machine)
    most = float(refusal.value.advice.split()[-2])
    assert refusal.value.code == "thread-speed" and most == pytest.approx(1388.9 / 2.5, rel=1e-3)
    check_thread(cut_of(rpm=most * 0.999), machine)
    with pytest.raises(CycleError, match="axis X"):
        check_thread(cut_of(rpm=most * 0.9, pull_out_mm=0.5), machine)


def test_a_thread_longer_than_its_cylinder_is_refused_with_its_length():
    shaft = Curve.trusted(np.array([[0.0, 10.0], [-25.0, 10.0], [-25.0, 15.0], [-60.0, 15.0]]), np.zeros(3))
    with pytest.raises(CycleError) as refusal:
        check_cylinder(cut_of(), shaft)
    assert refusal.value.limit == "25 mm" and "length_mm = 25" in refusal.value.advice
    check_cylinder(cut_of(z_end_mm=-25.0), shaft)
    cone = Curve.trusted(np.array([[0.0, 10.0], [-40.0, 12.0], [-40.0, 20.0]]), np.zeros(2))
    check_cylinder(cut_of(slope=0.05, z_end_mm=-40.0), cone)
    with pytest.raises(CycleError, match="longer"):
        check_cylinder(cut_of(slope=0.05, z_end_mm=-40.1), cone)


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"pull_out_mm": 31.0}, "thread-length"),
        ({"crest_radius_mm": 8.0}, "thread-crest"),
        ({"slope": -0.4}, "thread-axis"),
    ],
)
def test_threads_that_cannot_be_are_refused(change, code):
    with pytest.raises(CycleError) as refusal:
        check_thread(cut_of(**change), load_machine("mini-lathe"))
    assert refusal.value.code == code


def test_too_many_passes_are_refused_with_the_first_depth_that_would_do():
    with pytest.raises(CycleError) as refusal:
        cut_of(first_depth_mm=0.01).depths_mm()
    least = float(refusal.value.limit.split()[0])
    assert len(cut_of(first_depth_mm=least * 1.1).depths_mm()) < 502


def test_the_angle_of_a_cone_is_that_of_its_slope():
    cut = EXPANDED["cone"]
    rows = table_of(cut)
    ends, begins = rows.table().end, rows.begins()
    row = int(np.flatnonzero(rows.table().kind == LINE)[0])
    run = ends[row] - begins[row]
    assert atan(run[0] / -run[2]) == pytest.approx(radians(3.0))


def test_the_lead_that_the_mini_lathes_timer_makes_is_warned_of_and_is_what_the_twin_makes():
    machine, cut = load_machine("mini-lathe"), cut_of()
    (warning,) = timer_warnings(cut, machine)
    twin = Lathe(thread_start=True, spindle_rpm=cut.rpm, buffer_bytes=100_000)
    send(twin, b"Y")
    rows = np.array(send(twin, b"G90 G01 Z-9. F3.75 # M02 #?"))
    run = rows[(rows[:, 2] < 0.0) & (rows[:, 2] > -9.0)]
    turns = (run[-1, 0] - run[0, 0]) * cut.rpm / 60.0
    assert f"a lead of {(run[0, 2] - run[-1, 2]) / turns:.3f}" in warning
    right = float(warning.split(" rpm")[0].split()[-1])
    assert not timer_warnings(replace(cut, rpm=right), machine)
    assert not timer_warnings(cut, load_machine("table-a"))
