# SPDX-License-Identifier: LGPL-2.1-or-later
"""The service's process: `python -m CNCStepper.workers.connection_service SERVICE_FILE PORT BAUD [MACHINE]`.

MACHINE is the profile, by name or file, of a machine without a controller of its own. The service lives as long as
somebody is attached or wants it kept, a job runs or something moves; SIGTERM stops all safely. How it ended
stands in its outcome file: {"error": ... or null}.
"""

from __future__ import annotations

import sys
import traceback
from functools import partial
from pathlib import Path

from CNCStepper.control.processes.process_file import unlink_with_retries
from CNCStepper.control.processes.sleep_inhibitor import inhibit_sleep
from CNCStepper.control.processes.thread_priority import go_first
from CNCStepper.control.service.connection_service import ConnectionService
from CNCStepper.control.service.port_owner import warn_of_closed
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.detached_process import stop_on_signals
from CNCStepper.control.session.files import OUTCOME, WIRE, ServiceFile, write_private
from CNCStepper.control.session.server import SessionServer
from CNCStepper.control.session.status import error_to_json
from CNCStepper.control.transport.port_identity import identify
from CNCStepper.errors import CNCStepperError, LinkError, Text
from CNCStepper.workers.sender import SWITCH_S


def main(arguments: list[str]) -> int:
    """Run the service of the file `arguments[0]`; return the exit status, 0 when it was left or stopped."""
    sys.setswitchinterval(SWITCH_S)
    go_first()
    path, port, baud = Path(arguments[0]), arguments[1], int(arguments[2])
    machine = "".join(arguments[3:4])
    service_file = ServiceFile(path)
    server = SessionServer(path, each_turn=service_file.keep)
    service = ConnectionService(
        port,
        baud,
        machine=machine,
        job_file=path.with_suffix(WIRE),
        tell=server.tell,
        refuse=server.refuse,
        ended=server.notify_outcome,
        alone_s=server.alone_s,
        journals=path.parent,
        kept=PositionTrustFile.of_port(path.parent, port),
        during_job=partial(inhibit_sleep, partial(server.tell, "warning")),
    )
    stop_on_signals(service.stop)
    service_file.write(server.address(port) | {"port_identity": identify(port).to_json(), "machine": machine})
    warn_of_closed(partial(server.tell, "warning"), path.parent)
    server.start(service)
    error = _run(service, service_file)
    try:
        write_private(path.with_suffix(OUTCOME), {"error": error_to_json(error) if error else None})
    finally:  # who listens gets the end, also where the disk takes nothing any more
        server.finish()
        unlink_with_retries(path.with_suffix(WIRE))
        service_file.remove()
    return 1 if error else 0


def _run(service: ConnectionService, service_file: ServiceFile) -> CNCStepperError | None:
    """Return the error that ended the service, if one did; a fault of this program goes to the log too."""
    try:
        if service_file.previous_service(service.port):
            raise LinkError(
                "port-busy",
                Text("{port} is in use by another window's connection", port=service.port),
                advice="attach to that one",
            )
        service.run()
    except CNCStepperError as error:
        return error
    except Exception:
        traceback.print_exc()
        what = "the connection service failed by a fault of its own"
        return CNCStepperError("service-fault", what, advice="see its log, report it")
    return None


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
