# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts cut out of sheet by torch, laser, jet or knife: kerf, leads, pierces, rules and order."""
