# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair of drawings: what is wrong, with its place, and mending within limits."""
