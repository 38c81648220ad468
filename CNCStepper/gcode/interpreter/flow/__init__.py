# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order in which lines run: O-words, branches and loops, subprograms in files of their own."""
