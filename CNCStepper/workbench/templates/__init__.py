# SPDX-License-Identifier: LGPL-2.1-or-later
"""Templates of the shop in the window: rules that make a job of an imported drawing."""
