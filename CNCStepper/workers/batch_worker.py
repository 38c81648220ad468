# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that runs tasks of an order: `python -m CNCStepper.workers.batch_worker`.

One task a line on standard input, one result a line on standard output, both JSON as `job/batch/local_workers.py`
writes them. When standard input is closed the process ends.
"""

from __future__ import annotations

import gc
import os
import sys

from CNCStepper.garbage import collection_paused
from CNCStepper.job.batch.local_workers import decoded, encoded


def main() -> int:
    """Answer what standard input asks; return the exit status."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints is no answer
    with collection_paused():  # a sixth of the time of these imports
        from CNCStepper.job.batch.batch_task import run_task
    gc.freeze()
    for line in sys.stdin.buffer:
        answers.write(encoded(run_task(decoded(line))))
        answers.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())
