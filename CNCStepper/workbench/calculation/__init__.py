# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts calculated in a process beside the window, the cache of their results, and compiled kernels."""
