# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lathe codes: profiles, roughing and finishing (G70 to G72), and threading (G33, G76)."""
