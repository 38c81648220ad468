# SPDX-License-Identifier: LGPL-2.1-or-later
"""A grbl 1.1h board without hardware.

server ── ports (pty, TCP)
   └── link (the serial line) ── machine (lines, bytes, time) ─┬─ realtime, suspend
                                                               ├─ system ($) ── homing
                                                               └─ gcode: execute ─┬─ parser, checks
                                                                                  └─ canned_cycles, probe_cycle
all of these change a board ─┬─ planner (axes and steps), probe, input_pins, spindle_control
                             ├─ overrides, suspend_state, tool_change, serial_buffer
                             └─ eeprom, settings, firmware, alarms_and_errors
and report tells of it
"""
