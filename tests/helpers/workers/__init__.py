# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judges of the processes that do work of their own."""
