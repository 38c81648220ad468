# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material removal on tiles of heights: kernels, the height map, the part at any moment, and tool engagement."""
