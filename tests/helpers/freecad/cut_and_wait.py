# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by a FreeCAD without a window: begin a cut through the workbench's own link, and wait for the end by force.

CNCSTEPPER_PORT: the machine. CNCSTEPPER_JOB: the file of the job. CNCSTEPPER_CUTTING: the file that appears once it is
cut.
"""

import os
import sys
import time
import traceback
from pathlib import Path

BEGUN = 5  # acknowledged lines
TURN_S = 0.02


def cut():
    """Let the job begin and say so; never comes back."""
    from CNCStepper.workbench.dock.connection import Link

    link = Link()
    link.open(os.environ["CNCSTEPPER_PORT"], 115_200)
    wait(link, lambda: link.moment.phase == "idle")
    link.command("set_zero", "XYZ")
    link.command("run", Path(os.environ["CNCSTEPPER_JOB"]), zero_confirmed=True)
    wait(link, lambda: link.moment.job and link.status.acknowledged > BEGUN)
    Path(os.environ["CNCSTEPPER_CUTTING"]).touch()
    wait(link, lambda: False)


def wait(link, reached):
    """Poll the link until something is reached."""
    while not reached():
        for event in link.poll():
            if event["event"] in ("refused", "warning"):
                print(event, flush=True)
        assert link.client, link.moment
        time.sleep(TURN_S)


try:
    cut()
except BaseException:
    traceback.print_exc()
finally:  # freecadcmd would run this script once more
    sys.stdout.flush()
    os._exit(1)
