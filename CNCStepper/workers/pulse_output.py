# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process `... CNCStepper.workers.pulse_output` plays pulses; control/pulses/pulse_player_client.py starts it.

The first line of standard input says what it plays and where: {"ring", "port", "is_board", "signals", "axes",
"places_file"}. It answers {"ready": {}} or {"error": {...}}; everything else passes through the ring. At its end it
writes {"done": {}} or {"error": {...}}. Standard input that closes means that nobody plays any more: it brakes along
what is queued, switches everything off and ends. So does SIGTERM. Ctrl-C and Ctrl-Z are for the process that appends.
"""

from __future__ import annotations

import gc
import json
import os
import signal
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.control.pulses.output_ports import open_output
from CNCStepper.control.pulses.pacing import come_first, lock_memory, own_core
from CNCStepper.control.pulses.pulse_loop import PulseLoop, load_kernels
from CNCStepper.control.pulses.pulse_ring import BEGIN_NS, FAILED, STATE, PulseRing
from CNCStepper.control.session.status import error_to_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.wiring import Signals
from CNCStepper.motion.signals.parallel_port_registers import RegisterWriter
from CNCStepper.motion.signals.port_bytes import BoardWriter

IGNORED = ("SIGINT", "SIGHUP", "SIGQUIT", "SIGTSTP", "SIGBREAK")


def main() -> int:
    """Play what comes until the end; return the exit status."""
    for name in IGNORED:
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    wanted = json.loads(_line())
    ring = PulseRing.open(Path(wanted["ring"]))
    try:
        _play(wanted, ring)
    except CNCStepperError as error:
        ring.words[STATE] = FAILED
        return _tell("error", error_to_json(error), 1)
    return _tell("done", {})


def _play(wanted: dict[str, Any], ring: PulseRing) -> None:
    signals, is_board = Signals(**wanted["signals"]), bool(wanted["is_board"])
    board = BoardWriter(signals.motors, signals.null_motor) if is_board else None
    begin_ns = time.perf_counter_ns()
    ring.words[BEGIN_NS] = begin_ns
    places = Path(wanted["places_file"]) if wanted["places_file"] else None
    if board and places:
        _take_places(board, places)
    port = open_output(wanted["port"], is_board, begin_ns)
    try:
        writer = board or RegisterWriter(signals, wanted["axes"])
        for _, first, second in writer.off(0):  # until now the pins are as the computer's start or another program left
            port.write(first, second)
        loop = PulseLoop(ring, writer, port, begin_ns)
        load_kernels(writer)
        signal.signal(signal.SIGTERM, lambda *_: setattr(loop, "is_left", True))
        threading.Thread(target=_watch, args=(loop,), daemon=True).start()
        _settle(port.is_real)
        _tell("ready", {})
        loop.run()
    finally:
        port.close()
        if board and places:
            write_whole(places, json.dumps({"places": board.places}).encode("ascii"))


def _settle(is_real: bool) -> None:
    """Keep what would come between two pulses away: a recording is not worth to hold up other work for it."""
    gc.collect()
    gc.freeze()
    gc.disable()
    if is_real:
        come_first()
        own_core()
        lock_memory()


def _take_places(board: BoardWriter, path: Path) -> None:
    """Go on in the motors' sequences where the last job left them; a file of other motors is left out."""
    try:
        places = json.loads(path.read_bytes())["places"]
        if [type(place) for place in places] == [int] * len(board.places):
            board.places = places
    except (OSError, ValueError, KeyError, TypeError):
        return


def _line() -> bytes:
    """Read one line of standard input byte by byte: what is behind it is read by another thread."""
    line = b""
    while not line.endswith(b"\n") and (byte := os.read(0, 1)):
        line += byte
    return line


def _watch(loop: PulseLoop) -> None:
    """Tell the loop when nobody holds the other end of standard input any more."""
    while os.read(0, 1):
        pass
    loop.is_left = True


def _tell(what: str, content: dict[str, Any], status: int = 0) -> int:
    with suppress(OSError):  # nobody may read it any more
        os.write(1, json.dumps({what: content}).encode("ascii") + b"\n")
    return status


if __name__ == "__main__":
    sys.exit(main())
