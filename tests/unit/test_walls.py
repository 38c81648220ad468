# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walls of the house: imports go downwards only and never in a circle; the core needs neither FreeCAD nor Unix."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Mapping
from pathlib import Path

import pytest

from CNCStepper import dependencies
from CNCStepper.workers.package_installer import pip_arguments
from helpers.imports import FREECAD, PACKAGE, QT, ROOT, imported, modules, package_of

FLOORS = [  # from the top; rooms on one line do not know each other
    {"workbench", "cli"},
    {"api"},
    {"workers"},
    {"recovery"},
    {"job"},
    {"controllers"},
    {"control", "virtual"},
    {"simulation"},
    {"motion"},
    {"gcode", "cycles", "drawing", "nesting"},
    {"toolpath"},
    {"geometry", "machine", "state", "canned_cycle_expansion"},
    {"output_files", "input_file", "quantities", "text_json"},
    {"errors", "units", "kernels", "atomic_file", "cancellation", "dependencies"},
    {"garbage", "kernel_cache", "safe_text", "tolerances", "word_pattern"},
]
FLOOR_OF = {room: floor for floor, rooms in enumerate(FLOORS) for room in rooms}

LINES = {"serial", "socket", "socketserver"}
NET = {
    "socket", "socketserver", "ssl", "http", "urllib.request", "urllib.error", "ftplib", "smtplib", "poplib", "imaplib",
    "telnetlib", "xmlrpc", "webbrowser", "requests", "httpx", "aiohttp", "urllib3", "websockets", "distributed",
    "PySide.QtNetwork", "PySide2.QtNetwork", "PySide6.QtNetwork", "PySide.QtWebEngineWidgets",
}  # fmt: skip
SENDERS = {  # beside control and virtual: what a person names the address of
    ("CNCStepper.job.batch.cluster_workers", "distributed"),
}
ADDRESSES = {  # all that is written in the code: names of XML's, which nobody calls, and words for a person
    "http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink", "http://www.w3.org/XML/1998/namespace",
    "http://www.inkscape.org/namespaces/inkscape", "http://ns.adobe.com/",
    "https://github.com/cncstepper/CNCStepper/issues", "http://name:password@host:port", "http://host:port", "http://",
}  # fmt: skip
UNIX = {"pty", "tty", "termios", "fcntl"}


def room_of(module: str) -> str:
    """Return the room of a module of ours, "" for the package itself."""
    return ([*module.split("."), ""])[1]


def faults(module: str, source: str, package: str) -> list[str]:
    """Return what in `source` breaks the first wall, one sentence each."""
    room, found = room_of(module), []
    for name, at_load in imported(source, package):
        top = name.partition(".")[0]
        if top == "CNCStepper" and room_of(name) in FLOOR_OF and not may_know(room, room_of(name)):
            found.append(f"{module} imports {name}: {room} may not know {room_of(name)}")
        elif top in QT | FREECAD and room != "workbench":
            found.append(f"{module} imports {name}: only the workbench may")
        elif top in LINES and room not in ("control", "virtual"):
            found.append(f"{module} imports {name}: only control and virtual may")
        elif top in UNIX and (at_load or room not in ("control", "virtual")):
            found.append(f"{module} imports {name}: only control and virtual may, inside a function")
        elif top == "numba" and room != "kernels":
            found.append(f"{module} imports {name}: only kernels may")
    return found


def may_know(room: str, other: str) -> bool:
    """Return whether `room` may import `other`."""
    if room == "virtual" and other == "gcode":
        return False  # it must be able to disagree with what the sender's side believes
    return room == other or (room in FLOOR_OF and FLOOR_OF[room] < FLOOR_OF[other])


def test_imports_go_downwards_only() -> None:
    found = [
        fault
        for module, path in modules().items()
        if module != "CNCStepper"  # the public names, of all rooms; test_python_page holds that it loads none of them
        for fault in faults(module, path.read_text("utf-8"), package_of(module, path))
    ]
    assert not found, "\n".join(found)


def test_every_room_has_a_floor() -> None:
    rooms = {room_of(module) for module in modules()} - {""}
    assert rooms <= set(FLOOR_OF), f"rooms without a floor: {sorted(rooms - set(FLOOR_OF))}"


@pytest.mark.parametrize(
    ("module", "statement"),
    [
        ("CNCStepper.geometry.curve", "from CNCStepper.toolpath import Toolpath"),
        ("CNCStepper.geometry.curve", "from CNCStepper import toolpath"),
        ("CNCStepper.geometry.curve", "from .. import toolpath"),
        ("CNCStepper.geometry.curve", "from ..machine.tool import Tool"),
        ("CNCStepper.gcode.writer.write", "def f():\n    from CNCStepper.cycles import form"),
        ("CNCStepper.control.service.sender", "import CNCStepper.virtual.grbl"),
        ("CNCStepper.virtual.grbl.serial_buffer", "from CNCStepper.gcode.dialects import dialect"),
        ("CNCStepper.motion.planner.plan", "import importlib\nimportlib.import_module('CNCStepper.simulation.stock')"),
        ("CNCStepper.motion.planner.plan", "import importlib\nimportlib.import_module(f'CNCStepper.cli.{verb}')"),
        ("CNCStepper.job.make", "import FreeCAD"),
        ("CNCStepper.cli.program.run", "from PySide2 import QtCore"),
        ("CNCStepper.simulation.checks.check_program", "import serial.tools.list_ports"),
        ("CNCStepper.virtual.server.ports", "import termios"),
        ("CNCStepper.motion.planner.plan", "def f():\n    import pty"),
        ("CNCStepper.gcode.syntax.line_grammar", "import numba"),
    ],
)
def test_the_wall_sees_a_planted_import(module: str, statement: str) -> None:
    assert faults(module, statement, module.rpartition(".")[0])


@pytest.mark.parametrize(
    ("module", "statement"),
    [
        ("CNCStepper.cli.main", "from CNCStepper import __version__"),
        ("CNCStepper.geometry.curve", "from CNCStepper.geometry.arc import Arc"),
        ("CNCStepper.virtual.server.ports", "def f():\n    import termios"),
        ("CNCStepper.workbench.api", "import FreeCAD"),
        ("CNCStepper.control.transport.link", "import serial"),
    ],
)
def test_the_wall_lets_the_allowed_through(module: str, statement: str) -> None:
    assert not faults(module, statement, module.rpartition(".")[0])


def graph(sources: Mapping[str, str], packages: Mapping[str, str]) -> dict[str, set[str]]:
    """Return which of the modules each one imports, wherever in its text: also for types, also inside functions."""
    found: dict[str, set[str]] = {}
    for module, source in sources.items():
        names = {name for name, _ in imported(source, packages[module])}
        others = sources.keys() - {module}  # its own name from its package is something else there
        found[module] = {name if name in others else name.rpartition(".")[0] for name in names} & others
    return found


def circles(knows: Mapping[str, set[str]]) -> list[list[str]]:
    """Return the circles, each with all modules that can be reached from each other, the largest first."""
    below = {module: reached(module, knows) for module in knows}
    rings = {frozenset(other for other in below[module] if module in below[other]) for module in knows}
    return sorted(map(sorted, rings - {frozenset()}), key=lambda ring: (-len(ring), ring))


def reached(module: str, knows: Mapping[str, set[str]]) -> set[str]:
    """Return all modules that a module knows, itself or by others; itself only where a way leads back."""
    found, waiting = set[str](), [module]
    while waiting:
        new = knows[waiting.pop()] - found
        found |= new
        waiting += new
    return found


def test_modules_do_not_know_each_other_in_circles() -> None:
    paths = {module: path for module, path in modules().items() if module != "CNCStepper"}  # as above
    sources = {module: path.read_text("utf-8") for module, path in paths.items()}
    rings = circles(graph(sources, {module: package_of(module, path) for module, path in paths.items()}))
    assert not rings, "\n".join(f"these know each other: {', '.join(ring)}" for ring in rings)


def planted(sources: dict[str, str]) -> list[list[str]]:
    """Return the circles of modules CNCStepper.room.NAME with these texts."""
    whole = {f"CNCStepper.room.{name}": source for name, source in sources.items()}
    return circles(graph(whole, dict.fromkeys(whole, "CNCStepper.room")))


@pytest.mark.parametrize(
    "back",
    [
        "from CNCStepper.room.up import Up",
        "from CNCStepper.room import up",
        "import CNCStepper.room.up",
        "from . import up",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from CNCStepper.room.up import Up",
        "def f():\n    from CNCStepper.room.up import Up",
        "class C:\n    def f(self):\n        import CNCStepper.room.up as up",
        "import importlib\nimportlib.import_module('CNCStepper.room.up')",
    ],
)
def test_a_planted_circle_is_found(back: str) -> None:
    down = "from CNCStepper.room.down import Down"
    assert planted({"up": down, "down": back}) == [["CNCStepper.room.down", "CNCStepper.room.up"]]
    over_a_third = {"up": "from CNCStepper.room.middle import f", "middle": down, "down": back, "beside": down}
    names = ["CNCStepper.room.down", "CNCStepper.room.middle", "CNCStepper.room.up"]
    assert planted(over_a_third) == [names]


def test_two_planted_circles_are_told_apart() -> None:
    sources = {"a": "from . import b", "b": "from . import a, c", "c": "from . import d, e", "d": "from . import c, e"}
    rings = planted(sources | {"e": ""})
    assert rings == [["CNCStepper.room.a", "CNCStepper.room.b"], ["CNCStepper.room.c", "CNCStepper.room.d"]]


def test_two_ways_down_are_no_circle() -> None:
    assert not planted({"a": "from . import b, c", "b": "from . import d", "c": "from . import d, b", "d": "import e"})


AS_ON_WINDOWS = """
import sys
for name in {blocked!r}:
    sys.modules[name] = None
"""


def run_as_on_windows(code: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run `code` in a Python that has neither FreeCAD, Qt nor the Unix terminal modules."""
    blocked = sorted(QT | FREECAD | UNIX)
    return subprocess.run(
        [sys.executable, "-c", AS_ON_WINDOWS.format(blocked=blocked) + code, *arguments],
        capture_output=True,
        text=True,
        cwd=ROOT,
        timeout=120,
    )


IMPORT_ALL = """
import importlib, traceback
failed = 0
for module in sys.argv[1:]:
    try:
        importlib.import_module(module)
    except Exception:
        failed += 1
        print("---", module)
        traceback.print_exc(limit=-2, file=sys.stdout)
sys.exit(min(failed, 1))
"""


def test_the_core_and_the_command_line_import_without_freecad_and_unix() -> None:
    core = [name for name in modules() if room_of(name) != "workbench" and not name.endswith("__main__")]
    result = run_as_on_windows(IMPORT_ALL, *core)
    assert result.returncode == 0, result.stdout + result.stderr


def test_the_second_wall_sees_a_unix_import() -> None:
    assert run_as_on_windows(IMPORT_ALL, "pty").returncode == 1


def test_the_command_line_answers_without_unix() -> None:
    result = run_as_on_windows("sys.argv[:] = ['cncstepper', '--help']\nfrom CNCStepper.cli.main import main\nmain()\n")
    assert result.returncode == 0, result.stderr
    assert "Usage: cncstepper" in result.stdout


FREECAD_START = """
import sys, types
gui = types.ModuleType("FreeCADGui")
gui.Workbench = object
gui.addLanguagePath = lambda folder: None
gui.updateLocale = lambda: None
gui.__unit_test__ = []
gui.addWorkbench = lambda workbench: print(workbench.MenuText, workbench.Icon, sep="\\n")
sys.modules["FreeCADGui"] = sys.modules["FreeCAD"] = gui
for name in ("Init.py", "InitGui.py"):  # FreeCAD runs their text inside a function: no __file__, locals apart
    exec(compile(open(name, encoding="utf-8").read(), name, "exec"), {"__name__": "__main__"}, {})
print(sorted({"numpy", "numba", "shapely", "matplotlib", "pydantic", "scipy", "serial"} & set(sys.modules)))
"""


def test_starting_freecad_loads_nothing_heavy() -> None:
    result = subprocess.run([sys.executable, "-c", FREECAD_START], capture_output=True, text=True, cwd=ROOT, timeout=60)
    assert result.returncode == 0, result.stderr
    name, icon, heavy = result.stdout.splitlines()
    assert name == "CNCStepper"
    assert Path(icon).is_file()
    assert heavy == "[]"


def callers(module: str, source: str, package: str) -> set[tuple[str, str]]:
    """Return what of the network `source` imports outside of the two rooms that talk to machines."""
    if room_of(module) in ("control", "virtual"):
        return set()
    names = {name for name, _ in imported(source, package)}
    return {(module, net) for net in NET for name in names if name == net or name.startswith(f"{net}.")}


def test_nothing_is_sent_anywhere() -> None:
    """Ports of machines aside, only orders over several computers use the network, and the installer's pip."""
    sources = {module: (path.read_text("utf-8"), package_of(module, path)) for module, path in modules().items()}
    sources |= {name: ((ROOT / name).read_text("utf-8"), "") for name in ("Init.py", "InitGui.py")}
    found = set().union(*(callers(module, *source) for module, source in sources.items()))
    assert found == SENDERS
    written = {
        address.rstrip(".,;")
        for text, _ in sources.values()
        for address in re.findall(r"\b(?:https?|ftps?|wss?)://[^\s\"'{}<>()]*", text)
    }
    assert written == ADDRESSES


@pytest.mark.parametrize(
    "statement",
    [
        "import urllib.request",
        "from urllib import request",
        "def f():\n    import http.client",
        "from PySide import QtNetwork",
        "import importlib\nimportlib.import_module('requests')",
    ],
)
def test_a_planted_call_is_found(statement: str) -> None:
    assert callers("CNCStepper.workbench.dock.window", statement, "CNCStepper.workbench.dock")


WITHOUT_A_PLACE = {  # pip's options that we give and that name no place
    "--no-input", "--disable-pip-version-check", "--progress-bar", "--no-warn-script-location", "--no-compile",
    "--retries", "--only-binary", "--constraint", "--target",
}  # fmt: skip


def test_pip_takes_its_own_index_and_only_after_a_click() -> None:
    arguments = pip_arguments(Path("target"), ["pyserial==3.5"], None)
    options = {word.partition("=")[0] for word in arguments if word.startswith("-")}
    assert options == WITHOUT_A_PLACE, "an option that is not in this list may name where packages come from"
    assert "--no-index" in pip_arguments(Path("target"), ["pyserial==3.5"], Path("wheels"))
    pins = dependencies.PINS.read_text("utf-8").splitlines()
    assert not [line for line in pins if line and not re.fullmatch(r"#.*|[\w.-]+==[\w.]+", line)], "no address in it"
    sources = {module: path.read_text("utf-8") for module, path in modules().items()}
    dialog = "CNCStepper.workbench.installation.dialog"
    assert [module for module, text in sources.items() if re.search(r"(?<!class )\bInstallation\(", text)] == [dialog]
    assert sources[dialog].count("self.install()") == 1, "install_from_index has it"
    assert sources[dialog].count("install_from_index") == 2, "its definition and its button"
    assert 'tr("Install"), self.install_from_index)' in sources[dialog]


MOST_MODULES = 25  # side by side in a folder


def test_no_folder_has_too_many_modules() -> None:
    counts = Counter(path.parent for path in PACKAGE.rglob("*.py") if path.name != "__init__.py")
    assert counts
    assert not {str(folder): count for folder, count in counts.items() if count > MOST_MODULES}


def unstable_sorts(source: str) -> list[int]:
    """Return the lines that call argsort without a stable kind: numpy's own order of ties depends on the processor."""
    calls = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)]
    return [call.lineno for call in calls if ast.unparse(call.func).endswith("argsort") and not _is_stable(call)]


def _is_stable(call: ast.Call) -> bool:
    """Return whether a call names a stable sort; numba knows one as mergesort only."""
    kinds = {ast.unparse(keyword.value) for keyword in call.keywords if keyword.arg in ("kind", "stable")}
    return bool(kinds & {"'stable'", "'mergesort'", "True"})


def test_every_machine_sorts_ties_alike() -> None:
    found = {module: unstable_sorts(path.read_text("utf-8")) for module, path in modules().items()}
    assert not {module: lines for module, lines in found.items() if lines}


@pytest.mark.parametrize("call", ["np.argsort(a)", "a.argsort()", "np.argsort(-a, kind='quicksort')[::-1].tolist()"])
def test_a_planted_unstable_sort_is_found(call: str) -> None:
    assert unstable_sorts(f"def f(a):\n    return {call}") == [2]
