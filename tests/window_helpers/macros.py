# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own macros: recorded as a person does, run again on a document as it was, and what both documents hold."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui

from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import is_job, proxy_type, value_of
from window_helpers.hand import Hand

AGAIN_S = 120  # so long may a macro take, and what it begins beside the window


def begin_recording(hand: Hand, name: str = "peca") -> Path:
    """Start FreeCAD's own macro recording by its dialog; return the file to be written."""
    hand.command("Std_DlgMacroRecord")  # by its button: run from Python, FreeCAD 0.20 lets no other thread run Python
    hand.wait(lambda: hand.exists("lineEditPath"), 10, "FreeCAD's dialog")
    hand.fill("lineEditPath", name)
    path = Path(hand.text("lineEditMacroPath")) / f"{name}.FCMacro"
    path.unlink(missing_ok=True)  # FreeCAD would ask
    hand.click("buttonStart")
    hand.wait(lambda: not hand.exists("lineEditPath"), 10, "the recording")
    return path


def end_recording(hand: Hand, path: Path) -> str:
    """Stop the recording; return the macro."""
    stop_recording(hand)
    hand.wait(path.is_file, 10, "the macro's file")
    return path.read_text("utf-8")


def stop_recording(hand: Hand) -> None:
    """Stop a recording, from FreeCAD 1.0 on by the command that has begun it."""
    commands = hand.main(FreeCADGui.Command.listAll)
    stop = "Std_MacroStopRecord" if "Std_MacroStopRecord" in commands else "Std_DlgMacroRecord"
    hand.main(FreeCADGui.runCommand, stop)


def run(hand: Hand, text: str, name: str = "macro") -> None:
    """Run a macro on the active document, with the names that FreeCAD gives to it."""
    names = {"__name__": "__main__", "App": FreeCAD, "Gui": FreeCADGui}
    hand.main(lambda: exec(compile(text, name, "exec"), names), limit_s=AGAIN_S)


def run_on_copy(hand: Hand, text: str, copy: Path, wanted: dict[str, Any]) -> None:
    """Run a macro on a document as it was when the recording began, and wait until it holds what is wanted."""
    for name in hand.main(lambda: list(FreeCAD.listDocuments())):
        hand.main(FreeCAD.closeDocument, name)
    document = hand.main(opened, copy, limit_s=AGAIN_S)
    try:
        run(hand, text)
        if not hand.is_soon(lambda: differences(wanted, state(document)) == {}):
            found = hand.main(lambda: differences(wanted, state(document)))
            assert not found, found
    except BaseException:
        print(f"the macro:\n{text}", flush=True)
        raise


def opened(path: Path) -> Any:
    """Open a document that keeps undo steps, and make it again as it stood."""
    document = FreeCAD.openDocument(str(path))
    document.UndoMode = 1
    document.recompute()
    return document


def differences(wanted: dict[str, Any], found: dict[str, Any]) -> dict[str, Any]:
    """Return what differs of two states, each as (wanted, found)."""
    keys = [key for key in {**wanted, **found} if wanted.get(key) != found.get(key)]
    return {key: (wanted.get(key), found.get(key)) for key in keys}


def state(document: Any) -> dict[str, Any]:
    """Return all that is in a document: properties of ours that a person sets, labels, shapes, programs."""
    found: dict[str, Any] = {}
    for obj in document.Objects:
        found |= {f"{obj.Name}.{key}": value for key, value in held_by(obj).items()}
    return found


def held_by(obj: Any) -> dict[str, Any]:
    """Return what an object holds that a macro must make again."""
    values: dict[str, Any] = {"type": proxy_type(obj) or obj.TypeId, "label": obj.Label}
    if proxy_type(obj):
        values |= {entry.name: plain(value_of(obj, entry)) for entry in obj.Proxy.PROPERTIES if not entry.output}
    if hasattr(obj, "Shape"):
        values["length"] = round(obj.Shape.Length, 9)
    if is_job(obj):
        values["program"] = program_file.load(obj)
    return values


def plain(value: Any) -> str:
    """Return a value as text, an object by its name."""
    if isinstance(value, FreeCAD.DocumentObject):
        return str(value.Name)
    return f"[{', '.join(map(plain, value))}]" if isinstance(value, list | tuple) else str(value)
