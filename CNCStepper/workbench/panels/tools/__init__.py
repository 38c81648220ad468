# SPDX-License-Identifier: LGPL-2.1-or-later
"""What panels show of tools: their words, the field that chooses one, the fields of one's shape."""
