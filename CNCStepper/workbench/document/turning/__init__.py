# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lathe in a document: its job as the core has it, its job files, profiles and first values."""
