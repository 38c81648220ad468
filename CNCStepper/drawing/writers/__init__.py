# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writers of drawings: DXF and SVG."""
