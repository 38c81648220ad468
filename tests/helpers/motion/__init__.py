# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs for the planner, and recordings of firmware."""
