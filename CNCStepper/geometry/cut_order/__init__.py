# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of cuts: inside before outside, then short rapids."""
