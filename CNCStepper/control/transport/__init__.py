# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bytes to and from a controller over a serial port, a network socket or telnet, and the names of ports."""
