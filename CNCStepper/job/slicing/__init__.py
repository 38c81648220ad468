# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids as stacks of sheets: sections, registration holes, marks, drawings and the picture of the stack."""
