# SPDX-License-Identifier: LGPL-2.1-or-later
"""QtPlasmaC's words as its documents have them: a reader that takes these and no others, and QtPlasmaC's own filter.

The reader shares nothing with the product. The filter (`qtplasmac_gcode`) is LinuxCNC's; what it asks of HAL, of Qt and
of the machine's settings is answered by stand-ins here.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

FILTER = Path("/usr/bin/qtplasmac_gcode")
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
AXES = rf"(?:[XYABCIJ]{NUMBER} ?)+"
DOCUMENTED = [
    r"M3 \$[012] S1",
    r"M5 \$(?:[012]|-1)",
    rf"M6[78] E3 Q{NUMBER}",
    r"M6[2345] P[123]",
    r"M190 P(?:-1|\d{1,6})",
    r"M66 P3 L3 Q[1-9]\d*",
    r"M52 P[01]",
    r"F#<_hal\[plasmac\.cut-feed-rate\]>",
    r"#<(?:holes)> ?= ?[01234]",
    r"#<(?:pierce-only|keep-z-motion|tube-cut)> ?= ?[01]",
    rf"#<(?:oclength|h_diameter|h_velocity)> ?= ?{NUMBER}",
    r"T[01] M6",
    r"G43 H0",
    rf"F{NUMBER}",
    rf"G4 P{NUMBER}",
    rf"(?:G2[01]|G64 P{NUMBER}|G17|G40|G49|G80|G9[04]|G91\.1|G92\.1|G97|G5[4-9]|\s)+",
    rf"(?:G[01] )?{AXES}(?:F{NUMBER})?",
    rf"G[23] {AXES}(?:P\d+)?(?:F{NUMBER})?",
    r"M[27890]|M30|M1",
]
WORDS = re.compile("|".join(f"(?:{one})" for one in DOCUMENTED))
COMMENT = re.compile(r"\([^()]*\)|;.*")
MATERIAL = re.compile(
    rf"\(o=0(?:, na=[^,()]+)?, ph={NUMBER}, pd={NUMBER}, ch={NUMBER}, fr={NUMBER}"
    rf"(?:, (?:kw|th|ca|cv|pe|gp|cm|jh|jd)={NUMBER})*\)"
)


def undocumented(text: str) -> list[str]:
    """Return the lines of a program that the documents of QtPlasmaC do not have."""
    found = []
    for line in text.splitlines():
        if line.startswith("(o="):
            found += [] if MATERIAL.fullmatch(line) else [line]
            continue
        words = " ".join(COMMENT.sub("", line).split())
        if words and not WORDS.fullmatch(words):
            found.append(line)
    return found


def out_of_order(text: str) -> list[str]:
    """Return what breaks the documents' order: a G0 before M3, no G4 behind it, M5 before G0, M190 and M66."""
    found, moved, runs, before = [], False, False, ""
    for line in (" ".join(COMMENT.sub("", one).split()) for one in text.splitlines()):
        if not line:
            continue
        if line.startswith("M3 "):
            found += [line] if not moved or runs else []
            runs = True
        elif line.startswith("M5"):
            runs, moved = False, False
        elif line.startswith("G0"):
            found += [line] if runs else []
            moved = True
        elif line.startswith("G4 ") and before.startswith("M3 "):
            found.append(line)
        if before.startswith("M190") and line != "M66 P3 L3 Q1":
            found.append(before)
        before = line
    return found


def with_numbers(text: str, feed: float) -> str:
    """Return a program with numbers in the place of M190 and #<_hal[...]>, which bare LinuxCNC does not know."""
    return re.sub(r"M190 P-?\d+", "", re.sub(r"#<_hal\[[^\]]*\]>", f"{feed:g}", text))


def filtered(text: str, folder: Path, materials: str = "", inch: bool = False) -> tuple[str, list[str]]:
    """Return what QtPlasmaC's own filter makes of a program, and the lines that it finds fault with."""
    for name, content in _STAND_INS.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content.replace("@FOLDER@", str(folder)), "ascii")
    (folder / "bin" / "halcmd").chmod(0o755)
    for name in ("machine_material.cfg", "machine.prefs"):
        (folder / name).write_text(
            materials if name.endswith("cfg") else "Cut feed rate = 4000\nKerf width = 1\n", "ascii"
        )
    (folder / "shown.txt").unlink(missing_ok=True)
    source = FILTER.read_text("utf-8").replace("/tmp/qtplasmac", str(folder / "temporary"))
    (folder / "filter.py").write_text(source, "utf-8")
    (folder / "temporary").mkdir(exist_ok=True)
    (folder / "program.ngc").write_text(text, "ascii")
    environment = {**os.environ, "PATH": f"{folder / 'bin'}:{os.environ['PATH']}", "INI_FILE_NAME": "machine.ini"}
    environment |= {"PYTHONPATH": str(folder / "modules"), "UNITS": "inch" if inch else "mm"}
    command = [sys.executable, "filter.py", str(folder / "program.ngc")]
    run = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=60)
    assert run.returncode == 0, run.stderr
    shown = folder / "shown.txt"
    return run.stdout, shown.read_text("utf-8").splitlines() if shown.exists() else []


_QT = """
class _Any:
    def __init__(self, *arguments, **words):
        self.clicked = self
    def __call__(self, *arguments, **words):
        return self
    def __getattr__(self, name):
        return _Any()
    def setText(self, text):
        open("@FOLDER@/shown.txt", "a").write(text)
"""
_STAND_INS = {
    "bin/halcmd": "#!/bin/sh\nprintf 0\n",
    "modules/linuxcnc.py": (
        "import os\n"
        "class ini:\n    def __init__(self, name): pass\n"
        "    def find(self, section, key):\n"
        "        units = os.environ['UNITS']\n"
        "        return {'DISPLAY': 'qtplasmac', 'MACHINE': 'machine', 'LINEAR_UNITS': units}[key]\n"
        "class command: pass\n"
    ),
    "modules/PyQt5/__init__.py": "",
    "modules/PyQt5/QtCore.py": _QT + "Qt = _Any()\n",
    "modules/PyQt5/QtGui.py": _QT + "QIcon = _Any\n",
    "modules/PyQt5/QtWidgets.py": _QT
    + "".join(
        f"{name} = _Any()\n"
        for name in (
            "QApplication",
            "QDialog",
            "QScrollArea",
            "QWidget",
            "QVBoxLayout",
            "QPushButton",
            "QStyle",
            "QFrame",
        )
    )
    + "QLabel = _Any\n",
}
