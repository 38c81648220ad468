# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of program text: words, the grammar of one line, expressions, and the place of an error."""
