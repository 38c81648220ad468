# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small orders, and workers that are interrupted."""
