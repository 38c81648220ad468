# SPDX-License-Identifier: LGPL-2.1-or-later
"""The run of a program over an open connection: feeder, phases, pauses, overrides, path watch and path retract."""
