# SPDX-License-Identifier: LGPL-2.1-or-later
"""A path in strokes of one power each, with a feed for each segment, by the rules of cutting."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from CNCStepper.cycles.sheet_cutting.chains import Chain
from CNCStepper.cycles.sheet_cutting.sheet_model import ArcRule, CornerRule, MicroJoints, PowerRamp, SmallHoles
from CNCStepper.cycles.sheet_cutting.slow_places import SlowPlaces
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import COINCIDENT_MM

RAMP_STEPS = 8


@dataclass(frozen=True)
class Stroke:
    """A stretch of a path; feeds_mm_min: of each segment, float64[n]; power: a share of the whole, 0 without."""

    curve: Curve
    feeds_mm_min: np.ndarray
    power: float

    def reversed(self) -> Stroke:
        """Return the stretch run backwards."""
        return Stroke(self.curve.reversed(), self.feeds_mm_min[::-1], self.power)

    def split(self, lengths_mm: Iterable[float]) -> list[Stroke]:
        """Return the pieces between its start, some lengths from there, and its end."""
        pieces, begin_mm = [], 0.0
        for piece in self.curve.split(lengths_mm):
            middles_mm = begin_mm + _middles_mm(piece)
            feeds = self.feeds_mm_min[np.searchsorted(self.curve.before_mm, middles_mm) - 1]
            pieces.append(Stroke(piece, feeds, self.power))
            begin_mm += piece.length_mm
        return pieces


def even(curve: Curve, feed_mm_min: float, power: float) -> Stroke:
    """Return a stroke with one feed."""
    return Stroke(curve, np.full(len(curve), feed_mm_min), power)


@dataclass(frozen=True)
class Rules:
    """The rules of an operation with what they need to know; side: +1 where the part lies right of the paths."""

    feed_mm_min: float
    kerf_mm: float
    thickness_mm: float
    side: int
    passes: int
    overcut_mm: float
    small_holes: SmallHoles | None
    arcs: ArcRule | None
    corners: CornerRule | None
    joints: MicroJoints | None
    ramp: PowerRamp | None

    def is_small(self, chain: Chain) -> bool:
        """Return whether a chain is a small hole."""
        rule = self.small_holes
        if rule is None or not chain.is_hole:
            return False
        below_mm = max(rule.diameter_mm, rule.thickness_ratio * self.thickness_mm)
        return chain.diameter_mm < below_mm or chain.curve.length_mm < rule.length_mm

    def feed_of(self, chain: Chain) -> float:
        """Return the feed of a chain where no corner or arc slows it down."""
        return self.feed_mm_min * (self.small_holes.feed_share if self.small_holes and self.is_small(chain) else 1.0)


def strokes(path: Curve, chain: Chain, slow: SlowPlaces, rules: Rules) -> list[Stroke]:
    """Return the strokes of a path from its begin on: its laps, then what runs on past its begin."""
    lap = _lap(path, chain, slow, rules)
    found = [stroke for _ in range(rules.passes) for stroke in lap]
    if rules.passes > 1 and not path.closed:
        found = [one for number in range(rules.passes) for one in (lap if number % 2 == 0 else _back(lap))]
    if path.closed:
        found = _ended(found, path, chain, rules)
    return _ramped(found, rules.ramp) if rules.ramp else found


def joint_places(path: Curve, chain: Chain, joints: MicroJoints | None, kerf_mm: float) -> list[float]:
    """Return where joints lie along a path, evenly spread; raises CycleError where they leave nothing to cut."""
    if joints is None or not chain.is_part:
        return []
    count = joints.count or max(math.ceil(path.length_mm / joints.spacing_mm), 1)
    gap_mm = joints.width_mm + kerf_mm
    if count * gap_mm > path.length_mm / 2.0:
        raise CycleError(
            "tab-room",
            Text("{count} joints do not fit on {chain}", count=count, chain=chain.title),
            value=Text("{gap_mm:g} mm each, the kerf included", gap_mm=gap_mm),
            limit=Text("{most_mm:.2f} mm each", most_mm=path.length_mm / 2.0 / count),
            advice=_fewer_or_narrower(path.length_mm / 2.0, count, gap_mm, kerf_mm),
        )
    return [(number + 0.5) * path.length_mm / count for number in range(count)]


def _fewer_or_narrower(room_mm: float, count: int, gap_mm: float, kerf_mm: float) -> Text | str:
    """Return the count or the width of joints that would do; room_mm: what they may take of the path."""
    fewer, width_mm = int(room_mm / gap_mm), math.floor(100.0 * (room_mm / count - kerf_mm)) / 100.0
    narrower = Text("set width_mm to at most {width_mm:.2f}", width_mm=width_mm)
    if fewer and width_mm > 0.0:
        return Text("ask for at most {fewer}, or {narrower}", fewer=fewer, narrower=narrower)
    if fewer:
        return Text("ask for at most {fewer}", fewer=fewer)
    return narrower if width_mm > 0.0 else "leave the joints out"


def _lap(path: Curve, chain: Chain, slow: SlowPlaces, rules: Rules) -> list[Stroke]:
    """Return one lap along a path, slowed down and interrupted where a rule says so."""
    lap = _slowed(path, slow, rules.feed_of(chain), rules)
    places = joint_places(path, chain, rules.joints, rules.kerf_mm)
    if not places or rules.joints is None:
        return [lap]
    half_mm = (rules.joints.width_mm + rules.kerf_mm) / 2.0
    gaps = [(at - half_mm, at + half_mm) for at in places]
    pieces = lap.split([end % path.length_mm for gap in gaps for end in gap])
    ends = np.cumsum([piece.curve.length_mm for piece in pieces])
    middles = ends - [piece.curve.length_mm / 2.0 for piece in pieces]
    cut = ~_within(middles, np.array(gaps), path)
    return [replace(piece, power=float(on)) for piece, on in zip(pieces, cut.tolist(), strict=True)]


def _slowed(path: Curve, slow: SlowPlaces, feed_mm_min: float, rules: Rules) -> Stroke:
    """Return a path with the feed of each segment, divided where the feed changes."""
    shares, corners = slow.shares, slow.corners
    if rules.corners is None or not len(corners):
        return Stroke(path, feed_mm_min * shares, 1.0)
    whole_mm = path.length_mm
    ends = corners.reshape(-1)
    divided = path.divided_at(ends % whole_mm if path.closed else np.minimum(np.maximum(ends, 0.0), whole_mm))
    middles = _middles_mm(divided)
    shares = shares[np.searchsorted(path.before_mm, middles) - 1]
    near = _within(middles, corners, path)
    shares[near] = np.minimum(shares[near], rules.corners.feed_share)
    return Stroke(divided, feed_mm_min * shares, 1.0)


def _middles_mm(curve: Curve) -> np.ndarray:
    before = curve.before_mm
    return (before[1:] + before[:-1]) / 2.0


def _within(places_mm: np.ndarray, stretches: np.ndarray, path: Curve) -> np.ndarray:
    """Return which places, float64[n], lie in one of some stretches, float64[k, 2]; round a closed path."""
    first, last = stretches.T
    on_mm = places_mm[:, None] - first
    if path.closed:
        on_mm %= path.length_mm
    return np.asarray(((on_mm >= 0.0) & (on_mm <= last - first)).any(axis=1))


def _ended(found: list[Stroke], path: Curve, chain: Chain, rules: Rules) -> list[Stroke]:
    """Return the strokes with what runs on past the begin; a small hole's last stretch has no power."""
    rule, feed = rules.small_holes, rules.feed_of(chain)
    if rules.overcut_mm:
        found = [*found, even(_onwards(path, 0.0, rules.overcut_mm), feed, 1.0)]
    if rule is None or not rules.is_small(chain):
        return found
    if rule.torch_off_mm:
        found = _switched_off(found, rule.torch_off_mm)
    if rule.over_run_mm:
        found = [*found, even(_onwards(path, rules.overcut_mm, rule.over_run_mm), feed, 0.0)]
    return found


def _onwards(path: Curve, begin_mm: float, length_mm: float) -> Curve:
    """Return a stretch of a closed path, no longer than all of it."""
    return path.part(begin_mm, begin_mm + min(length_mm, path.length_mm))


def _switched_off(found: list[Stroke], length_mm: float) -> list[Stroke]:
    """Return the strokes without power over the last stretch."""
    kept, left_mm = list(found), length_mm
    tail: list[Stroke] = []
    while kept and left_mm > COINCIDENT_MM:
        last = kept.pop()
        begin_mm = last.curve.length_mm - left_mm
        pieces = last.split([begin_mm]) if begin_mm > 0.0 else [last]
        tail.insert(0, replace(pieces[-1], power=0.0))
        kept += pieces[:-1]
        left_mm -= pieces[-1].curve.length_mm
    return kept + tail


def _ramped(found: list[Stroke], ramp: PowerRamp) -> list[Stroke]:
    """Return the strokes with a power that rises in steps from the first on."""
    raised: list[Stroke] = []
    steps_mm = np.arange(1, RAMP_STEPS + 1) * ramp.length_mm / RAMP_STEPS
    done_mm = 0.0
    for stroke in found:
        for piece in stroke.split(steps_mm[steps_mm > done_mm] - done_mm):
            share = min((done_mm + piece.curve.length_mm / 2.0) / ramp.length_mm, 1.0)
            power = ramp.begin_share + (1.0 - ramp.begin_share) * share
            raised.append(replace(piece, power=stroke.power * power))
            done_mm += piece.curve.length_mm
    return raised


def _back(lap: list[Stroke]) -> list[Stroke]:
    return [stroke.reversed() for stroke in reversed(lap)]
