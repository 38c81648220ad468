# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutter radius compensation: its codes, the compensated path, and the queue of moves that it holds back."""
