# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that reads a solid limits itself, before it loads anything of the person's; standard library only.

    limit_process    memory, processor time and size of files (POSIX)
    guard_script     ends the process when a script writes a file, starts a process or opens a connection
    answer, refuse   one line on standard output, ANSWER and JSON, which the starting process looks for

A script is the person's own and runs with the person's rights: the guard stops accidents, it is no prison.
"""

from __future__ import annotations

import json
import os
import sys
from typing import Any

ANSWER = "CNCSTEPPER-SOLID "
MEMORY_BYTES = 4_000_000_000
PROCESSOR_S = 120
FILE_BYTES = 100_000_000
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
REFUSED = {
    "subprocess.Popen": "it starts a program",
    "os.system": "it starts a program",
    "os.exec": "it starts a program",
    "os.posix_spawn": "it starts a program",
    "os.spawn": "it starts a program",
    "os.startfile": "it starts a program",
    "pty.spawn": "it starts a program",
    "os.fork": "it starts a process",
    "os.forkpty": "it starts a process",
    "socket.connect": "it opens a connection",
    "socket.bind": "it opens a connection",
    "socket.getaddrinfo": "it opens a connection",
    "socket.sendto": "it opens a connection",
    "os.remove": "it removes a file",
    "os.rmdir": "it removes a folder",
    "os.rename": "it renames a file",
    "os.mkdir": "it makes a folder",
    "os.link": "it makes a link",
    "os.symlink": "it makes a link",
    "os.truncate": "it writes a file",
    "os.chmod": "it changes a file",
    "shutil.rmtree": "it removes a folder",
}


def limit_process(file_bytes: int = FILE_BYTES) -> None:
    """Limit memory, processor time and the size of a written file, where the system can; Windows cannot."""
    try:
        import resource
    except ImportError:
        return
    for limit, most in (
        (resource.RLIMIT_AS, MEMORY_BYTES),
        (resource.RLIMIT_CPU, PROCESSOR_S),
        (resource.RLIMIT_FSIZE, file_bytes),
        (resource.RLIMIT_CORE, 0),
    ):
        hard = resource.getrlimit(limit)[1]
        lowest = most if hard == resource.RLIM_INFINITY else min(most, hard)
        try:
            resource.setrlimit(limit, (lowest, hard))
        except (OSError, ValueError):  # macOS takes none for memory; the starting process looks at it
            continue


def guard_script() -> None:
    """End this process with a reason when what runs from here on writes a file, starts a process or connects."""
    limit_process(file_bytes=0)
    if hasattr(os, "fork"):
        import signal

        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)  # of a write that Python does not see
    sys.addaudithook(_refuse_event)


def _refuse_event(event: str, arguments: tuple[Any, ...]) -> None:
    why = REFUSED.get(event, "")
    if event == "open" and isinstance(arguments[0], str | bytes):
        mode, flags = arguments[1], arguments[2] or 0
        if (isinstance(mode, str) and set(mode) & set("wax+")) or (mode is None and flags & WRITING):
            why = "it writes a file"
    if why:
        named = next((str(each) for each in arguments if isinstance(each, str | bytes | os.PathLike)), "")
        refuse("solid-script", f"{why}: {named[:200]}" if named else why)


def answer(content: dict[str, Any]) -> None:
    """Write the answer to standard output and end the process at once."""
    os.write(1, b"\n")
    data = (ANSWER + json.dumps(content) + "\n").encode("ascii")
    while data:
        data = data[os.write(1, data) :]
    os._exit(0)


def refuse(code: str, why: str) -> None:
    """Write why there is no answer, and end the process at once."""
    answer({"refused": [code, why]})
