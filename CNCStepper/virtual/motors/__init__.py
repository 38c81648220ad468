# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stepper motors of the virtual machines: when their pulses came, and where their rotors are."""
