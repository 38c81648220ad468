# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens a link without being deaf meanwhile: names are looked up and hosts called for seconds."""

from __future__ import annotations

import threading
from collections.abc import Callable

from CNCStepper.control.transport.link import Link

LOOK_EVERY_S = 0.02


def open_unless(stopped: Callable[[], bool], opener: Callable[[str, int], Link], port: str, baud: int) -> Link | None:
    """Return what `opener` returns, or raise what it raises; None as soon as `stopped` says so."""
    opening = _Opening(opener, port, baud)
    opening.thread.start()
    while not opening.done.wait(LOOK_EVERY_S):
        if stopped():
            opening.give_up()
            return None
    if opening.error:
        raise opening.error
    return opening.link


class _Opening:
    """The opening of one link, in a thread of its own."""

    def __init__(self, opener: Callable[[str, int], Link], port: str, baud: int):
        self.link: Link | None = None
        self.error: BaseException | None = None
        self.done = threading.Event()
        self.thread = threading.Thread(target=self._open, args=(opener, port, baud), name="open-link", daemon=True)
        self._lock = threading.Lock()
        self._given_up = False

    def give_up(self) -> None:
        """Close the link as soon as it is open: the caller waits no more."""
        with self._lock:
            self._given_up = True
            if self.link:
                self.link.close()

    def _open(self, opener: Callable[[str, int], Link], port: str, baud: int) -> None:
        try:
            link = opener(port, baud)
        except BaseException as error:  # raised where it is waited for
            self.error = error
        else:
            with self._lock:
                self.link = link
                if self._given_up:
                    link.close()
        self.done.set()
