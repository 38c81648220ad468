# SPDX-License-Identifier: LGPL-2.1-or-later
"""How an area is cleared at one level: the patterns, each from an `Area` to `Run`s; see pattern.py."""
