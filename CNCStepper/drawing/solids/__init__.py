# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids as drawings: STL meshes, and what a process of its own finds in STEP, BREP, FCStd and scripts."""
