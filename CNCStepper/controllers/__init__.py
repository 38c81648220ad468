# SPDX-License-Identifier: LGPL-2.1-or-later
"""Controllers of our own: grbl's protocol towards the sender, pulses towards a machine that has no controller.

workers/controller.py ── families ──► pulse_board (lines, bytes, wall-clock time) ─┬─ machine_test_lines ($T $L $P $N)
                                            │                                      └─ port_signals (relays, inputs)
                                      pulse_axes (what is played, hold, resume, reset)
                                            │
       motion/interpolation/  planner_moves (grbl's planner) or dda_moves (the thesis's interpolators)
"""
