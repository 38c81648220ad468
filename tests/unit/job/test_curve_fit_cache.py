# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines and ellipses from plain data: their places, their fits within the tolerance, and who makes them when."""

from __future__ import annotations

import json
import math
import random
from collections.abc import Iterator
from queue import SimpleQueue
from typing import Any

import numpy as np
import pytest

from CNCStepper.cancellation import interruptible
from CNCStepper.errors import CNCStepperError
from CNCStepper.job import curve_fit_cache
from CNCStepper.job.curve_fit_cache import Ellipse, Spline, answer_to, fit_of, require
from CNCStepper.job.deferred_fitting import Unfitted, only_looking
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workers import cycle_cutting

ARC = Spline(  # a quarter of a circle of 10 mm
    0.0, 1.0, degree=2, poles=((10.0, 0.0), (10.0, 10.0), (0.0, 10.0)), weights=(1.0, math.sqrt(0.5), 1.0),
    knots=(0.0, 0.0, 0.0, 1.0, 1.0, 1.0),
)  # fmt: skip


@pytest.fixture(autouse=True)
def nothing_kept() -> Iterator[None]:
    curve_fit_cache._fits.clear()
    yield
    curve_fit_cache._fits.clear()
    result_cache.forget()


@pytest.fixture
def told(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, Any]]:
    said: list[dict[str, Any]] = []
    monkeypatch.setattr(cycle_cutting, "tell", said.append)
    return said


def ask(question: dict[str, Any], told: list[dict[str, Any]]) -> dict[str, Any]:
    """Return what the cut process answers."""
    cycle_cutting.Answers(SimpleQueue())._answer({"mark": 1, "compiled": True, "parts": {"a": question}})
    (answer,) = [each["answer"] for each in told if "key" in each]
    return dict(json.loads(json.dumps(answer)))


def wave(seed: int) -> Spline:
    rng = random.Random(seed)
    poles = tuple((10.0 * x, rng.uniform(-8, 8)) for x in range(8))
    inner = (1.0, 2.0, 3.0, 4.0)
    return Spline(0.0, 5.0, 3, poles, (1.0,) * 8, (0.0,) * 4 + inner + (5.0,) * 4)


def test_a_spline_with_weights_is_a_circle() -> None:
    points = ARC.points(np.linspace(0, 1, 20))
    assert np.hypot(*points.T) == pytest.approx(np.full(20, 10.0), abs=1e-12)
    assert points[0].tolist() == [10.0, 0.0] and points[-1] == pytest.approx([0.0, 10.0])


def test_a_closed_spline_goes_on_round_its_beginning() -> None:
    closed = Spline(0.0, 1.0, 2, ARC.poles, ARC.weights, ARC.knots, period=1.0)
    assert closed.points(np.array([1.25, 2.5])).tolist() == closed.points(np.array([0.25, 0.5])).tolist()


@pytest.mark.parametrize("seed", range(5))
def test_a_fit_stays_within_the_tolerance(seed: int) -> None:
    print("seed", seed)
    line = wave(seed)
    places = line.points(np.linspace(0, 5, 3001))
    assert fit_of(line, 0.01).distances_mm(places).max() <= 0.01


def test_an_ellipse_is_fitted_in_equal_quarters() -> None:
    fit = fit_of(Ellipse(0.0, math.tau, (3.0, 4.0), (20.0, 0.0), (0.0, 5.0)), 0.01)
    assert fit.closed and len(fit) % 4 == 0
    assert fit.area_mm2 == pytest.approx(math.pi * 100, rel=1e-3)


def test_what_is_looked_at_is_asked_of_the_process_and_then_known(told: list[dict[str, Any]]) -> None:
    lines = [wave(1), ARC]
    with only_looking(), pytest.raises(Unfitted) as raised:
        require(lines, 0.01)
    question = json.loads(json.dumps(raised.value.question))
    result_cache.take("a", ask(question, told))
    assert {"stage": "fit"} in told
    with only_looking():
        require(lines, 0.01)
    fitted = [fit_of(line, 0.01) for line in lines]
    curve_fit_cache._fits.clear()
    assert fitted == [fit_of(line, 0.01) for line in lines]


def test_who_does_not_only_look_fits_for_himself() -> None:
    require([ARC], 0.01)
    assert len(fit_of(ARC, 0.01)) == 1


def test_another_tolerance_is_another_fit() -> None:
    assert len(fit_of(wave(2), 0.001)) > len(fit_of(wave(2), 0.1))
    with only_looking(), pytest.raises(Unfitted):
        require([wave(2)], 0.05)


def test_a_fit_that_cannot_be_is_the_answer(told: list[dict[str, Any]]) -> None:
    result_cache.take("a", ask({"fit": [ARC.content], "tolerance_mm": 0.0}, told))
    assert isinstance(result_cache.known("a"), CNCStepperError)


def test_a_fit_can_be_ended() -> None:
    def look() -> None:
        raise TimeoutError

    with pytest.raises(TimeoutError), interruptible(look):
        answer_to({"fit": [wave(3).content], "tolerance_mm": 0.001})


def test_the_oldest_fits_go(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(curve_fit_cache, "MOST_ROWS", 5)
    for seed in range(4):
        fit_of(wave(seed), 0.01)
    assert len(curve_fit_cache._fits) == 1
