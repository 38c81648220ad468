# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verbs that make, check, time, simulate and print a program."""
