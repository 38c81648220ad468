# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fast path through runs of plain lines: compiled kernels, the fast line, and when each one pays."""
