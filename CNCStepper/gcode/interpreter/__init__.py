# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads program text as a controller does and produces the table of moves."""
