# SPDX-License-Identifier: LGPL-2.1-or-later
"""The published mini-lathe without hardware: its serial line, its records, its two motors and its spindle's encoder."""
