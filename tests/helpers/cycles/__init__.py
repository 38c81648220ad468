# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random drawings for the cycles, and the judges of what a cycle cuts."""
