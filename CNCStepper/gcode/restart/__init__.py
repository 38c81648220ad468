# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restarting a program in its middle: the place, the state there, the way in, and the rest of its own lines."""
