# SPDX-License-Identifier: LGPL-2.1-or-later
"""Text as curves: fonts of the system as outlines, single-line fonts for engraving, and their layout."""
