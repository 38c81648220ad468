# SPDX-License-Identifier: LGPL-2.1-or-later
"""Templates of a shop: rules that make a job of a drawing."""
