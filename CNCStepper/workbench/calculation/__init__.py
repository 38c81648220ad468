# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts calculated in a background process, the cache of their results, and compiled kernels."""
