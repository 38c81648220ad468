# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reader of DXF drawings."""
