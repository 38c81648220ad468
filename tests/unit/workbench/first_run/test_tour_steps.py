# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tour goes on by what is seen to be done, in whatever way, and never back."""

from __future__ import annotations

from CNCStepper.workbench.first_run.tour_steps import CUT, DRAWING, JOB, OPERATION, STEPS, Tour


def test_there_are_seven_steps_from_the_job_to_the_cut_part() -> None:
    assert [step.key for step in STEPS] == [
        "job",
        "drawing",
        "operation",
        "simulation",
        "connection",
        "cut",
        "done",
    ]
    assert all(step.text.endswith(".") for step in STEPS)


def test_each_step_that_is_seen_leads_to_the_next() -> None:
    tour = Tour()
    for number, step in enumerate(STEPS):
        assert tour.step is step
        assert tour.place == number
        assert not tour.look(set())
        assert tour.look({step.key})
    assert tour.step is None


def test_a_step_that_was_left_out_is_not_waited_for() -> None:
    tour = Tour()
    assert tour.look({JOB, OPERATION})  # a circular pocket by numbers takes no drawing
    assert tour.step is STEPS[3]
    assert not tour.look({DRAWING})


def test_what_is_taken_back_does_not_lead_back() -> None:
    tour = Tour()
    tour.look({CUT})
    assert not tour.look(set())
    assert tour.place == 6
