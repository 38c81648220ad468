# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seeded fault runs at the mini-lathe: it cannot be stopped, so it must be said for how long it runs on, and end there.

The lathe has no pins; in their place a byte comes spoiled, which nobody but a person sees. What was cut before is not
known to anything: the whole program is sent again, from its zero, at a lathe that was switched off and on.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from math import inf
from random import Random

import pytest

from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import DONE, FAILED, STOPPED, Outcome
from helpers.controllers.lathe_link import Killed, LatheLink, sent

RUNS = max(20, int(os.environ.get("CNCSTEPPER_FAULT_RUNS", "0")) // 10)
KINDS = ("cable", "sender", "controller", "late", "spoiled", "stop")
RUNS_ON = re.compile(r"cannot be stopped.* it runs on for ([0-9.]+) s")
SAID_MM = 0.02
SAID_S = 3.0
SEES_S = 0.5  # after which a person stops a lathe that goes elsewhere


def program_of(random: Random) -> tuple[str, tuple[float, float]]:
    """Return a program of records, and where it ends: X as a radius, Z, mm from its zero."""
    records, x, z = [], 0.0, 0.0
    for _ in range(random.randint(4, 12)):
        by_x, by_z = (random.choice((0.0, random.randint(-400, 400) / 80)) for _ in "XZ")
        x, z = x + by_x, z + by_z
        code = random.choice(("G00", "G01"))
        feed = f" F{random.choice((1.0, 2.0, 2.5))}" if code == "G01" else ""
        records.append(f"{code} X{by_x:.4f} Z{by_z:.4f}{feed} #")
    return "\n".join([*records, "M02 #", ""]), (x, z)


@pytest.mark.slow
def test_the_lathe_is_at_rest_when_it_was_said_to_be_and_the_program_completes_the_part() -> None:
    verdicts = Counter[str]()
    for seed in range(1, 1 + RUNS):
        kind = KINDS[seed % len(KINDS)]
        verdicts[f"{kind}: {one_run(seed, kind)}"] += 1
    print(dict(verdicts))
    assert verdicts[f"late: {DONE}"] and verdicts["sender: killed"], verdicts
    assert verdicts[f"cable: {FAILED}"] and verdicts[f"controller: {FAILED}"] and verdicts[f"stop: {STOPPED}"], verdicts


def one_run(seed: int, kind: str) -> str:
    """Run with one fault, judge it, and complete the part; return how the session ended."""
    random = Random(f"lathe {seed}")
    program, end_mm = program_of(random)
    at_s, link, told = random.uniform(1.0, 6.0), LatheLink(), []
    link.sender_killed_s = at_s if kind == "sender" else inf
    link.controller_killed_s = at_s if kind == "controller" else inf
    if kind == "late":
        link.starved_s = (at_s, at_s + random.uniform(0.1, 3.0))
    if kind == "spoiled":
        spoil(link, at_s)
    stop_s = {"stop": at_s, "spoiled": at_s + SEES_S}.get(kind, inf)
    asked: list[float] = []

    def during(time_s: float, sender: Sender) -> None:
        link.bench.judge.is_cut = link.bench.judge.is_cut or (kind == "cable" and time_s >= at_s)
        if time_s >= stop_s and not asked:
            asked.append(time_s)
            sender.stop()

    outcome: Outcome | None = None
    try:
        _, outcome = sent(program, told, during, link)
    except Killed:
        link.bench.board.close()  # what the controller's process does when its input closes
    where = f"seed {seed} ({kind}): {outcome.text if outcome else 'killed'}; {told}"
    left_s = check_rest(link, where)
    if outcome and outcome.kind == DONE:
        assert link.bench.judge.mm == pytest.approx(end_mm, abs=SAID_MM) or kind == "spoiled", where
        assert kind == "spoiled" or not link.bench.judge.faults, where
    elif outcome and left_s > 1.0:
        found = RUNS_ON.search(outcome.text)
        assert found and abs(float(found[1]) - left_s) < SAID_S, f"{where}; left {left_s}"
        assert not outcome.position_known, where
    again, second = sent(program, [])
    assert second.kind == DONE and again.bench.judge.mm == pytest.approx(end_mm, abs=SAID_MM), (where, second.text)
    return outcome.kind if outcome else "killed"


def spoil(link: LatheLink, at_s: float) -> None:
    """Let one byte of what is sent from a time on reach the lathe as another."""
    judge = link.bench.judge
    let_pass, spoiled = judge.write, []

    def write(data: bytes) -> None:
        if link.time_s >= at_s and not spoiled and (digits := re.search(rb"[0-9]", data)):
            spoiled.append(digits.start())
            data = data[: digits.start()] + b"7" + data[digits.end() :]
        let_pass(data)

    judge.write = write


def check_rest(link: LatheLink, where: str) -> float:
    """Assert that nothing moves any more once the lathe has done what it has; return how long it ran on, s."""
    bench = link.bench
    left_s = max(0.0, bench.judge.free_s - bench.time_s)
    is_alive = link.time_s < link.controller_killed_s
    bench.time_s += 0.0 if is_alive else left_s
    if is_alive:
        bench.wait(left_s + 0.1, 0.02)
    places, sent_bytes = list(bench.judge.places), bench.judge.sent
    if is_alive:
        bench.wait(5.0, 0.02)
    assert (bench.judge.places, bench.judge.sent) == (places, sent_bytes), where
    assert not bench.judge.moves_by_hand, where
    return left_s
