# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random orders of parts, and a judge of layouts that shares no code with the search."""
