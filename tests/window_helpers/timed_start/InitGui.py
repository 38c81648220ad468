# SPDX-License-Identifier: LGPL-2.1-or-later
"""See Init.py."""

import os
import time

import FreeCAD

path = os.path.join(os.environ["CNCSTEPPER_TIMED_ROOT"], "InitGui.py")
begun = time.perf_counter(), time.thread_time()
with open(path, encoding="utf-8") as file:
    exec(compile(file.read(), path, "exec"))
FreeCAD.__cncstepper_init_gui__ = time.perf_counter() - begun[0], time.thread_time() - begun[1]
