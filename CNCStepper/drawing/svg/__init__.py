# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reader of SVG drawings."""
