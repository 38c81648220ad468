# SPDX-License-Identifier: LGPL-2.1-or-later
"""A grbl 1.1h board without hardware.

server/grbl_server ── ports (pty, TCP)
   └── serial_line ── machine (the board) ─┬─ realtime, suspend, overrides
                                           ├─ serial_buffer ── system ($), gcode_block, gcode_execute
                                           │                    └── gcode_parser, gcode_checks, gcode_words
                                           ├─ axes (planner and steps), probe, homing, spindle_control
                                           └─ settings, eeprom, report, error_codes
"""
