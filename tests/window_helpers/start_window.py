# SPDX-License-Identifier: LGPL-2.1-or-later
"""Starts FreeCAD's window on a screen of its own and runs tests in it: `start_window.py 1.0.0 [KIND] [FILES]`.

KIND is one of window_kinds.py, plain unless said. The result is the tests' own; a FreeCAD that crashes, hangs, or
leaves a process behind has failed. Pictures come to build/window/VERSION.
"""

from __future__ import annotations

import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import uuid
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.append(str(HERE.parent))
from window_helpers import touches, window_kinds  # noqa: E402

MARK = "CNCSTEPPER_WINDOW_RUN"
READY_S = 600.0  # so long may FreeCAD take to open our workbench and to compile the kernels
LIMIT_S = float(os.environ.get("CNCSTEPPER_WINDOW_LIMIT_S", "2700"))  # then, a run that hangs; a slow one takes 1500
LEAVE_S = float(
    os.environ.get("CNCSTEPPER_WINDOW_LEAVE_S", "15")
)  # so long may our own processes take to end after FreeCAD did
# For pictures of docs/: FreeCAD's own cube, axes and background in its 3D view. The processor paints them in every
# frame, and frames are half of what a run costs.
AS_A_PERSON = "CNCSTEPPER_WINDOW_AS_A_PERSON" in os.environ
SCREEN = (1600, 1000)  # in Qt's pixels: with QT_SCALE_FACTOR=2 the screen has twice as many
XDG_FOLDERS = ("CONFIG_HOME", "DATA_HOME", "STATE_HOME", "RUNTIME_DIR")  # not the cache: compiled kernels stay there
USER_CFG = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp">
 <FCParamGroup Name="MainWindow"><FCParamGroup Name="DockWindows">
  <FCBool Name="Std_ComboView" Value="1"/>
  <FCBool Name="Std_ReportView" Value="1"/>
  <FCBool Name="Std_PythonView" Value="0"/>
 </FCParamGroup></FCParamGroup>
 <FCParamGroup Name="Preferences">
  <FCParamGroup Name="General">
    <FCText Name="AutoloadModule">{autoload}</FCText>
    <FCText Name="Language">{language}</FCText>
  </FCParamGroup>
  <FCParamGroup Name="MainWindow">{theme}</FCParamGroup>
  <FCParamGroup Name="View">
    <FCBool Name="ShowNaviCube" Value="{as_a_person}"/>
    <FCBool Name="CornerCoordSystem" Value="{as_a_person}"/>
    <FCBool Name="Gradient" Value="{as_a_person}"/>
    <FCBool Name="UseNavigationAnimations" Value="0"/>
  </FCParamGroup>
  <FCParamGroup Name="Mod"><FCParamGroup Name="Start">
    <FCBool Name="ShowOnStartup" Value="0"/>
    <FCBool Name="FirstStart2024" Value="0"/>
  </FCParamGroup><FCParamGroup Name="CNCStepper"><FCParamGroup Name="FirstSteps">
    <FCBool Name="Closed" Value="{knows_first_steps}"/>
  </FCParamGroup></FCParamGroup></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""

DARK_THEME = '<FCText Name="StyleSheet">{}</FCText><FCText Name="Theme">FreeCAD Dark</FCText>'


def program(name: str) -> str:
    """Return the path of a program of the system."""
    found = shutil.which(name)
    if not found:
        sys.exit(f"{name} is missing: run 'make setup', which installs it or names the way to get it")
    return found


@contextmanager
def screen(scale: float = 1.0) -> Iterator[str]:
    """A screen that nobody sees, with a window manager: gives the name for DISPLAY."""
    size = f"{round(scale * SCREEN[0])}x{round(scale * SCREEN[1])}x24"
    read, write = os.pipe()
    command = [program("Xvfb"), "-displayfd", str(write), "-screen", "0", size, "-nolisten", "tcp", "-noreset"]
    server = subprocess.Popen(command, pass_fds=[write], stderr=subprocess.PIPE)
    os.close(write)
    with os.fdopen(read) as number:
        name = ":" + number.readline().strip()
    if name == ":":
        sys.exit(f"Xvfb did not start: {server.communicate()[1].decode('utf-8', 'replace')}")
    command = [program("openbox"), "--sm-disable", "--config-file", str(HERE / "openbox.xml")]
    manager = subprocess.Popen(command, env={**os.environ, "DISPLAY": name}, stderr=subprocess.DEVNULL)
    try:
        yield name
    finally:
        for process in (manager, server):
            process.terminate()
            process.wait(10)


def freecad_command(version: str) -> list[str]:
    """Return the command that starts a FreeCAD: "host" or 0.20.2 is the system's, others are freecad_root.sh's."""
    if version in ("host", "0.20.2"):
        return [program("freecad")]
    return [str(ROOT / "tools" / "in_root.sh"), version, "freecad"]


def make_home(
    home: Path,
    language: str = "English",
    autoload: str = "CNCStepperWorkbench",
    style_sheet: str = "",
    knows_first_steps: bool = True,
) -> None:
    """Make a user's folder with which FreeCAD opens that workbench and asks nothing at its first start.

    style_sheet: the name of one of FreeCAD's own, "" for none. knows_first_steps: whether the card of the first steps
    was closed before.
    """
    for kind in XDG_FOLDERS:
        (home / kind.lower()).mkdir(mode=0o700, parents=True, exist_ok=True)
    theme = DARK_THEME.format(style_sheet) if style_sheet else ""
    settings = USER_CFG.format(
        language=language,
        autoload=autoload,
        as_a_person=int(AS_A_PERSON),
        theme=theme,
        knows_first_steps=int(knows_first_steps),
    )
    (home / "user.cfg").write_text(settings, encoding="utf-8")


def compile_package(version: str) -> None:
    """Write the package's byte code, as the first start of a FreeCAD does: what is timed are the others."""
    inside = [] if version in ("host", "0.20.2") else [str(ROOT / "tools" / "in_root.sh"), version]
    subprocess.run([*inside, "/usr/bin/python3", "-m", "compileall", "-q", str(ROOT / "CNCStepper")], check=True)


def start(
    version: str,
    display: str,
    home: Path,
    script: Path,
    environment: Mapping[str, str],
    mark: str,
    workbench: Path | None = ROOT,
    output: int | None = None,
) -> subprocess.Popen[bytes]:
    """Start FreeCAD with a script and a workbench's folder; options stand after the script (0.20).

    mark: what finds the processes that it starts.
    """
    variables = {
        **os.environ,
        "LC_ALL": "C.UTF-8",
        "LIBGL_ALWAYS_SOFTWARE": "1",
        "QT_QPA_PLATFORM": "xcb",
        "DISPLAY": display,
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",  # a plugin's entry may be ours while FreeCAD's older package wins
        "FREECAD_USER_HOME": str(home),
        **{f"XDG_{kind}": str(home / kind.lower()) for kind in XDG_FOLDERS},
        MARK: mark,
        **environment,
    }
    options = ["-M", str(workbench)] if workbench else []
    return subprocess.Popen(
        [*freecad_command(version), str(script), *options], env=variables, stdout=output, stderr=output
    )


def marked(mark: str) -> dict[int, str]:
    """Return the processes that run with our mark: their number and command line."""
    found = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if f"{MARK}={mark}".encode() in (folder / "environ").read_bytes().split(b"\0"):
                words = (folder / "cmdline").read_bytes().replace(b"\0", b" ")
                state = (folder / "stat").read_text("utf-8", "replace").rpartition(")")[2].split()[0]
                if state != "Z":
                    found[int(folder.name)] = words.decode("utf-8", "replace").strip()
        except OSError:
            continue
    return found


def wait_until_gone(mark: str, seconds: float) -> dict[int, str]:
    """Return the marked processes that are still there after that time."""
    until_s = time.monotonic() + seconds
    while (left := marked(mark)) and time.monotonic() < until_s:
        time.sleep(0.1)
    return left


def end_all(mark: str) -> None:
    """Kill the marked processes."""
    for number in marked(mark):
        try:
            os.kill(number, signal.SIGKILL)
        except ProcessLookupError:
            continue


def pictures_of(version: str, kind: str) -> Path:
    """Return the folder for the pictures of a run and for what its tests touched."""
    return touches.PICTURES / (version if kind == "plain" else f"{version}-{kind}")


def run(version: str, kind: str, arguments: Sequence[str], environment: Mapping[str, str]) -> int:
    """Run pytest with these arguments in a FreeCAD's window of that kind; return 0 when all is well."""
    pictures = pictures_of(version, kind)
    pictures.mkdir(parents=True, exist_ok=True)
    mark = uuid.uuid4().hex
    environment = {window_kinds.VARIABLE: kind, **window_kinds.KINDS[kind], **environment}
    asked = {**os.environ, **environment}
    scale = float(asked.get("QT_SCALE_FACTOR", "1"))
    with (
        tempfile.TemporaryDirectory(prefix="cncstepper-window-", ignore_cleanup_errors=True) as folder,
        screen(scale) as display,
    ):
        status_file = Path(folder) / "status"
        autoload = asked.get(window_kinds.AUTOLOAD, "CNCStepperWorkbench")
        language, style_sheet = (
            window_kinds.RENAMED.get(version, {}).get(name, name)
            for name in (asked.get(window_kinds.LANGUAGE, "English"), asked.get(window_kinds.STYLE_SHEET, ""))
        )
        make_home(Path(folder) / "home", language, autoload, style_sheet)
        variables = {
            "CNCSTEPPER_PYTEST": "\n".join(arguments),
            "CNCSTEPPER_WINDOW_STATUS": str(status_file),
            "CNCSTEPPER_WINDOW_PICTURES": str(pictures),
            **environment,
        }
        workbench = ROOT
        if kind == "timed":
            compile_package(version)
            workbench, variables["CNCSTEPPER_TIMED_ROOT"] = HERE / "timed_start", str(ROOT)
        freecad = start(version, display, Path(folder) / "home", HERE / "run_tests.py", variables, mark, workbench)
        try:
            return judged(freecad, status_file, mark)
        finally:
            end_all(mark)


def judged(freecad: subprocess.Popen[bytes], status_file: Path, mark: str) -> int:
    """Wait for FreeCAD and return the tests' status, or 1 with a sentence when FreeCAD itself did wrong."""
    ended = wait_until_ended(freecad, status_file.with_name(window_kinds.READY))
    if ended is None:
        return fault(f"FreeCAD still runs after {LIMIT_S:.0f} s" + (" though the tests ended" * status_file.exists()))
    left = wait_until_gone(mark, LEAVE_S)
    if not status_file.exists():
        return fault(f"FreeCAD ended before the tests did (exit status {ended})")
    if left:
        return fault("processes were left behind:\n" + "\n".join(f"  {n}: {words}" for n, words in left.items()))
    if ended:
        return fault(f"FreeCAD ended with exit status {ended}")
    return int(status_file.read_text("ascii"))


def wait_until_ended(freecad: subprocess.Popen[bytes], ready_file: Path) -> int | None:
    """Return FreeCAD's exit status, None when it still runs LIMIT_S after its window was ready for the first test."""
    is_ready, until_s = False, time.monotonic() + READY_S
    while (ended := freecad.poll()) is None and time.monotonic() < until_s:
        if not is_ready and ready_file.exists():
            is_ready, until_s = True, time.monotonic() + LIMIT_S
        time.sleep(0.1)
    return ended


def print_times(begun_s: float) -> None:
    """Print what passed since then, and the processor time of screen, FreeCAD and the processes that it waited for."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    passed_s, used_s = time.monotonic() - begun_s, used.ru_utime + used.ru_stime
    print(f"it took {passed_s:.0f} s, {used_s:.0f} s of processor time", flush=True)


def fault(sentence: str) -> int:
    """Say what FreeCAD did wrong."""
    print(f"window: {sentence}", file=sys.stderr, flush=True)
    return 1


if __name__ == "__main__":
    version, *words = sys.argv[1:]
    kind = words.pop(0) if words and words[0] in window_kinds.KINDS else "plain"
    if not any(Path(word.partition("::")[0]).exists() for word in words):
        words.append(str(ROOT / "tests" / "window"))
        (pictures_of(version, kind) / touches.FILE).unlink(missing_ok=True)
    begun_s = time.monotonic()
    status = run(version, kind, words, {})
    print_times(begun_s)
    sys.exit(status)
