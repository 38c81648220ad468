# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verbs that work out axes, feeds and speeds, and tool tables."""
