# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs in their own language and files of letters, sent the whole way to a recorded port; and to virtual grbl."""

from __future__ import annotations

import csv
import os
import signal
import threading
import time
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import FAILED
from CNCStepper.control.transport.link import open_link
from CNCStepper.errors import MachineRefusal
from CNCStepper.job.letter_file import letter_job
from CNCStepper.job.make_certificate import peak_rate, send_job
from CNCStepper.job.wire_round_trip import wire_round_trip
from CNCStepper.machine.profile import load_machine
from CNCStepper.state import Start

FIGURE_11 = "G0\nX1.5 Y1\nG90\nX3.5\nX2.5 Y1.7\nX1.5 Y1\n"  # a tenth of the published size


def sent(job, profile: str, port: str):
    """Send a job to the controller of a profile and return its outcome."""
    job = replace(job, port=port, profile=profile, zero_confirmed=True)
    return Sender(job, opener=partial(open_link, machine=profile)).run()


def columns(path) -> list[list[str]]:
    with open(path, newline="") as file:
        return list(csv.reader(file))[1:]


@pytest.mark.slow
def test_thesis_program_goes_the_whole_way_to_the_port(tmp_path) -> None:
    machine = load_machine("thesis-table")
    wire, _, path = wire_round_trip(FIGURE_11, machine, machine.language(), "p.nc")
    job = send_job(wire, machine, "p.nc", path.start, machine.language())
    assert job.dialect.startswith("grbl") and job.retrace["dialect"] == job.dialect
    rate = peak_rate(job)
    assert 0 < rate < 3000.0, "the trial tries the rate of this program"
    outcome = sent(replace(job, pulses_per_s=rate), "thesis-table", f"record:{tmp_path / 'x.csv'}")
    assert outcome.done, outcome.text
    place, before = [0, 0], 0
    for _, data, _ in columns(tmp_path / "x.csv"):
        word = int(data, 0)
        for axis, step in enumerate((1, 4)):  # pins 2 and 4, directions on 3 and 5
            if word & step and not before & step:
                place[axis] += -1 if word & (step << 1) else 1
        before = word
    assert place == [60, 40], "X1.5 Y1 at 40 pulses/mm"


def job_of(program: str, **signals: float) -> SendJob:
    table = load_machine("thesis-table")
    machine = table.model_copy(update={"signals": table.signals.model_copy(update=signals)})
    wire, _, path = wire_round_trip(f"G21 G90 G17 G94\n{program}\nM2\n", machine, "grbl", "p.nc", Start.at_zero())
    return send_job(wire, machine, "p.nc", path.start, "grbl")


def test_the_rate_is_that_of_the_fastest_stretch() -> None:
    """1200 mm/min at 40 steps/mm are 800 pulses/s; two axes together share their moments."""
    assert peak_rate(job_of("G1 X2 F60\nG1 X40 F1200\nG1 X41 F60")) == pytest.approx(800, rel=0.02)
    assert peak_rate(job_of("G1 X30 Y30 F1200")) == pytest.approx(800 / 2**0.5, rel=0.03)
    assert peak_rate(job_of("G4 P1")) == 0.0


def test_pulses_that_the_signals_cannot_follow_are_refused_before_a_port_is_opened() -> None:
    """A pulse takes 4 ms here: 250 a second; the last move asks for 800."""
    slow = {"pulse_us": 2000.0, "gap_us": 2000.0}
    assert peak_rate(job_of("G1 X3 F100", **slow)) < 100
    with pytest.raises(MachineRefusal, match="faster than the signals"):
        peak_rate(job_of("G1 X3 F100\nG1 X30 F1200", **slow))


@pytest.mark.slow
def test_letters_go_the_whole_way_to_the_board(tmp_path) -> None:
    outcome = sent(letter_job("AAAADD\n", load_machine("usb-board")), "usb-board", f"record:{tmp_path / 'y.csv'}")
    assert outcome.done, outcome.text
    codes = [int(byte, 0) for _, byte in columns(tmp_path / "y.csv")]
    assert [code for code in codes if code != 0x10] == [0x0A, 0x09, 0x05, 0x06, 0x05, 0x09]


if hasattr(signal, "SIGSTOP") and Path("/proc/self/stat").exists():

    def players_of(process: int) -> list[int]:
        """Return the processes that play pulses for a controller that this process has started."""
        parents = {}
        for stat in Path("/proc").glob("[0-9]*/stat"):
            try:
                parents[int(stat.parent.name)] = int(stat.read_text().rpartition(")")[2].split()[1])
            except OSError:  # it has just ended
                continue
        return [pid for pid, parent in parents.items() if parents.get(parent) == process]

    @pytest.mark.slow
    def test_a_player_that_is_stopped_in_the_middle_of_a_job_ends_it_in_words(tmp_path) -> None:
        """The real way: sender, controller and player are three processes; the player is stopped by a signal."""
        recorded = tmp_path / "x.csv"

        def stop_the_player() -> None:
            while not recorded.exists() or recorded.stat().st_size < 10_000:
                time.sleep(0.02)
            for player in players_of(os.getpid()):
                os.kill(player, signal.SIGSTOP)

        threading.Thread(target=stop_the_player, daemon=True).start()
        table = load_machine("thesis-table")
        wire, _, path = wire_round_trip("G21 G90 G17 G94\nG1 X900 F1200\nM2\n", table, "grbl", "p.nc", Start.at_zero())
        outcome = sent(send_job(wire, table, "p.nc", path.start, "grbl"), "thesis-table", f"record:{recorded}")
        assert outcome.kind == FAILED and not outcome.position_known
        assert "was stopped or got no processor time" in outcome.text, outcome.text
        assert int(columns(recorded)[-1][1], 0) == 0, "no step line stays on"
