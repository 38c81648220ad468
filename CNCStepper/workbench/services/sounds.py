# SPDX-License-Identifier: LGPL-2.1-or-later
"""Short sounds for events that a person should notice; tools/sounds.py writes them.

Qt plays them where its multimedia module is installed; elsewhere the computer beeps.
"""

from __future__ import annotations

import importlib
from contextlib import suppress
from typing import Any

from CNCStepper.workbench import packages

FOLDER = packages.ROOT / "resources" / "sounds"
ALARM, END, PAUSE, BEYOND = "alarm", "end", "pause", "beyond"
NAMES = (ALARM, END, PAUSE, BEYOND)
MODULES = ("PySide6.QtMultimedia", "PySide2.QtMultimedia")
_players: dict[str, Any] = {}


def play(name: str) -> None:
    """Play a sound of `NAMES`, and return at once."""
    from PySide import QtGui

    if name not in _players:
        _players[name] = _player(name)
    player = _players[name]
    player.play() if player is not None else QtGui.QApplication.beep()


def _player(name: str) -> Any:
    """Return what plays a sound, None where nothing can."""
    from PySide import QtCore

    for module in MODULES:
        with suppress(ImportError):
            made = importlib.import_module(module).QSoundEffect()
            made.setSource(QtCore.QUrl.fromLocalFile(str(FOLDER / f"{name}.wav")))
            return made
    return None
