# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pattern with bounded tool engagement: its map, its kernels, its plan and its links."""
