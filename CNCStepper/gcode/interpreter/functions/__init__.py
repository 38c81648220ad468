# SPDX-License-Identifier: LGPL-2.1-or-later
"""Codes that do not cut: coordinate offsets, tools, spindle, inputs and outputs."""
