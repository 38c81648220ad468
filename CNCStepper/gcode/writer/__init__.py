# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the table of moves as program text in one dialect."""
