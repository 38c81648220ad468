# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of windows that tests run in; a test without `pytest.mark.window(KIND, ...)` runs in the plain one."""

VARIABLE = "CNCSTEPPER_WINDOW_KIND"
LANGUAGE = "CNCSTEPPER_WINDOW_LANGUAGE"  # as FreeCAD calls it
STYLE_SHEET = "CNCSTEPPER_WINDOW_STYLE_SHEET"  # of FreeCAD's own, in which it starts
WITHOUT = "CNCSTEPPER_WINDOW_WITHOUT"  # packages that FreeCAD's Python shall not find

READY = "ready"  # the file beside that of the tests' status which says that the first test can begin

AUTOLOAD = "CNCSTEPPER_WINDOW_AUTOLOAD"  # the workbench that FreeCAD opens at its start

DARK = "Dark-blue.qss"
RENAMED = {  # languages and style sheets, by the FreeCAD that renamed them
    "1.0.0": {DARK: "FreeCAD Dark.qss"},
    "1.1.3": {"Portuguese, Brazilian": "Portuguese (Brazilian)", DARK: "FreeCAD.qss"},
}

KINDS: dict[str, dict[str, str]] = {
    "plain": {},
    "rest": {},  # what `make matrix` runs apart of the plain kind: all but the road
    "scaled": {"QT_SCALE_FACTOR": "2"},
    "portuguese": {LANGUAGE: "Portuguese, Brazilian"},
    "bare": {WITHOUT: "numba serial shapely"},
    # Its start is measured: our Init.py and InitGui.py run through timed_start/. It is soon over, so it makes the
    # documents, for which newer FreeCADs of `make matrix` wait.
    "timed": {AUTOLOAD: "NoneWorkbench"},
    "monkey": {},
    "dark": {STYLE_SHEET: DARK},  # the tests of the plain kind in a dark theme, for their pictures
}
AS_PLAIN = ("dark", "rest")  # kinds that run the tests of the plain one
ON_DEMAND = ("dark",)  # kinds whose pictures are looked at: `make matrix` leaves them out
UNCOUNTED = (*ON_DEMAND, "monkey")  # kinds whose clicks prove nothing: those at random
