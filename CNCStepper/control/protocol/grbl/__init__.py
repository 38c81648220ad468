# SPDX-License-Identifier: LGPL-2.1-or-later
"""The protocol of grbl 1.1, grblHAL and FluidNC: driver, reports, codes, handshake, timeouts."""
