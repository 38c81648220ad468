# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player's process at each kind of port, from its start to every end that it can have.

Decoders are the tests' own. Nothing depends on how quick the computer is, save that it does not stand for long.
"""

from __future__ import annotations

import csv
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.control.pulses import pulse_player_client
from CNCStepper.control.pulses.pulse_player_client import PulseOutput
from CNCStepper.errors import LinkError, MachineRefusal
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.motion.signals.parallel_port_registers import pin_levels
from CNCStepper.motion.signals.step_letters import read_letters
from helpers.control.virtual_player import decoded, machine, pulses

LIMIT_S = 60.0
IDLE = ("0", "11")  # pins 1, 14 and 17 are turned round
COILS = (0xA, 0x9, 0x5, 0x6)


def board() -> Machine:
    table = load_machine("table-a")
    signals = type(table.signals)(null_motor=1)
    return table.model_copy(update={"controller": "usb-board", "signals": signals})


def wait_for(output: PulseOutput, *states: str) -> None:
    end_s = time.monotonic() + LIMIT_S
    while output.state not in states:
        output.check()
        assert time.monotonic() < end_s, output.state
        time.sleep(0.005)


def rows_of(path: Path) -> list[list[str]]:
    with path.open(newline="") as file:
        return list(csv.reader(file))


@pytest.fixture
def launch() -> Iterator[Callable[..., PulseOutput]]:
    made: list[PulseOutput] = []

    def start(port: str, profile: Machine | None = None) -> PulseOutput:
        made.append(PulseOutput.launch(port, profile or machine()))
        return made[-1]

    yield start
    for output in made:
        output.close()


def letters(text: bytes) -> tuple[np.ndarray, np.ndarray]:
    chunk = next(iter(read_letters([text])))
    return chunk.step.copy(), chunk.back.copy()


def read_board(data: bytes) -> list[tuple[int, int]]:
    """Return (motor, +1 or -1) of each byte that turns one; a byte for the motor that is selected is no clock edge."""
    places, selected, moves = [-1] * 4, -1, []
    for byte in data:
        motor, coils = byte >> 4, byte & 15
        if motor != selected and coils:
            turn = (COILS.index(coils) - places[motor]) % 4
            assert turn in (1, 3), "a place in the sequence is left out"
            places[motor] = COILS.index(coils)
            moves.append((motor, 1 if turn == 1 else -1))
        selected = motor
    return moves


def test_a_recording_holds_every_write_with_its_time(tmp_path: Path, launch: Callable[..., PulseOutput]) -> None:
    output = launch(f"record:{tmp_path / 'port.csv'}")
    columns = list(pulses(400, 1000.0))
    columns[1] = np.arange(400, dtype=np.uint8) % 7 + 1
    columns[2] = columns[1] & (np.arange(400, dtype=np.uint8) % 5)
    output.append(*columns)
    wait_for(output, "idle")
    assert output.sent == 400 and output.jitter().writes >= 800
    output.close()
    head, *rows = rows_of(tmp_path / "port.csv")
    assert head == ["t_s", "data", "control"] and tuple(rows[-1][1:]) == IDLE
    assert tuple(rows[0][1:]) == IDLE, "what stood at the pins before is not switched off"
    found = decoded([(round(float(t) * 1e9), int(data), int(control), 1) for t, data, control in rows])
    assert [pulse.step for pulse in found] == columns[1].tolist()
    assert [pulse.back for pulse in found] == columns[2].tolist()
    assert (found[-1].ns - found[0].ns) / 1e9 > 0.39


def test_a_file_that_is_no_recording_is_not_written_over(tmp_path: Path) -> None:
    (tmp_path / "job.nc").write_bytes(b"G1 X1\n")
    with pytest.raises(LinkError, match="not written over"):
        PulseOutput.launch(f"record:{tmp_path / 'job.nc'}", machine())
    assert (tmp_path / "job.nc").read_bytes() == b"G1 X1\n"


@pytest.mark.parametrize("port", ["rfc2217://host:1", "socket://127.0.0.1:1", "/dev/null", "there-is-none"])
def test_a_port_that_cannot_be_had_is_said(port: str) -> None:
    with pytest.raises(LinkError, match="pulse-port"):
        PulseOutput.launch(port, machine())


def test_a_motor_without_a_pin_is_refused() -> None:
    with pytest.raises(MachineRefusal, match="z_step is on no pin"):
        PulseOutput.launch("record:none", machine(pins={"x_step": 2, "x_direction": 3, "y_step": 4, "y_direction": 5}))


def test_a_socket_gets_two_bytes_a_write_and_gives_the_status(launch: Callable[..., PulseOutput]) -> None:
    got = bytearray()
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve() -> None:
            with server.accept()[0] as connection:
                connection.sendall(bytes((0x80, 0x78)))  # the last one counts: 11 is turned round
                while data := connection.recv(4096):
                    got.extend(data)

        thread = threading.Thread(target=serve)
        thread.start()
        output = launch(f"socket://127.0.0.1:{server.getsockname()[1]}")
        output.append(*pulses(300, 2000.0, step=2))
        wait_for(output, "idle")
        assert output.inputs() == {10, 11, 12, 13, 15}
        output.close()
        thread.join(LIMIT_S)
    writes = [(n, got[n], got[n + 1], 1) for n in range(0, len(got), 2)]
    assert [pulse.step for pulse in decoded(writes)] == [2] * 300
    assert tuple(map(str, writes[-1][1:3])) == IDLE


def test_a_port_whose_other_end_closes_is_an_error(launch: Callable[..., PulseOutput]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        output = launch(f"socket://127.0.0.1:{server.getsockname()[1]}")
        server.accept()[0].close()
        with pytest.raises(LinkError, match=r"port-lost|is lost") as caught:
            wait_for(output, "never")
        assert caught.value.code == "port-lost" and output.state == "failed"
        with pytest.raises(LinkError, match="is lost"):
            output.check()


def test_the_published_letters_reach_a_board_as_published(tmp_path: Path, launch: Callable[..., PulseOutput]) -> None:
    output = launch(f"record:{tmp_path / 'board.csv'}", board())
    step, back = letters(b"AAAADD")
    output.append(pulses(6, 100.0)[0], step, back, *pulses(6, 100.0)[3:])
    wait_for(output, "idle")
    assert output.position_steps == (2, 0, 0)
    output.close()
    head, *rows = rows_of(tmp_path / "board.csv")
    assert head == ["t_s", "byte"]
    data = bytes(int(byte) for _, byte in rows)
    assert data.hex(" ").upper() == "0A 10 09 10 05 10 06 10 05 10 09"
    times = [float(t) for t, _ in rows]
    assert times[1] - times[0] > 0.009 > 0.005 > times[2] - times[1]


def test_a_board_makes_every_pulse_at_a_pseudo_terminal(launch: Callable[..., PulseOutput]) -> None:
    if not hasattr(os, "openpty"):
        assert os.name == "nt"
        return
    import pty
    import tty

    ours, theirs = pty.openpty()
    tty.setraw(theirs)
    got = bytearray()

    def read() -> None:
        try:
            while data := os.read(ours, 4096):
                got.extend(data)
        except OSError:  # nobody has the other end open any more
            return

    thread = threading.Thread(target=read, daemon=True)
    thread.start()
    dice = np.random.default_rng(4)
    step = dice.integers(1, 8, 300).astype(np.uint8)
    back = step & dice.integers(0, 8, 300).astype(np.uint8)
    output = launch(os.ttyname(theirs), board())
    columns = pulses(300, 1000.0)
    output.append(columns[0], step, back, *columns[3:])
    wait_for(output, "idle")
    with pytest.raises(MachineRefusal, match="no byte that switches flood"):
        output.switch("flood", True)
    output.close()
    os.close(theirs)
    thread.join(LIMIT_S)
    moves = read_board(bytes(got))
    for axis in range(3):
        wanted = [
            -1 if b >> axis & 1 else 1 for s, b in zip(step.tolist(), back.tolist(), strict=True) if s >> axis & 1
        ]
        assert [turn for motor, turn in moves if motor == axis] == wanted


def test_places_in_the_sequences_are_kept_from_job_to_job(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, launch: Callable[..., PulseOutput]
) -> None:
    monkeypatch.setattr(pulse_player_client, "places_file", lambda port: tmp_path / "board.places")
    sent = b""
    for number, text in enumerate((b"AAAB", b"ADB")):
        output = launch(f"record:{tmp_path / str(number)}", board())
        step, back = letters(text)
        columns = pulses(len(text), 500.0)
        output.append(columns[0], step, back, *columns[3:])
        wait_for(output, "idle")
        output.close()
        sent += bytes(int(byte) for _, byte in rows_of(tmp_path / str(number))[1:])
    assert read_board(sent) == [(0, 1), (0, 1), (0, 1), (1, 1), (0, 1), (0, -1), (1, 1)]


def test_a_trial_gives_the_jitter_and_moves_nothing(tmp_path: Path, launch: Callable[..., PulseOutput]) -> None:
    output = launch(f"record:{tmp_path / 'port.csv'}")
    told = output.trial(500.0, 0.2)
    assert told.writes == 2 * 101 and told.taken_s >= 0.2
    assert output.sent == 0 and output.state == "idle"
    output.close()
    assert {int(data) for _, data, _ in rows_of(tmp_path / "port.csv")[1:]} == {0}


def test_a_rate_that_no_computer_keeps_is_refused(tmp_path: Path, launch: Callable[..., PulseOutput]) -> None:
    output = launch(f"record:{tmp_path / 'port.csv'}")
    with pytest.raises(MachineRefusal, match="cannot keep the rate"):
        output.trial(5e6, 0.01)
    output.append(*pulses(10, 1000.0))
    with pytest.raises(ValueError, match="at rest only"):
        output.trial(100.0)
    wait_for(output, "idle")


def test_a_port_is_idle_as_soon_as_it_is_open(launch: Callable[..., PulseOutput]) -> None:
    """Relays and drives that are on when low are on at pins nobody has written."""
    wired = machine()
    pins = {name: -pin if "flood" in name else pin for name, pin in wired.signals.wired.items()}
    low = wired.model_copy(update={"signals": wired.signals.model_copy(update={"pins": pins})})
    with socket.create_server(("127.0.0.1", 0)) as server:
        launch(f"socket://127.0.0.1:{server.getsockname()[1]}", low)
        with server.accept()[0] as connection:
            connection.settimeout(LIMIT_S)
            first = connection.recv(2, socket.MSG_WAITALL)
    assert pin_levels(*first)[wired.signals.wired["flood"]] and tuple(map(str, first)) != IDLE


@pytest.mark.parametrize("port", ["record", "socket"])
def test_a_player_that_is_killed_leaves_nothing_on(
    port: str, tmp_path: Path, launch: Callable[..., PulseOutput]
) -> None:
    """The process that appends switches everything off in its stead."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        name = (
            f"record:{tmp_path / 'port.csv'}" if port == "record" else f"socket://127.0.0.1:{server.getsockname()[1]}"
        )
        output = launch(name)
        output.switch("spindle_cw", True)
        output.append(*pulses(100_000, 1000.0))
        while output.sent < 200:
            time.sleep(0.01)
        output._worker.kill()
        with pytest.raises(LinkError, match=r"has ended.*set it there") as caught:
            wait_for(output, "never")
        assert caught.value.code == "pulse-worker" and output.state == "failed"
        if port == "record":
            assert tuple(rows_of(tmp_path / "port.csv")[-1][1:]) == IDLE
        else:
            server.accept()[0].close()
            with server.accept()[0] as again:
                assert again.recv(10) == bytes(map(int, IDLE))


def test_a_player_that_is_killed_while_it_closes_leaves_nothing_on(
    tmp_path: Path, launch: Callable[..., PulseOutput], monkeypatch: pytest.MonkeyPatch
) -> None:
    output = launch(f"record:{tmp_path / 'port.csv'}")
    output.switch("spindle_cw", True)
    time.sleep(0.5)
    monkeypatch.setattr(output, "_command", lambda what: output._worker.kill())
    output.close()
    written = [tuple(row[1:]) for row in rows_of(tmp_path / "port.csv")[1:]]
    assert written[-1] == IDLE and set(written) != {IDLE}


PARENT = """
import sys, time
sys.path[:0] = {paths!r}
from helpers.control.virtual_player import machine, pulses
from CNCStepper.control.pulses.pulse_player_client import PulseOutput
output = PulseOutput.launch("record:" + {file!r}, machine())
output.switch("flood", True)
output.append(*pulses(100_000, 1000.0))
print(output._worker.pid, flush=True)
time.sleep(600)
"""


def test_a_player_whose_parent_is_killed_ends_with_everything_off(tmp_path: Path) -> None:
    paths = [str(Path(__file__).parents[3])]
    script = PARENT.format(paths=paths, file=str(tmp_path / "port.csv"))
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE) as parent:
        assert parent.stdout and int(parent.stdout.readline())
        time.sleep(0.3)
        parent.kill()
    end_s = time.monotonic() + LIMIT_S
    while len(rows := rows_of(tmp_path / "port.csv")) < 100 or tuple(rows[-1][1:]) != IDLE:  # idle from its begin on
        assert time.monotonic() < end_s
        time.sleep(0.05)


if hasattr(signal, "SIGSTOP"):

    def test_a_player_that_is_stopped_is_noticed_while_it_stands(
        tmp_path: Path, launch: Callable[..., PulseOutput], monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(pulse_player_client, "STILL_S", 0.7)
        output = launch(f"record:{tmp_path / 'port.csv'}")
        output.switch("spindle_cw", True)
        output.append(*pulses(100_000, 1000.0))
        while output.sent < 200:
            output.check()
            time.sleep(0.01)
        os.kill(output.process, signal.SIGSTOP)
        with pytest.raises(LinkError, match=r"was stopped.*set it there") as caught:
            wait_for(output, "never")
        assert caught.value.code == "pulse-worker" and output.state == "failed"
        assert 200 <= output.sent < 100_000
        with pytest.raises(ProcessLookupError):
            os.kill(output.process, 0)
        assert tuple(rows_of(tmp_path / "port.csv")[-1][1:]) == IDLE

    def test_a_player_that_was_stopped_for_long_says_that_it_was_late(launch: Callable[..., PulseOutput]) -> None:
        with socket.create_server(("127.0.0.1", 0)) as server:
            output = launch(f"socket://127.0.0.1:{server.getsockname()[1]}")
            with server.accept()[0] as connection:
                threading.Thread(target=_drain, args=(connection,), daemon=True).start()
                output.append(*pulses(100_000, 1000.0))
                time.sleep(0.2)
                os.kill(output._worker.pid, signal.SIGSTOP)
                time.sleep(0.6)
                os.kill(output._worker.pid, signal.SIGCONT)
                with pytest.raises(LinkError, match="late with a pulse") as caught:
                    wait_for(output, "never")
                assert caught.value.code == "pulses-late"


def _drain(connection: socket.socket) -> None:
    try:
        while connection.recv(4096):
            pass
    except OSError:
        return
