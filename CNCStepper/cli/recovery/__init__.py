# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verbs after an interruption: restart, resume, and back along the path."""
