# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program in the editor: what is refused on which line, the editing verbs, and whether an edit may be written."""
