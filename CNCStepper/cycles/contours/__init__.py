# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contours along drawn curves: sides, leads, tabs, dog-bones; and engraving."""
