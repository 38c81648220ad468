# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of a connected machine before the first line of a program is sent."""
