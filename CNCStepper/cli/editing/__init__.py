# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verbs that write a changed program: edit, compact, convert."""
