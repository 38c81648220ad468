# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages of the help: the guides of docs/user-guide in both languages, and one page for each kind of object.

A page is named by its address: "installing.md" is a guide, "objects/CNCStepper_Pocket" the page of an object's
fields, "machine-profile" that of a machine's fields, "contents" the list of all, "controller-codes" alarms and errors,
"refusals" what to do when something is refused.
Nothing here loads FreeCAD or Qt.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from CNCStepper.workbench import packages
from CNCStepper.workbench.services.translation import later

CONTENTS, CODES, PROFILE, OBJECTS_FOLDER = "contents", "controller-codes", "machine-profile", "objects/"
REFUSALS = "refusals"
GUIDES = packages.ROOT / "docs" / "user-guide"
REFUSALS_PAGE = packages.ROOT / "docs" / "manual" / "refusals.md"
CYCLE_PICTURES = packages.ROOT / "docs" / "pictures" / "cycles"
HEADING_SIGNS = re.compile(r"[^\w\- ]")
PORTUGUESE = "pt_BR"
SUFFIXES = {"en": ".md", PORTUGUESE: ".pt-BR.md"}  # of a guide's file by the language's code
CODE_OF_LANGUAGE = later("code of this language: en")  # the catalogue of a language names the language's own code


@dataclass(frozen=True)
class Guide:
    """A guide: its file below docs/user-guide as English has it, and its title in the contents."""

    file: str
    title: str


@dataclass(frozen=True)
class ObjectTopic:
    """The page of a kind of object: its type, its title, the guide that shows it at work, and a picture's stem."""

    type: str
    title: str
    guide: str
    picture: str = ""


GUIDE_PAGES = (
    Guide("installing.md", later("Installing")),
    Guide("freecad.md", later("FreeCAD, step by step")),
    Guide("drawings.md", later("Drawings")),
    Guide("cycles.md", later("Cycles")),
    Guide("turning.md", later("Turning")),
    Guide("lathe-threads.md", later("Threads on a lathe")),
    Guide("nesting.md", later("Nesting")),
    Guide("orders.md", later("Orders")),
    Guide("editing.md", later("Editing programs")),
    Guide("machines.md", later("Machines")),
    Guide("libraries.md", later("Tools, materials and cut charts")),
    Guide("machine-assistant.md", later("Machine assistant")),
    Guide("sending/README.md", later("Sending")),
    Guide("sending/send-file.md", later("Send a file")),
    Guide("sending/link.md", later("The link to the controller")),
    Guide("sending/firmware.md", later("Firmware of controllers")),
    Guide("sending/inputs.md", later("Inputs")),
    Guide("sending/faults.md", later("Faults while sending")),
    Guide("sending/back.md", later("Back along the cut")),
    Guide("sending/restart.md", later("Restart after an interruption")),
    Guide("sending/journal.md", later("The journal")),
    Guide("sending/mini-lathe.md", later("The mini lathe")),
    Guide("sending/virtual-machines.md", later("Virtual machines")),
    Guide("command-line.md", later("Command line")),
)
OBJECT_TOPICS = (
    ObjectTopic("CNCStepper_Job", later("Job"), "freecad.md"),
    ObjectTopic("CNCStepper_Tool", later("Tool"), "freecad.md"),
    ObjectTopic("CNCStepper_Face", later("Face"), "cycles.md", "face"),
    ObjectTopic("CNCStepper_Pocket", later("Pocket"), "cycles.md", "pocket"),
    ObjectTopic("CNCStepper_RectangularPocket", later("Rectangular pocket"), "cycles.md", "rectangular-pocket"),
    ObjectTopic("CNCStepper_CircularPocket", later("Circular pocket"), "cycles.md", "circular-pocket"),
    ObjectTopic("CNCStepper_EllipticalPocket", later("Elliptical pocket"), "cycles.md", "elliptical-pocket"),
    ObjectTopic("CNCStepper_Contour", later("Contour"), "cycles.md", "contour"),
    ObjectTopic("CNCStepper_Drill", later("Drill"), "cycles.md", "drill"),
    ObjectTopic("CNCStepper_Bore", later("Bore"), "cycles.md", "bore"),
    ObjectTopic("CNCStepper_Thread", later("Thread"), "cycles.md", "thread"),
    ObjectTopic("CNCStepper_Engrave", later("Engrave"), "cycles.md", "engrave"),
    ObjectTopic("CNCStepper_SheetCut", later("Sheet cut"), "cycles.md"),
    ObjectTopic("CNCStepper_WireCut", later("Wire cut"), "cycles.md"),
    ObjectTopic("CNCStepper_LatheJob", later("Lathe job"), "turning.md"),
    ObjectTopic("CNCStepper_TurningTool", later("Turning tool"), "turning.md"),
    ObjectTopic("CNCStepper_TurningProfile", later("Profile by points"), "turning.md"),
    ObjectTopic("CNCStepper_TurnFace", later("Turn face"), "turning.md"),
    ObjectTopic("CNCStepper_TurnRough", later("Rough turning"), "turning.md"),
    ObjectTopic("CNCStepper_TurnBore", later("Bore turning"), "turning.md"),
    ObjectTopic("CNCStepper_TurnFinish", later("Finish turning"), "turning.md"),
    ObjectTopic("CNCStepper_TurnTaper", later("Cone turning"), "turning.md"),
    ObjectTopic("CNCStepper_TurnGroove", later("Groove"), "turning.md"),
    ObjectTopic("CNCStepper_TurnPart", later("Part off"), "turning.md"),
    ObjectTopic("CNCStepper_TurnDrill", later("Drill on the lathe"), "turning.md"),
    ObjectTopic("CNCStepper_TurnThread", later("Thread turning"), "lathe-threads.md"),
    ObjectTopic("CNCStepper_Drawing", later("Imported drawing"), "freecad.md"),
    ObjectTopic("CNCStepper_Text", later("Text"), "drawings.md"),
    ObjectTopic("CNCStepper_Shape", later("Shape of the library"), "drawings.md"),
    ObjectTopic("CNCStepper_Freehand", later("Freehand"), "freecad.md"),
    ObjectTopic("CNCStepper_Slices", later("Slices of a solid"), "nesting.md"),
    ObjectTopic("CNCStepper_Nest", later("Nest on sheets"), "nesting.md"),
    ObjectTopic("CNCStepper_Arrangement", later("Arranged programs"), "nesting.md"),
    ObjectTopic("CNCStepper_Program", later("Program"), "editing.md"),
)
TOPIC_OF = {topic.type: topic for topic in OBJECT_TOPICS}


def guide_file(address: str, language: str) -> Path:
    """Return the file of a guide in a language, in English where it has no other; address: "sending/link.md"."""
    wanted = GUIDES / (address.removesuffix(".md") + SUFFIXES.get(language, ".md"))
    return wanted if wanted.exists() else GUIDES / address


def cycle_picture(name: str, language: str) -> str:
    """Return the file of a cycle's picture in a language, in English where it has no other."""
    own = f"{name}{SUFFIXES.get(language, '.md').removesuffix('.md')}.png"
    return own if (CYCLE_PICTURES / own).exists() else f"{name}.png"


def refusals_page(language: str) -> str:
    """Return the page about refusals in a language, in English where it has no other, with the links of the help."""
    wanted = REFUSALS_PAGE.with_suffix(SUFFIXES.get(language, ".md"))
    file = wanted if wanted.exists() else REFUSALS_PAGE
    return file.read_text("utf-8").replace(f"](../{CODES}.md)", f"]({CODES})")


def address_of(file: Path) -> str:
    """Return the address of a guide's file, in whatever language; "" for a file that is no guide."""
    if not file.is_relative_to(GUIDES):
        return ""
    name = file.relative_to(GUIDES).as_posix().replace(SUFFIXES[PORTUGUESE], ".md")
    return name if any(guide.file == name for guide in GUIDE_PAGES) else ""


def object_address(type_name: str) -> str:
    """Return the address of the page of a type of object, the contents for a type that has none."""
    return f"{OBJECTS_FOLDER}{type_name}" if type_name in TOPIC_OF else CONTENTS


def slug(heading: str) -> str:
    """Return the name of a heading in a link, as Markdown's readers make it."""
    return HEADING_SIGNS.sub("", heading.strip().lower()).replace(" ", "-")
