# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nesting: parts on strips, sheets and remnants, with their holes used, and an exact judge of the result."""
