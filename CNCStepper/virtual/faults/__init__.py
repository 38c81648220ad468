# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fault plans: timed faults of a virtual serial line, of a virtual controller, and of its surroundings."""
