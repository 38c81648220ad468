# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces and triangle meshes of the cut part and of tools."""
