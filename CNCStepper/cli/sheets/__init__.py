# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verbs that bring many parts onto sheets."""
