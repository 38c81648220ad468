# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD outlives the processes that it writes to."""

import os
import socket

import pytest


def test_writing_to_a_pipe_that_nobody_reads_is_an_error() -> None:
    read, write = os.pipe()
    os.close(read)
    with pytest.raises(BrokenPipeError):
        os.write(write, b"x")
    os.close(write)


def test_writing_to_a_connection_that_has_ended_is_an_error() -> None:
    here, there = socket.socketpair()
    there.close()
    with here, pytest.raises(BrokenPipeError):
        here.sendall(b"x")
