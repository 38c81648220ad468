# SPDX-License-Identifier: LGPL-2.1-or-later
"""A progress line for long work."""

from __future__ import annotations

import sys
import threading
import time
from types import TracebackType
from typing import TextIO

from CNCStepper import kernel_cache
from CNCStepper.cli.common.language import translated
from CNCStepper.errors import Text

PATIENCE_S = 1.0
AGAIN_S = 0.2
COMPILED_S = 5.0  # no kernel takes longer to be compiled
LOG_EVERY_S = 10.0  # where the stream is no terminal, such as a file or the log of a build


class Progress:
    """Prints the stage and the share of a verb on standard error: on a terminal one line, elsewhere now and then."""

    def __init__(self, doing: str, stream: TextIO | None = None, patience_s: float = PATIENCE_S):
        self._doing, self._share = doing, 0.0
        self._stream = stream or sys.stderr
        self._is_terminal = self._stream.isatty()
        self._patience_s = patience_s if self._is_terminal else max(patience_s, LOG_EVERY_S)
        self._over = threading.Event()
        self._begun_s, self._width = time.monotonic(), 0
        self._thread: threading.Thread | None = None

    def __enter__(self) -> Progress:
        self._thread = threading.Thread(target=self._show, daemon=True)
        self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._over.set()
        if self._thread:
            self._thread.join()
        if self._width:
            self._write("")
            self._stream.write("\r")
            self._stream.flush()

    def doing(self, what: str) -> None:
        """Print the stage that begins."""
        self._doing, self._share = what, 0.0

    def share(self, share: float) -> None:
        """Print the share that is done, from 0 to 1."""
        self._share = share

    def _show(self) -> None:
        wait_s = self._patience_s
        while not self._over.wait(wait_s):
            text = self._line()
            if self._is_terminal:
                self._write(translated(Text("{text} (Ctrl+C stops it)", text=text)))
            else:
                print(text, file=self._stream, flush=True)
            wait_s = AGAIN_S if self._is_terminal else LOG_EVERY_S

    def _line(self) -> str:
        """Return the stage, the share and the time, and why a first run takes so long."""
        share = f" {self._share:.0%}" if self._share else ""
        line = f"{translated(self._doing)}:{share} {time.monotonic() - self._begun_s:.0f} s"
        if kernel_cache.has_grown(COMPILED_S):
            line += ", " + translated(Text("compiling the kernels, once for this computer"))
        return line

    def _write(self, text: str) -> None:
        """Write the line over the one before."""
        self._stream.write("\r" + text.ljust(self._width))
        self._stream.flush()
        self._width = max(self._width, len(text))
