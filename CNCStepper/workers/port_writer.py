# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that sends pulses: `... CNCStepper.workers.port_writer PORT WRITES_PER_S DATA CONTROL KEEP_NS TRIAL_S`.

DATA and CONTROL are the registers at rest, KEEP_NS as `pace` takes it. After the trial it says {"ready": {...}} or
{"error": {...}} on standard output; then it takes RECORDs from standard input, with times from the begin, and at their
end says {"done": {...}}. A closed terminal, Ctrl-C, Ctrl-Z, Ctrl-\\ and SIGTERM stop at once, as does a sender that
falls silent: axes that move fast lose their place. Whatever ends it is said when the port is at rest already; only
SIGKILL and SIGSTOP, which no process hears, leave the lines as they are.
"""

from __future__ import annotations

import gc
import json
import os
import select
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

from CNCStepper.control.pulses.pacing import HOME, Write, come_first, pace, require_rate, stall_ns
from CNCStepper.control.pulses.ports import RECORD, Port, is_parallel_port, open_port
from CNCStepper.control.session.status import error_to_json
from CNCStepper.errors import CNCStepperError, LinkError

BLOCK_BYTES = 1024 * RECORD.size
SILENT_S = 0.25
STOPS = ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT", "SIGTSTP", "SIGBREAK")
STOPPED = 130


def main(arguments: list[str]) -> int:
    """Send the pulses of standard input; return the exit status."""
    _on_message(_stop)
    try:
        port = open_port(Path(arguments[0]))
    except CNCStepperError as error:
        return _tell("error", error_to_json(error), 1)
    idle = (int(arguments[2]), int(arguments[3]))
    try:
        gc.disable()
        if is_parallel_port(Path(arguments[0])):  # a recording is not worth to hold up other work
            come_first()
        ended = ("done", _send(port, float(arguments[1]), idle, int(arguments[4]), float(arguments[5])), 0)
    except CNCStepperError as error:
        ended = ("error", error_to_json(error), 1)
    except KeyboardInterrupt:
        ended = ("stopped", {}, STOPPED)
    finally:
        try:
            _on_message(signal.SIG_IGN)
        finally:
            port.write(*idle)
            port.close()
    return _tell(*ended)


def _on_message(what: signal._HANDLER) -> None:
    for name in STOPS:
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), what)


def _stop(*_: object) -> None:
    """Stop the work, once: a second signal must not come between the first one and the port's rest."""
    _on_message(signal.SIG_IGN)
    raise KeyboardInterrupt


def _send(port: Port, writes_per_s: float, idle: tuple[int, int], keep_ns: int, trial_s: float) -> dict:
    trial = require_rate(port, writes_per_s, idle, keep_ns, trial_s)
    _tell("ready", trial.as_dict())
    return pace(_writes(sys.stdin.fileno()), port, keep_ns, stall_ns(writes_per_s)).as_dict()


def _writes(told: int) -> Iterator[Write]:
    """Yield what is to be written, as it comes."""
    left, block = b"", os.read(told, BLOCK_BYTES)  # the first one may take its time: all is at rest
    while block:
        block = left + block
        whole = len(block) - len(block) % RECORD.size
        yield from RECORD.iter_unpack(block[:whole])
        left, block = block[whole:], _block(told)


def _block(told: int) -> bytes:
    """Return what has come, b"" at its end; raises LinkError where nothing comes, for the beam may be on."""
    if hasattr(select, "poll"):  # where there are parallel ports
        waiting = select.poll()
        waiting.register(told, select.POLLIN)
        if not waiting.poll(SILENT_S * 1000):
            raise LinkError("pulses-late", "the pulses were stopped: no more of them came in time", advice=HOME)
    return os.read(told, BLOCK_BYTES)


def _tell(what: str, content: dict, status: int = 0) -> int:
    print(json.dumps({what: content}), flush=True)
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
