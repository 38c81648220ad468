# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mini-lathe's controller of our own: grbl's protocol towards the sender, the lathe's bytes outward.

    board (lines, real-time bytes, status) ──► manual   (A to H, I, P: jogs, held for their time)
                                          `──► program  (Y, then records in "?"-ended chunks) ◄── records, step_times
    both ──► outward_line ──► control/protocol/lathe/serial_port.py

The lathe answers nothing. Its position is reckoned from what was sent and from its published waits.
"""
