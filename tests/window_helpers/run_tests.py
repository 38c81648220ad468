# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs pytest inside FreeCAD's window: `freecad run_tests.py -M CHECKOUT`, started by start_window.py.

pytest has a thread of its own, so that the interface lives as it does for a person. At the end the documents and the
main window are closed as a person closes them; the tests' result goes into the file named by CNCSTEPPER_WINDOW_STATUS,
because FreeCAD's own exit status knows nothing of it.
"""

import os
import sys
import threading
import traceback
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
OPTIONS = [
    # Its look at other threads may crash Python 3.13, so it comes when all else has been in vain.
    *("-p", "no:cacheprovider", "-s", "-o", "faulthandler_timeout=600"),
    *("-W", "ignore:Type PySide2:DeprecationWarning"),  # FreeCAD 1.0's own
]
sys.path += [str(TESTS / "window"), str(TESTS)]  # conftest for a test that lies elsewhere, and the helpers
for name in os.environ.get("CNCSTEPPER_WINDOW_WITHOUT", "").split():
    sys.modules[name] = None  # Python then says that there is no such package


class ByThread:
    """Lets pytest write to the terminal while all other threads write where FreeCAD wants it: the report view."""

    def __init__(self, pytest_thread, terminal, freecad):
        self._pytest_thread, self._terminal, self._freecad = pytest_thread, terminal, freecad

    def _stream(self):
        return self._terminal if threading.current_thread() is self._pytest_thread else self._freecad

    def write(self, text):
        return self._stream().write(text)

    def flush(self):
        self._stream().flush()

    def __getattr__(self, name):
        return getattr(self._terminal, name)


def work(interface, keeper):
    """Run the tests, write their status, close FreeCAD; this is pytest's thread."""
    status = 3
    try:
        import pytest

        arguments = [part for part in os.environ["CNCSTEPPER_PYTEST"].split("\n") if part]
        status = int(pytest.main([*OPTIONS, *arguments]))
    except BaseException:
        traceback.print_exc(file=sys.__stderr__)
    finally:
        for terminal in (sys.__stdout__, sys.__stderr__):  # a FreeCAD that does not end in order loses the summary
            terminal.flush()
        interface.call(keeper.let_go)
        Path(os.environ["CNCSTEPPER_WINDOW_STATUS"]).write_text(str(status))
        interface.call(close)


def close():
    """Close FreeCAD a moment later, when no call of ours is under way."""
    from PySide import QtCore

    QtCore.QTimer.singleShot(0, close_now)


def close_now():
    """Close the documents and the main window."""
    import FreeCAD
    import FreeCADGui

    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    FreeCADGui.getMainWindow().close()


def paint_views_apart(area):
    """Give the area of the 3D views a window of its own within FreeCAD's.

    Where one window has both, Qt has OpenGL put all of it together whenever a label beside the view changes: 15 ms of
    the processor, a quarter of what a run costs. FreeCAD 1.1 lays panels over the view, which takes one window.
    """
    from PySide import QtCore

    area.setAttribute(QtCore.Qt.WidgetAttribute.WA_NativeWindow)
    area.winId()


def still_loads():
    """Tell whether the workbench is to load what its first panels need: Python 3.11 may hand a module half loaded to
    one thread where another loads it.
    """
    import FreeCADGui

    from window_helpers import window_kinds

    if window_kinds.AUTOLOAD not in os.environ and FreeCADGui.activeWorkbench().name() != "CNCStepperWorkbench":
        return True
    warmup = sys.modules.get("CNCStepper.workbench.calculation.import_warmup")
    return warmup is not None and not warmup.ended


def begin():
    """Start pytest's thread when FreeCAD is up and handles events, and the workbench has loaded."""
    import FreeCAD
    import FreeCADGui
    from PySide import QtCore, QtGui

    from window_helpers import interface

    if still_loads():
        QtCore.QTimer.singleShot(200, begin)
        return
    print("FreeCAD", ".".join(FreeCAD.Version()[:3]), "Python", sys.version.split()[0], file=sys.__stdout__, flush=True)
    FreeCADGui.getMainWindow().showMaximized()
    QtGui.QApplication.setCursorFlashTime(0)  # a cursor that blinks has the whole 3D view painted, by the processor
    if FreeCAD.Version()[:2] < ["1", "1"]:
        paint_views_apart(FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea))
    sys.argv = ["pytest"]
    link = interface.Interface()
    keeper = interface.Keeper((str(TESTS / "window"), str(TESTS / "window_helpers")), link)
    FreeCAD.__cncstepper_window__ = link, keeper
    thread = threading.Thread(target=work, args=(link, keeper), daemon=True)
    sys.stdout = ByThread(thread, sys.__stdout__, sys.stdout)
    sys.stderr = ByThread(thread, sys.__stderr__, sys.stderr)
    thread.start()


def start():
    """Wait for FreeCAD's event loop."""
    from PySide import QtCore

    QtCore.QTimer.singleShot(200, begin)


start()
