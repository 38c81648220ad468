# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed meshes of known volume, and STL files of them."""
