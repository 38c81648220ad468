# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person prefers for new jobs and saved programs, in FreeCAD's parameters; set on the preferences page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

GROUP = "User parameter:BaseApp/Preferences/Mod/CNCStepper/NewJob"
MACHINE, MATERIAL, UNITS, THICKNESS, FOLDER = "Machine", "Material", "Units", "Thickness", "ProgramFolder"
USUAL = {MACHINE: "table-a", MATERIAL: "", UNITS: "mm", FOLDER: ""}
THICKNESS_MM = 20.0  # of the stock round a drawing


def text(name: str) -> str:
    """Return a preferred text: MACHINE, MATERIAL, UNITS or FOLDER."""
    return str(_group().GetString(name, USUAL[name]))


def thickness_mm() -> float:
    """Return the preferred thickness of the stock round a drawing."""
    return float(_group().GetFloat(THICKNESS, THICKNESS_MM))


def prefer(texts: dict[str, str], thickness_mm: float) -> None:
    """Keep what a person prefers."""
    group = _group()
    for name, value in texts.items():
        group.SetString(name, value)
    group.SetFloat(THICKNESS, thickness_mm)


def of_new_job() -> dict[str, Any]:
    """Return the values of a new job of milling, by key; a machine that is gone or does not mill is left out."""
    from CNCStepper.machine.materials import material_names

    values: dict[str, Any] = {"units": text(UNITS)}
    if text(MACHINE) in milling_machines():
        values["machine"] = text(MACHINE)
    if text(MATERIAL) in material_names():
        values["material"] = text(MATERIAL)
    return values


def milling_machines() -> list[str]:
    """Return the names of the machine profiles that can mill; one that cannot be read is left out."""
    from CNCStepper.errors import CNCStepperError
    from CNCStepper.machine.processes import MILLING
    from CNCStepper.machine.profile import load_machine, profile_names

    found = []
    for name in profile_names():
        try:
            mills = MILLING.name in load_machine(name).processes
        except CNCStepperError:  # the dialog of machines says why
            continue
        if mills:
            found.append(name)
    return found


def program_folder(document: Any) -> Path:
    """Return where programs are saved first: in the preferred folder, else beside the document, else at home."""
    if text(FOLDER) and Path(text(FOLDER)).is_dir():
        return Path(text(FOLDER))
    return Path(document.FileName).parent if document is not None and document.FileName else Path.home()


def _group() -> Any:
    import FreeCAD

    return FreeCAD.ParamGet(GROUP)
