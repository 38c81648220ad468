# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs tasks on the workers of a cluster of dask.distributed, in the place of processes on this computer.

What dask sends is pickles, and pickles are code: whoever reaches the scheduler runs programs on all its computers. So
a scheduler is asked over TLS, or on this computer itself; any other address is refused.
"""

from __future__ import annotations

import ipaddress
from collections.abc import Iterator, Sequence
from concurrent.futures import CancelledError
from itertools import islice
from pathlib import Path
from types import TracebackType
from typing import Any
from urllib.parse import urlsplit

from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.control.session.status import error_to_json
from CNCStepper.errors import CNCStepperError, JobError, LinkError, MissingPackage, Text
from CNCStepper.job.batch.batch_task import run_task

IN_FLIGHT = 200  # tasks that the scheduler holds at once, with their files
RETRIES = 8  # of a task whose worker is lost, each time on another one
CONNECT_S = 15.0
Task = dict[str, Any]
Result = dict[str, Any]


def require_safe(address: str, keys: Sequence[Path]) -> None:
    """Raise JobError for the address of a scheduler that others could reach without a key.

    keys: files of the authority, the certificate and its key, for tls://.
    """
    scheme, host = _scheme_and_host(address)
    if scheme == "tcp" and not _is_loopback(host):
        raise JobError(
            "cluster-open",
            "a scheduler on another computer is asked over TLS only: what it is sent and sends is code",
            value=address,
            limit="tcp:// of this computer, or tls://",
            advice="start scheduler and workers with TLS keys, and give tls:// with --tls-ca, --tls-cert and --tls-key",
        )
    if scheme == "tls" and len(keys) != 3:
        advice = "give --tls-ca, --tls-cert and --tls-key"
        raise JobError(
            "cluster-keys", "TLS takes an authority, a certificate and its key", value=address, advice=advice
        )


def _scheme_and_host(address: str) -> tuple[str, str]:
    """Return the two of an address that has a port too; raises JobError for any other text."""
    try:
        parts = urlsplit(address)
        if parts.scheme in ("tcp", "tls") and parts.hostname and parts.port:
            return parts.scheme, parts.hostname
    except ValueError:  # a port beyond 65535, a bracket that is not closed
        pass
    advice = "write tcp://127.0.0.1:8786, or tls://HOST:8786"
    raise JobError("cluster-address", "this is no address of a scheduler", value=address, advice=advice)


def _is_loopback(host: str) -> bool:
    try:
        return host == "localhost" or ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


class ClusterWorkers:
    """The workers of a scheduler; raises as `require_safe` does, and MissingPackage without dask.distributed."""

    def __init__(self, address: str, keys: Sequence[Path] = ()):
        require_safe(address, keys)
        self._address, self._keys = address, keys
        self._client: Any = None

    def __enter__(self) -> ClusterWorkers:
        distributed = _library()
        try:
            options: dict[str, Any] = {"security": _security(distributed, self._keys), "name": "cncstepper"}
            options |= {"timeout": CONNECT_S, "set_as_default": False}
            asked = in_background(lambda: distributed.Client(self._address, **options))
            self._client = asked.result(2.0 * CONNECT_S)  # a port that takes the call and never answers holds dask
        except (OSError, ValueError) as error:
            what = Text("no scheduler answers: {error}", error=str(error) or type(error).__name__)
            advice = "start one: dask scheduler --host 127.0.0.1, and dask worker for each core"
            raise LinkError("cluster-silent", what, value=self._address, advice=advice) from error
        self._require_worker()
        return self

    def _require_worker(self) -> None:
        """Wait for the first worker; raises LinkError where none comes."""
        try:
            self._client.wait_for_workers(1, timeout=CONNECT_S)
        except _library().TimeoutError as error:
            self._client.close()
            what, advice = "the scheduler has no workers", "start one for each core: dask worker ADDRESS"
            raise LinkError("cluster-empty", what, value=self._address, advice=advice) from error

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        if self._client is not None:
            self._client.close()

    def results(self, tasks: Sequence[Task]) -> Iterator[tuple[int, Result]]:
        """Yield the number of each task and its result, as they are done; raises LinkError for a lost scheduler."""
        waiting = iter(enumerate(tasks))
        numbers = {self._submitted(task): number for number, task in islice(waiting, IN_FLIGHT)}
        running = _library().as_completed(list(numbers), loop=self._client.loop)
        for future in running:
            result = self._result(future)
            for number, task in islice(waiting, 1):
                running.add(next_one := self._submitted(task))
                numbers[next_one] = number
            yield numbers.pop(future), result

    def _submitted(self, task: Task) -> Any:
        return self._client.submit(run_task, task, pure=False, retries=RETRIES)

    def _result(self, future: Any) -> Result:
        """Return a task's result; of a worker that cannot run it, or that was lost each time, the error."""
        try:
            result: Result = future.result()
        except CancelledError as error:  # by the client itself, of every task that waits
            what = "the connection to the scheduler is lost"
            advice = "start it again, and run the same command: what is done is not done again"
            raise LinkError("cluster-lost", what, value=self._address, advice=advice) from error
        except Exception as error:
            what = Text("the cluster gave no result: {kind}: {error}", kind=type(error).__name__, error=error)
            advice = "install CNCStepper on every worker, and look at the worker's log"
            return {"error": error_to_json(CNCStepperError("cluster-task", what, advice=advice))}
        return result


def _library() -> Any:
    try:
        import distributed
    except ImportError as error:
        advice = "install it: python -m pip install distributed"
        raise MissingPackage("cluster-package", "dask.distributed is not installed", advice=advice) from error
    return distributed


def _security(distributed: Any, keys: Sequence[Path]) -> Any:
    if not keys:
        return None
    authority, certificate, key = map(str, keys)
    return distributed.Security(
        tls_ca_file=authority, tls_client_cert=certificate, tls_client_key=key, require_encryption=True
    )
