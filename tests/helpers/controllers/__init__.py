# SPDX-License-Identifier: LGPL-2.1-or-later
"""A player of pulses in simulated time, and boards of our own that play to it."""
