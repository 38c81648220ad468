# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many random cases a cycle is tried with: 25, or as many as `make soak` asks for. Fewer have no shares."""

import os

SEEDS = range(1, 1 + max(25, int(os.environ.get("CNCSTEPPER_CASES", "25"))))
