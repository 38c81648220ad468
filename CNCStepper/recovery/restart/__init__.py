# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restart of a program in its middle: the place, the modal state there, the way in, the remaining lines, the proof."""
