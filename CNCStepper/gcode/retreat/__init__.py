# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back along the cut: where on its way a held machine stands, and the wire text that leads it back, forward and on."""
