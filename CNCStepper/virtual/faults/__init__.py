# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fault plans: what goes wrong on a virtual serial line, in a virtual controller and around it, and when."""
