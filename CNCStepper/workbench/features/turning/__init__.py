# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document objects of a lathe: job, tools, profiles and operations."""
