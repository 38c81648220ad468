# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canned cycles in program text: drilling, tapping and boring, with their sticky words and repeats."""
