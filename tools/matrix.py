# SPDX-License-Identifier: LGPL-2.1-or-later
"""`make matrix`: the tests inside FreeCAD 0.20.2, 1.0.0 and 1.1.3, without and with a window; run by .venv's Python.

What is asked for on the command line (versions) is all that runs, three runs on two cores: each waits part of its time
for machines, screens and answers. What each says is printed when it has ended, and stays in build/matrix. It goes on to
the end whatever fails. Tests in a window that failed beside another window are then run once more, alone, in a FreeCAD
of their own: a fault is there again, a shared core is not. At last a table says what failed, and a list what no test
has clicked in the system's FreeCAD. The exit status is 0 only when all of it passed and that list is empty. Where the
time is bounded (UNTIL_S) runs that would take longer are left out, the least that matter, and the table says which. The
system's FreeCAD is used where it is the version that is asked for, and runs too when it is none of them; the others are
set up once for all checkouts of a user (freecad_root.sh).
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import IO

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests"))
from window_helpers import touches  # noqa: E402

VERSIONS = ("0.20.2", "1.0.0", "1.1.3")  # from old to new: each opens the documents of those before it
BETWEEN = VERSIONS[1:-1]
# The files of a plain window: the road from a drawing to the machine, and where FreeCADs differ most. A FreeCAD
# between the oldest and the newest runs these alone: the rest says of it what its neighbours say, in twice the time.
ROAD = (
    "commands",
    "dock",
    "drawn_objects",
    "first_evening",
    "first_run",
    "install",
    "language",
    "lathe_sending",
    "panels",
    "preferences",
    "road",
)
SET_UP, DOCUMENTS, HEADLESS, TIMED, EMPTY_HOME = "set up", "documents", "headless", "timed", "empty home"
REST, MONKEY = "rest", "monkey"
KINDS = ("plain", REST, "scaled", "portuguese", "bare", TIMED, MONKEY)
NAMES = (DOCUMENTS, HEADLESS, EMPTY_HOME, *KINDS)  # the table's columns
DOCUMENT_TESTS = str(ROOT / "tests" / "freecad" / "test_documents.py")
# About, in three lanes of a machine of usual speed; what takes longest begins first.
SECONDS = {
    "plain": 300,
    REST: 600,
    MONKEY: 200,
    HEADLESS: 110,
    "scaled": 60,
    "portuguese": 110,
    EMPTY_HOME: 120,
    SET_UP: 60,
}
OTHERS_S = 10
AGAIN = ", alone"  # how what failed runs once more
HEADLESS_LIMIT_S = 1800  # the kernels are compiled in that time, too
LANES = min(4, 3 * (os.cpu_count() or 1) // 2)  # runs at a time
# When no run is begun any more that may be left out, and that would not have ended by then; in seconds since 1970.
UNTIL_S = float(os.environ.get("CNCSTEPPER_MATRIX_UNTIL_S", "inf"))
MAY_BE_LEFT_OUT = (REST, MONKEY, "scaled", "portuguese", "bare", EMPTY_HOME)
COMMA = {"LC_ALL": "pt_BR.UTF-8", "LOCPATH": str(ROOT / ".venv" / "locale")}  # which only this system has
LOGS = ROOT / "build" / "matrix"
Key = tuple[str, str]  # a version and what is run of it
Act = Callable[[IO[str]], bool]  # takes the file for what it says


@dataclass
class Row:
    """What became of one version: the answer to FreeCAD.Version(), then verdict and seconds of each run."""

    version: str
    told: str = ""
    results: dict[str, tuple[bool, float]] = field(default_factory=dict)
    left_out: set[str] = field(default_factory=set)

    @property
    def good(self) -> bool:
        """Whether all of it passed that was not left out for want of time."""
        ended = set(self.results) | self.left_out
        return bool(self.told) and ended >= wanted(self.version) and all(passed for passed, _ in self.results.values())

    def lasts_s(self, name: str) -> float:
        """Return how long a run is likely to take, by what those took that have ended."""
        took_s = sum(seconds for _, seconds in self.results.values())
        usual_s = sum(SECONDS.get(ended, OTHERS_S) for ended in self.results)
        return SECONDS.get(name, OTHERS_S) * (took_s / usual_s if usual_s else 1.0)


def main(versions: list[str]) -> int:
    """Set all up, run all, print the table; return 0 when all is well."""
    unknown = sorted(set(versions) - set(VERSIONS))
    if unknown:
        sys.exit(f"matrix: only {', '.join(VERSIONS)} are known, not {', '.join(unknown)}")
    at_system = system_version()
    chosen = [version for version in VERSIONS if version in versions] or with_system(at_system)
    rows = {version: Row(version) for version in chosen}
    shutil.rmtree(LOGS, ignore_errors=True)
    LOGS.mkdir(parents=True)
    with tempfile.TemporaryDirectory(prefix="cncstepper-documents-", dir="/tmp") as folder:
        acts = all_acts(rows, at_system, Path(folder))
        run_in_lanes(follows(chosen), lambda key: timed(rows[key[0]], key[1], acts[key]))
        for row in rows.values():
            run_failed_alone(row, "host" if row.version == at_system else row.version)
    print_table(list(rows.values()))
    row = rows.get(at_system)
    clicked = row is None or row.left_out or print_unclicked(row, touches.untouched(touches.files("host")))
    return 0 if clicked and all(row.good for row in rows.values()) else 1


def wanted(version: str) -> set[str]:
    """Return the runs of a version; walks at random are taken in the oldest alone, where they take the least time."""
    left = {REST} if version in BETWEEN else set()
    return set(NAMES) - left - (set() if version == VERSIONS[0] else {MONKEY})


def with_system(at_system: str) -> list[str]:
    """Return all versions from old to new, the system's among them: `make test matrix` leaves to us what we run."""
    known = {*VERSIONS, at_system} - {""}
    return sorted(known, key=lambda version: [int(number) for number in version.split(".")])


def follows(chosen: list[str]) -> dict[Key, tuple[Key, ...]]:
    """Return all runs, each with those that it waits for.

    Headless is first: that compiles the kernels, which the others then find. What opens the documents of an older
    FreeCAD (DOCUMENTS, and TIMED in the window) waits for those.
    """
    found: dict[Key, tuple[Key, ...]] = {}
    for place, version in enumerate(chosen):
        found[version, SET_UP] = ()
        found[version, HEADLESS] = ((version, SET_UP),)
        later = [name for name in (DOCUMENTS, EMPTY_HOME, *KINDS) if name in wanted(version)]
        found |= {(version, name): ((version, HEADLESS),) for name in later}
        if REST in later:  # how long it takes is known best from the road's files
            found[version, REST] = ((version, "plain"),)
        for before in chosen[max(0, place - 1) : place]:
            found[version, DOCUMENTS] += ((before, DOCUMENTS),)
            found[version, TIMED] += ((before, TIMED),)
    return found


def run_in_lanes(runs: dict[Key, tuple[Key, ...]], run: Callable[[Key], None], lanes: int = LANES) -> None:
    """Run all, so many at a time as there are lanes; what most others wait for the longest begins first."""
    waiting = sorted(runs, key=lambda key: -chain_s(key, runs))
    ended: set[Key] = set()
    running: dict[Future[None], Key] = {}
    with ThreadPoolExecutor(lanes) as pool:
        while waiting or running:
            ready = [key for key in waiting if ended.issuperset(runs[key])]
            for key in ready[: lanes - len(running)]:
                waiting.remove(key)
                running[pool.submit(run, key)] = key
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                ended.add(running.pop(future))
                future.result()


def chain_s(key: Key, runs: dict[Key, tuple[Key, ...]]) -> float:
    """Return about how long a run takes with the longest chain of those that wait for it."""
    later = [chain_s(other, runs) for other, before in runs.items() if key in before]
    return SECONDS.get(key[1], OTHERS_S) + max(later, default=0)


def set_up(row: Row, where: str, _log: IO[str]) -> bool:
    """Make one FreeCAD's folder, when it is not there yet, and ask for its version."""
    if where == "host" or made(row.version):
        row.told = told_version(where)
    return bool(row.told)


def made(version: str) -> bool:
    """Make one FreeCAD's folder, when it is not there yet."""
    return subprocess.run([str(ROOT / "tools" / "freecad_root.sh"), version]).returncode == 0


def freecadcmd(where: str, script: str, environment: dict[str, str]) -> list[str]:
    """Return the command that runs a script in headless FreeCAD, in its folder or in the system."""
    variables = [f"{name}={value}" for name, value in environment.items()]
    inside = [] if where == "host" else [str(ROOT / "tools" / "in_root.sh"), where]
    program = (shutil.which("freecadcmd") or "FreeCADCmd") if where == "host" else "freecadcmd"
    return [*inside, "/usr/bin/env", "LC_ALL=C.UTF-8", *variables, program, str(ROOT / script), "-M", str(ROOT)]


def told_version(where: str) -> str:
    """Return what FreeCAD.Version() says inside, for example "1.0.0 ['1', '0', '0', …]"; "" when it does not start."""
    with tempfile.TemporaryDirectory(dir="/tmp") as home:
        command = freecadcmd(where, "tools/print_version.py", {"FREECAD_USER_HOME": home})
        output = subprocess.run(command, capture_output=True, text=True, cwd=ROOT).stdout
    found = [line for line in output.splitlines() if line.startswith("FreeCAD.Version() ")]
    return found[0].removeprefix("FreeCAD.Version() ") if found else ""


def system_version() -> str:
    """Return the version of the system's FreeCAD, "" when there is none."""
    return told_version("host").partition(" ")[0] if shutil.which("freecadcmd") or shutil.which("FreeCADCmd") else ""


def all_acts(rows: dict[str, Row], at_system: str, folder: Path) -> dict[Key, Act]:
    """Return what each run does; `folder` is where the documents go from one FreeCAD to the next."""
    acts: dict[Key, Act] = {}
    for version in rows:
        where = "host" if version == at_system else version
        older = list(rows)[: list(rows).index(version)]
        acts[version, SET_UP] = partial(set_up, rows[version], where)
        given = documents(folder / "headless", older)
        acts[version, DOCUMENTS] = partial(headless, where, {**given, "CNCSTEPPER_PYTEST": DOCUMENT_TESTS})
        acts[version, HEADLESS] = partial(headless, where, {})
        acts[version, EMPTY_HOME] = partial(installed, where)
        given = documents(folder / "window", older)
        for kind in KINDS:
            acts[version, kind] = partial(window, where, kind, given, tests=chosen_files(kind))
    return acts


def chosen_files(kind: str) -> list[str]:
    """Return the files that a window runs, none for all that its kind has."""
    road = [f"tests/window/test_{name}.py" for name in ROAD]
    if kind == REST:
        every = sorted((ROOT / "tests" / "window").glob("test_*.py"))
        return [file for file in (path.relative_to(ROOT).as_posix() for path in every) if file not in road]
    return road if kind == "plain" else []


def installed(where: str, log: IO[str]) -> bool:
    """Install missing packages by the workbench's button, from an empty home."""
    script = ROOT / "tests" / "window_helpers" / "install_and_work.py"
    return (
        subprocess.run(
            [str(ROOT / ".venv" / "bin" / "python"), str(script), where], cwd=ROOT, stdout=log, stderr=log
        ).returncode
        == 0
    )


def documents(folder: Path, older: list[str]) -> dict[str, str]:
    """Return the variables for tests/helpers/freecad/whole_document.py."""
    folder.mkdir(exist_ok=True)
    return {"CNCSTEPPER_DOCUMENTS": str(folder), "CNCSTEPPER_OLDER": " ".join(older)}


def timed(row: Row, name: str, run: Act, how: str = "") -> None:
    """Put verdict and seconds of one run into the row; without its FreeCAD there is nothing to run."""
    if name != SET_UP and not row.told:
        return
    may_be_left_out = name in MAY_BE_LEFT_OUT or (name == "plain" and row.version in BETWEEN)
    if not how and may_be_left_out and time.time() + row.lasts_s(name) > UNTIL_S:
        print(f"matrix: FreeCAD {row.version}: {name} is left out: too little time is left for it", flush=True)
        row.left_out.add(name)
        return
    print(f"matrix: FreeCAD {row.version}: {name}{how} begins", flush=True)
    begun = time.monotonic()
    file = LOGS / f"{row.version}-{name}{how}.log".replace(" ", "-").replace(",", "")
    with file.open("w+", encoding="utf-8", errors="replace") as log:
        passed = run(log)
        log.seek(0)
        heading(f"FreeCAD {row.version}: {name}{how} {'passed' if passed else 'FAILED'}", log.read())
    if name != SET_UP:
        row.results[name] = (passed, time.monotonic() - begun)


def run_failed_alone(row: Row, where: str) -> None:
    """Run the tests of windows that failed once more, alone; a FreeCAD that crashed or hung has failed for good."""
    failed = [kind for kind, (passed, _) in row.results.items() if kind in KINDS and not passed]
    for kind in failed:
        if tests := failed_tests((LOGS / f"{row.version}-{kind}.log").read_text("utf-8", "replace")):
            before_s = row.results[kind][1]
            timed(row, kind, partial(window, where, kind, {}, tests=tests), AGAIN)
            row.results[kind] = row.results[kind][0], before_s + row.results[kind][1]


def failed_tests(log: str) -> list[str]:
    """Return the tests that pytest's summary names as failed; none where FreeCAD itself did wrong."""
    if re.search(r"^window: ", log, re.MULTILINE):
        return []
    return re.findall(r"^(?:FAILED|ERROR) (tests/window/\S+?::.+?)(?: - .*)?$", log, re.MULTILINE)


def headless(where: str, environment: dict[str, str], log: IO[str]) -> bool:
    """Run tests/freecad inside headless FreeCAD, in the system's under a locale with a decimal comma."""
    locale = COMMA if where == "host" else {}
    with tempfile.TemporaryDirectory(dir="/tmp") as home:
        command = freecadcmd(where, "tests/freecad/run.py", {"FREECAD_USER_HOME": home, **locale, **environment})
        try:
            run = subprocess.run(command, cwd=ROOT, timeout=HEADLESS_LIMIT_S, stdout=log, stderr=log)
            return run.returncode == 0
        except subprocess.TimeoutExpired:
            log.write(f"matrix: FreeCAD did not end within {HEADLESS_LIMIT_S} s\n")
            return False


def window(where: str, kind: str, environment: dict[str, str], log: IO[str], tests: Sequence[str] = ()) -> bool:
    """Run tests/window inside FreeCAD's window, all of that kind unless tests are named."""
    command = [str(ROOT / "tools" / "window.sh"), where, kind, *tests]
    variables = {**os.environ, **environment}
    return subprocess.run(command, cwd=ROOT, env=variables, stdout=log, stderr=log).returncode == 0


def print_unclicked(row: Row, left: Sequence[str]) -> bool:
    """Print each button, field and menu entry that a window has shown and no test has clicked.

    Return whether there is none; where a window failed, the list may have too much and does not count.
    """
    failed = [kind for kind in KINDS if kind in wanted(row.version) and not row.results.get(kind, (False, 0.0))[0]]
    why = [f"({', '.join(failed)} failed: clicks may be missing)"] if failed else []
    heading("without a click of a test", "".join(f"{line}\n" for line in (*why, *(left or ["nothing"]))))
    return bool(failed) or not left


def heading(text: str, below: str = "") -> None:
    """Print a heading and what stands below it, in one piece."""
    print(f"\n===== {text} =====\n{below}", end="", flush=True)


def cell(row: Row, name: str) -> str:
    """Return what the table says of one run."""
    if name in row.results:
        passed, seconds = row.results[name]
        return f"{'passed' if passed else 'FAILED'} {seconds:5.0f} s"
    if name not in wanted(row.version):
        return "-"
    return "LEFT OUT" if name in row.left_out else "NOT SET UP"


def print_table(rows: list[Row]) -> None:
    """Print what passed and what failed."""
    heading("result")
    print("FreeCAD".ljust(10) + "".join(name.rjust(16) for name in NAMES))
    for row in rows:
        print(row.version.ljust(10) + "".join(cell(row, name).rjust(16) for name in NAMES))
        print(f"{'':10}FreeCAD.Version() {row.told or 'told nothing'}")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
