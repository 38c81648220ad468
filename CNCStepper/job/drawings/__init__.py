# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings of every format, those too that take a process of their own or the G-code interpreter."""
