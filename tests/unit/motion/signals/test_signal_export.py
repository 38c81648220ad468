# SPDX-License-Identifier: LGPL-2.1-or-later
"""VCD and CSV: another's reader of each finds every edge, at its exact time."""

import csv
import io
from decimal import Decimal

import numpy as np
import pytest
from vcd.reader import TokenKind, tokenize

from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.wiring import Signals
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.signals.device_switching import Switch
from CNCStepper.motion.signals.parallel_port_registers import PortChunk
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream
from CNCStepper.motion.signals.signal_export import decimals_of, port_csv, position_csv, vcd
from CNCStepper.motion.signals.step_direction import Timeline

SECONDS = {"ns": Decimal("1e-9"), "ps": Decimal("1e-12")}


def read_vcd(dump):
    """Return the times in s (exact) and the levels of lines by name, as pyvcd reads a dump of IEEE 1364."""
    names, levels, rows, scale = {}, {}, [], None
    for token in tokenize(io.BytesIO(dump)):
        if token.kind is TokenKind.TIMESCALE:
            scale = token.timescale.magnitude * SECONDS[token.timescale.unit.value]
        elif token.kind is TokenKind.VAR:
            assert token.var.size == 1 and token.var.id_code not in names
            names[token.var.id_code] = token.var.reference
        elif token.kind is TokenKind.CHANGE_TIME:
            rows.append((token.time_change * scale, dict(levels)))
        elif token.kind is TokenKind.CHANGE_SCALAR:
            levels[names[token.scalar_change.id_code]] = int(token.scalar_change.value)
            if rows:
                rows[-1] = rows[-1][0], dict(levels)
    return rows


def random_stream(seed, ticks_per_s=TICKS_PER_S):
    rng = np.random.default_rng(seed)
    print("seed", seed)
    ticks = np.cumsum(rng.integers(1000, 9000, 300))
    step = rng.integers(1, 8, 300).astype(np.uint8)
    back = (step & rng.integers(0, 8, 300)).astype(np.uint8)
    switch = Switch(40, int(ticks[39]) + 300, "spindle_cw", True, 12000.0)
    chunks = [PulseChunk(ticks[:90], step[:90], back[:90], (switch,)), PulseChunk(ticks[90:], step[90:], back[90:])]
    return PulseStream(chunks, 3, ticks_per_s, (5, -3, 0))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_a_dump_holds_every_edge_at_its_time(seed):
    timeline = Timeline(random_stream(seed), Signals(motors=("x", "y", "z", "-y")))
    rows = read_vcd(b"".join(vcd(timeline)))
    edges = list(Timeline(random_stream(seed), Signals(motors=("x", "y", "z", "-y"))))
    ticks, levels = (np.concatenate([getattr(e, name) for e in edges]).tolist() for name in ("ticks", "levels"))
    assert [time for time, _ in rows] == [Decimal(tick) / TICKS_PER_S for tick in ticks]
    for (_, found), level in zip(rows, levels, strict=True):
        assert found == {name: level >> bit & 1 for bit, name in enumerate(timeline.lines)}


@pytest.mark.slow
def test_the_table_of_positions_tells_place_time_and_switches():
    stream = random_stream(1)
    text = b"".join(position_csv(stream)).decode("ascii")
    rows = list(csv.DictReader(io.StringIO(text)))
    pulses = [row for row in rows if not row["switch"]]
    position, expected = np.array(stream.begin_steps), []
    for chunk in stream:
        for tick, step, back in zip(chunk.ticks.tolist(), chunk.step.tolist(), chunk.back.tolist(), strict=True):
            position = position + [(step >> n & 1) - 2 * (back >> n & 1) for n in range(3)]
            expected.append((Decimal(tick) / TICKS_PER_S, *position.tolist()))
    assert [(Decimal(r["time_s"]), *(int(r[f"{a}_steps"]) for a in "xyz")) for r in pulses] == expected
    assert [(k, row["switch"]) for k, row in enumerate(rows) if row["switch"]] == [(40, "spindle_cw on 12000")]


def test_a_stream_without_a_clock_counts_its_rounds():
    text = b"".join(position_csv(random_stream(2, None))).decode("ascii")
    first = next(iter(random_stream(2))).ticks[0]
    assert text.splitlines()[1].startswith(f"{first},")


@pytest.mark.slow
def test_the_table_of_port_writes():
    chunk = PortChunk(np.array([0, 800]), np.array([0, 0xA5], np.uint8), np.array([0x0B, 0x03], np.uint8))
    text = b"".join(port_csv([chunk], TICKS_PER_S, 0x278)).decode("ascii")
    assert text == "time_s,0x278,0x27A\n0.0000000000,00,0B\n0.0000500000,A5,03\n"


@pytest.mark.parametrize(("clock", "decimals"), [(1_000_000, 9), (16_000_000, 10), (250, 9)])
def test_every_tick_is_told_exactly(clock, decimals):
    assert decimals_of(clock) == decimals


def test_a_clock_that_decimals_cannot_tell_is_refused():
    with pytest.raises(MachineRefusal, match="clock"):
        decimals_of(7407)
