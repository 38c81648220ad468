# SPDX-License-Identifier: LGPL-2.1-or-later
"""A grbl 1.1h board without hardware.

server ── ports (pty, TCP)
   └── link (the serial line) ── machine (the board) ─┬─ realtime, suspension, overrides
                                                      ├─ line_reader ── system ($), execute (g-code)
                                                      │                    └── parser, checks, words
                                                      ├─ axes (planner and steps), probe, homing, spindle
                                                      └─ settings, memory, report, codes
"""
