# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compiled reading of plain program text: kernels over its bytes, which know no grammar of their own."""
