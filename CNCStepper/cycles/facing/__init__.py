# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facing: the top of the stock or of drawn regions, made level."""
