# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keeps this computer from falling asleep while a job runs; each system has its own way, none needs a package.

Linux     systemd-inhibit ... cat   a child that holds the lock until its standard input is closed,
macOS     caffeinate -i cat         which also happens when this process is killed
Windows   SetThreadExecutionState   of the thread that runs the job
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from CNCStepper.errors import Text

WHY = "a machine is cutting"
SETTLED_S = 0.2  # a child that is refused has ended by then
ENDED_S = 2.0
CONTINUOUS, SYSTEM_REQUIRED = 0x8000_0000, 0x0000_0001
KEEPERS = {
    "linux": ("systemd-inhibit", "--what=sleep:idle", "--who=CNCStepper", f"--why={WHY}", "--mode=block", "cat"),
    "darwin": ("caffeinate", "-i", "cat"),
}


@contextmanager
def inhibit_sleep(warn: Callable[[str], None], platform: str = sys.platform) -> Iterator[None]:
    """Keep the computer awake during a `with`; `warn` is called once when that fails."""
    keeper = KEEPERS.get(platform)
    if platform == "win32":
        with _inhibit_on_windows(warn):
            yield
    elif keeper:
        with _inhibit_by_child(keeper, warn):
            yield
    else:
        warn(_may_sleep(Text("not known on {platform}", platform=platform)))
        yield


@contextmanager
def _inhibit_by_child(keeper: tuple[str, ...], warn: Callable[[str], None]) -> Iterator[None]:
    try:
        child = subprocess.Popen(keeper, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    except OSError as error:
        warn(_may_sleep(f"{keeper[0]}: {error.strerror}"))
        yield
        return
    try:
        if _ends_within(child, SETTLED_S):
            warn(_may_sleep(Text("{keeper} was refused", keeper=keeper[0])))
        yield
    finally:
        assert child.stdin
        child.stdin.close()
        if not _ends_within(child, ENDED_S):
            child.kill()
            child.wait()


def _ends_within(child: subprocess.Popen, limit_s: float) -> bool:
    try:
        child.wait(limit_s)
    except subprocess.TimeoutExpired:
        return False
    return True


@contextmanager
def _inhibit_on_windows(warn: Callable[[str], None], kernel: Any = None) -> Iterator[None]:
    import ctypes

    kernel = kernel or ctypes.windll.kernel32  # type: ignore[attr-defined,unused-ignore]
    if not kernel.SetThreadExecutionState(CONTINUOUS | SYSTEM_REQUIRED):
        warn(_may_sleep("SetThreadExecutionState was refused"))
    try:
        yield
    finally:
        kernel.SetThreadExecutionState(CONTINUOUS)


def _may_sleep(why: str) -> str:
    return Text("this computer may fall asleep while the machine cuts ({why}): switch its sleep off", why=why)
