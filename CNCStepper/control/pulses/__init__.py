# SPDX-License-Identifier: LGPL-2.1-or-later
"""Step pulses that this computer sends itself through a parallel port: pacing, ports, sender."""
