# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutting with a hot wire: all parts of a sheet in one continuous way from its edge."""
