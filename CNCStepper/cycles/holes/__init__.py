# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holes: drilling, helical bores, thread milling, and the patterns where holes are placed."""
