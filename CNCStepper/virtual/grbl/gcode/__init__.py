# SPDX-License-Identifier: LGPL-2.1-or-later
"""The G-code of a grbl board: words, checks, execution."""
