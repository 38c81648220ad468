# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random jobs of a lathe: shafts and bores of steps, cones, arcs and valleys that their insert reaches."""

from __future__ import annotations

import math
import random
from pathlib import Path
from typing import Any

from CNCStepper.job.turning.turning_job import TurningJob, turning_job_of

INSERTS = {"CNMG 120408": 4.0, "DCMT 11T304": 28.0, "VBMT 160404": 48.0, "TNMG 160408": 22.0}  # deepest slope down
SMALL_INSERTS = {"CCMT 060204": 4.0, "DCMT 070202": 28.0}  # those of boring bars
STOCK_MM = 30.0  # radius of the bar


def random_points(choice: random.Random, slope_deg: float, radii: tuple[float, float], side: float) -> list[Any]:
    """Return rows of a profile, x as radius: rising from `radii[0]`, falling no steeper than the slope."""
    low, high = radii
    z, r = 0.0, choice.uniform(low, low + 0.3 * (high - low)) if side > 0 else high
    rows: list[Any] = [[r, z]]
    for _ in range(choice.randint(2, 7)):
        kind = choice.choice(["along", "step", "cone", "arc", "valley"])
        run = choice.uniform(2.0, 12.0)
        room = (high - r) if side > 0 else (r - low)
        if kind == "along":
            z -= run
        elif kind == "step" and room > 1.0:
            r += side * choice.uniform(0.5, room * 0.8)
        elif kind == "cone" and room > 1.0:
            r += side * choice.uniform(0.2, room * 0.7)
            z -= run
        elif kind == "arc" and room > 4.0:
            size = choice.uniform(1.5, min(room, 8.0) * 0.9)
            r, z = r + side * size, z - size
            hollow = choice.random() < 0.5
            clockwise = hollow if side > 0 else not hollow
            rows.append({"to": [r, z], "arc": "cw" if clockwise else "ccw", "radius_mm": size * 1.0000001})
            continue
        elif kind == "valley":
            fall = min(math.tan(math.radians(slope_deg)) * run * 0.9, 5.0, (r - low) if side > 0 else (high - r))
            r, z = r - side * fall, z - run
        rows.append([r, z])
    rows.append([r, z - 1.0])
    kept = [rows[0]]
    for row in rows[1:]:
        before = kept[-1]["to"] if isinstance(kept[-1], dict) else kept[-1]
        if isinstance(row, dict) or math.dist(row, before) > 0.01:
            kept.append(row)
    return kept


def from_the_chuck(choice: random.Random, rows: list[Any], slope_deg: float) -> list[Any]:
    """Return rows mirrored in z for a left-hand insert, which comes down to them over a slope from the bar.

    Half of them begin at the raw end, the others behind a shoulder of the whole bar.
    """
    r_first, z_last = rows[0][0], min(_place(row)[1] for row in rows)
    run = (STOCK_MM - r_first) / math.tan(math.radians(0.9 * slope_deg))
    before = choice.choice([0.0, choice.uniform(3.0, 15.0)])
    places = [(STOCK_MM, z_last - run), *((r, z_last - z) for r, z in map(_place, rows))]
    arcs = [{}, {}, *({} if isinstance(row, list) else row for row in rows[1:])]
    mirrored: list[Any] = []
    for number in range(len(places) - 1, -1, -1):
        r, z = places[number]
        arc = arcs[number + 1] if number + 1 < len(arcs) else {}
        mirrored.append({**arc, "to": [r, z - before]} if arc else [r, z - before])
    return mirrored


def _place(row: Any) -> list[float]:
    return row["to"] if isinstance(row, dict) else row


def random_job(seed: int, machine: str, *, inside: bool = False, along: str = "z", hand: str = "right") -> TurningJob:
    """Return a job that faces, roughs and finishes a random profile; inside: a tube is bored."""
    choice = random.Random(seed)
    insert, slope_deg = choice.choice(list((SMALL_INSERTS if inside else INSERTS).items()))
    if along == "x":
        slope_deg = min(slope_deg, 20.0)
    side = -1.0 if inside else 1.0
    radii = (12.0, 25.0) if inside else (4.0, STOCK_MM - 1.0)
    if hand == "left":
        radii = (STOCK_MM - 1.0 - math.tan(math.radians(slope_deg)) * 20.0, STOCK_MM - 1.0)
    points = random_points(choice, slope_deg, radii, side)
    if hand == "left":
        points = from_the_chuck(choice, points, slope_deg)
    ap_mm, leave_mm = choice.uniform(0.5, 3.0), choice.choice([0.0, 0.2, 0.5])
    tool: dict[str, Any] = {"number": 1, "insert": insert, "lead_deg": 95.0 if insert[0] in "CT" else 93.0}
    tool |= {"kind": "boring" if inside else "turning", "feed_mm_rev": 0.2, "spindle_rpm": 500.0}
    one = {"tool": 1, "profile": "part"}
    tool["hand"] = hand
    face = [] if inside or hand == "left" else [{"cycle": "turn_face", "tool": 1, "ap_mm": 1.0}]
    return turning_job_of(
        {
            "machine": machine,
            "process": "turning",
            "x_is": "radius",
            "start": [40.0 if not inside else 8.0, 10.0],
            "stock": {
                "diameter_mm": 2 * STOCK_MM,
                "face_mm": 1.0 if face else 0.0,
                "length_mm": 200.0 if hand == "left" else 150.0,
            }
            | ({"form": "tube", "bore_mm": 20.0} if inside else {}),
            "tool": [tool],
            "profile": [{"name": "part", "points": points}],
            "operation": [
                *face,
                {"cycle": "turn_rough", "along": along, "ap_mm": ap_mm, "stock_to_leave_mm": leave_mm, **one},
                {"cycle": "turn_finish", **one},
            ],
        },
        Path("random.toml"),
    )
