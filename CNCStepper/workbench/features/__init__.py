# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document objects, one file each; documents store these class paths, so they stay where they are."""
