# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fits lines and arcs to parametric curves and points within a tolerance."""
