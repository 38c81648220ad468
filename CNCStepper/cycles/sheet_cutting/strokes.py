# SPDX-License-Identifier: LGPL-2.1-or-later
"""A path in strokes of one feed and one power each: what the rules for holes, arcs, corners and joints make of it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from CNCStepper.cycles.sheet_cutting.chains import Chain
from CNCStepper.cycles.sheet_cutting.sheet_model import ArcRule, CornerRule, MicroJoints, PowerRamp, SmallHoles
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import COINCIDENT_MM

NONE_MM = 0.01  # a drawn arc of a smaller radius is a corner
RAMP_STEPS = 8


@dataclass(frozen=True)
class Stroke:
    """A stretch of a path; power: a share of the whole, 0 without power."""

    curve: Curve
    feed_mm_min: float
    power: float


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


def strokes(path: Curve, chain: Chain, rules: Rules) -> list[Stroke]:
    """Return the strokes of a path from its begin on: its laps, then what runs on past its begin."""
    lap = _lap(path, chain, rules)
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
            advice="ask for fewer or narrower joints",
        )
    return [(number + 0.5) * path.length_mm / count for number in range(count)]


def _lap(path: Curve, chain: Chain, rules: Rules) -> list[Stroke]:
    """Return one lap along a path, slowed down and interrupted where a rule says so."""
    feed = rules.feed_of(chain)
    slow = [*_corners(path, rules), *_arcs(path, rules)]
    half_mm = (rules.joints.width_mm + rules.kerf_mm) / 2.0 if rules.joints else 0.0
    gaps = [(at - half_mm, at + half_mm) for at in joint_places(path, chain, rules.joints, rules.kerf_mm)]
    if not slow and not gaps:
        return [Stroke(path, feed, 1.0)]
    whole_mm = path.length_mm
    ends = np.array([end for first, last, _ in slow for end in (first, last)] + [end for gap in gaps for end in gap])
    pieces = path.split(ends % whole_mm if path.closed else np.clip(ends, 0.0, whole_mm))
    middles = np.cumsum([piece.length_mm for piece in pieces]) - [piece.length_mm / 2.0 for piece in pieces]
    shares = [min([1.0, *(share for *stretch, share in slow if _within(at, stretch, path))]) for at in middles.tolist()]
    powers = [0.0 if any(_within(at, gap, path) for gap in gaps) else 1.0 for at in middles.tolist()]
    return [Stroke(piece, feed * share, power) for piece, share, power in zip(pieces, shares, powers, strict=True)]


def _corners(path: Curve, rules: Rules) -> list[tuple[float, float, float]]:
    """Return the stretches round corners with their share of the feed."""
    rule = rules.corners
    if rule is None or not rule.angle_deg:
        return []
    before, rows = path.before_mm, path.rows
    ahead, after = rows[:, 6:8], np.roll(rows[:, 8:10], 1, axis=0)
    cosines = (ahead * after).sum(axis=1)
    cosines[0] = cosines[0] if path.closed else 1.0
    sharp = before[:-1][cosines < math.cos(math.radians(rule.angle_deg))]
    tight = (np.abs(rows[:, 4]) > math.radians(rule.angle_deg)) & (_drawn_radii_mm(path, rules) < NONE_MM)
    places = [*zip(sharp, sharp, strict=True), *zip(before[:-1][tight], before[1:][tight], strict=True)]
    return [(float(a) - rule.distance_mm, float(b) + rule.distance_mm, rule.feed_share) for a, b in places]


def _arcs(path: Curve, rules: Rules) -> list[tuple[float, float, float]]:
    """Return the arcs of a small drawn radius with their share of the feed."""
    rule = rules.arcs
    if rule is None or not rule.radius_mm:
        return []
    radii = _drawn_radii_mm(path, rules)
    narrow = np.flatnonzero((radii < rule.radius_mm) & (radii >= NONE_MM))
    before = path.before_mm
    return [(float(before[row]), float(before[row + 1]), rule.feed_share) for row in narrow.tolist()]


def _drawn_radii_mm(path: Curve, rules: Rules) -> np.ndarray:
    """Return the radius of the drawn arc to which each arc of a path is parallel, infinite for lines."""
    bends = path.rows[:, 5]
    with np.errstate(divide="ignore"):
        radii = 1.0 / np.abs(bends)
    return radii + np.where(bends * rules.side < 0.0, -1.0, 1.0) * rules.kerf_mm / 2.0


def _within(at_mm: float, stretch: Sequence[float], path: Curve) -> bool:
    first, last = stretch
    if not path.closed:
        return first <= at_mm <= last
    return last - first >= path.length_mm or (at_mm - first) % path.length_mm <= last - first


def _ended(found: list[Stroke], path: Curve, chain: Chain, rules: Rules) -> list[Stroke]:
    """Return the strokes with what runs on past the begin; a small hole's last stretch has no power."""
    rule, feed = rules.small_holes, rules.feed_of(chain)
    if rules.overcut_mm:
        found = [*found, Stroke(_head(path, rules.overcut_mm), feed, 1.0)]
    if rule is None or not rules.is_small(chain):
        return found
    if rule.torch_off_mm:
        found = _switched_off(found, rule.torch_off_mm)
    if rule.over_run_mm:
        begin_mm = rules.overcut_mm % path.length_mm
        found = [*found, Stroke(_head(path.started_at_length(begin_mm), rule.over_run_mm), feed, 0.0)]
    return found


def _head(path: Curve, length_mm: float) -> Curve:
    """Return the first stretch of a closed path, no longer than all of it."""
    return path.split([length_mm])[0]


def _switched_off(found: list[Stroke], length_mm: float) -> list[Stroke]:
    """Return the strokes without power over the last stretch."""
    kept, left_mm = list(found), length_mm
    tail: list[Stroke] = []
    while kept and left_mm > COINCIDENT_MM:
        last = kept.pop()
        pieces = last.curve.split([last.curve.length_mm - left_mm]) if last.curve.length_mm > left_mm else [last.curve]
        tail.insert(0, Stroke(pieces[-1], last.feed_mm_min, 0.0))
        if len(pieces) > 1:
            kept.append(Stroke(pieces[0], last.feed_mm_min, last.power))
        left_mm -= pieces[-1].length_mm
    return kept + tail


def _ramped(found: list[Stroke], ramp: PowerRamp) -> list[Stroke]:
    """Return the strokes with a power that rises in steps from the first on."""
    raised: list[Stroke] = []
    steps_mm = np.arange(1, RAMP_STEPS + 1) * ramp.length_mm / RAMP_STEPS
    done_mm = 0.0
    for stroke in found:
        for piece in stroke.curve.split(steps_mm[steps_mm > done_mm] - done_mm):
            share = min((done_mm + piece.length_mm / 2.0) / ramp.length_mm, 1.0)
            power = ramp.begin_share + (1.0 - ramp.begin_share) * share
            raised.append(Stroke(piece, stroke.feed_mm_min, stroke.power * power))
            done_mm += piece.length_mm
    return raised


def _back(lap: list[Stroke]) -> list[Stroke]:
    return [Stroke(stroke.curve.reversed(), stroke.feed_mm_min, stroke.power) for stroke in reversed(lap)]
