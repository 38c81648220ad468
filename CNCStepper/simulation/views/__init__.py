# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a program: views, depth map, path, paper sheet, and the colours they share."""
