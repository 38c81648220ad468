# SPDX-License-Identifier: LGPL-2.1-or-later
"""Controllers, benches of sender and board, and judges of a run."""
