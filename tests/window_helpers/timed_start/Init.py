# SPDX-License-Identifier: LGPL-2.1-or-later
"""A workbench folder whose Init.py and InitGui.py run ours and measure what that costs FreeCAD's start."""

import importlib
import os
import sys
import time

import FreeCAD

sys.path.insert(0, os.environ["CNCSTEPPER_TIMED_ROOT"])
path = os.path.join(os.environ["CNCSTEPPER_TIMED_ROOT"], "Init.py")
begun = time.perf_counter(), time.thread_time()
with open(path, encoding="utf-8") as file:
    exec(compile(file.read(), path, "exec"))
FreeCAD.__cncstepper_init__ = time.perf_counter() - begun[0], time.thread_time() - begun[1]

# What loading modules costs here: on a slow machine, and with many folders to look through, ours take longer too.
OTHERS = ("colorsys", "graphlib", "netrc", "plistlib", "pyclbr", "rlcompleter", "sched", "tabnanny", "wave", "zipapp")
begun_s = time.thread_time()
for name in OTHERS:
    importlib.import_module(name)
FreeCAD.__cncstepper_others__ = time.thread_time() - begun_s
