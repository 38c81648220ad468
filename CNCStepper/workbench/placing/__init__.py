# SPDX-License-Identifier: LGPL-2.1-or-later
"""Things on sheets in the 3D view, dragged and turned with the mouse: parts of a nest, programs of an arrangement."""
