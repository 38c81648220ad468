# SPDX-License-Identifier: LGPL-2.1-or-later
"""Converts a program from one dialect to another and judges whether the result does the same work."""
