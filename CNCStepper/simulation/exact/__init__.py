# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact judge, without a grid: swept areas, gouges, remaining material, contact with stock."""
