# SPDX-License-Identifier: LGPL-2.1-or-later
"""Turning: facing, roughing, finishing, grooves, parting, holes on the axis."""
