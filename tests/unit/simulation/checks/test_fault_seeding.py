# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults planted at random into random programs are found at their lines; the programs without have no finding."""

from __future__ import annotations

import os
import random
from collections import Counter

import pytest

from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.read_back import read_back
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.finding import Finding
from helpers.simulation.seeded_programs import FAULTS, MACHINE, Fault, Program, clean_program, faults_of

CASES = int(os.environ.get("CNCSTEPPER_CASES", "0"))  # what `make soak` asks for
QUICK, MANY = 1, 60  # programs, those of each batch
BATCHES = max(2, CASES // MANY)
FAULTS_A_PROGRAM = 2
MOST_MISSED = 0.01  # of the faults of each run
SEED = int(os.environ.get("FAULT_SEED", "0")) or (1 if os.environ.get("CI") else random.SystemRandom().randrange(10**9))


def findings_of(program: Program) -> list[Finding]:
    wire = prepare(program.text, "grbl", "p.nc")
    path = read_back(wire, program.text, program.start, "grbl", "p.nc")
    return check(path, MACHINE, file="p.nc", stock=program.stock, tools=program.tools, removals=program.removals)


def is_found(fault: Fault) -> bool:
    return any(
        finding.severity == "error" and finding.code in fault.codes and finding.place.line in fault.lines
        for finding in findings_of(fault.program)
    )


def seeded(first: int, count: int, at_least: int) -> None:
    """Assert that no clean program has a finding, that enough faults are found, and that each kind comes often.

    Each program gets the faults that came least until then.
    """
    print(f"FAULT_SEED={SEED}")  # shown when it fails; with it in the environment the same programs come again
    alarms, missed, planted = [], [], Counter()
    for seed in range(first, first + count):
        clean = clean_program(seed)
        alarms += [f"seed {seed}: {finding}" for finding in findings_of(clean)]
        faults = sorted(faults_of(clean, seed), key=lambda fault: planted[fault.kind])
        for fault in faults[:FAULTS_A_PROGRAM]:
            planted[fault.kind] += 1
            if not is_found(fault):
                missed.append(f"seed {seed}: {fault.kind} at {sorted(fault.lines)[:5]}")
    total = sum(planted.values())
    print(f"{count} programs, {total} faults {dict(planted)}; false alarms: {len(alarms)}, missed: {len(missed)}")
    assert not alarms, "\n".join(alarms)
    assert len(missed) <= MOST_MISSED * total, "\n".join(missed)
    assert min(planted[kind] for kind in FAULTS) >= at_least


@pytest.mark.slow
def test_faults_in_a_few_programs_are_found():
    seeded(SEED, QUICK, at_least=0)


@pytest.mark.slow
@pytest.mark.parametrize("batch", range(BATCHES))
def test_faults_in_hundreds_of_programs_are_found(batch):
    seeded(SEED + QUICK + batch * MANY, MANY, at_least=MANY // 6)
