# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that bring drawings in."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.workbench.commands.create_object import create, labelled
from CNCStepper.workbench.document import targets
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, tr


class ImportDrawing(Command):
    """Makes objects of the file of a drawing; also a document, when none is open."""

    name = "CNCStepper_ImportDrawing"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_ImportDrawing", "Import drawing…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_ImportDrawing", "Brings in SVG, DXF, STEP, STL, pictures, points or G-code, linked to the file"
    )

    def why_not(self) -> str:
        """Return why nothing can be imported."""
        return missing_packages.why_not() or targets.why_no_panel()

    def run(self) -> None:
        """Ask for the file, and open the panel of what is read from it."""
        from CNCStepper.workbench.calculation.preloading import DRAWINGS, begin_to_load
        from CNCStepper.workbench.document.drawing_files import ask_file

        begin_to_load(DRAWINGS)
        document = targets.document()
        folder = Path(document.FileName).parent if document is not None and document.FileName else Path.home()
        ask_file(str(folder), self.take)

    def take(self, path: str) -> None:
        """Make the group of a file and open its panel, which reads it."""
        from CNCStepper.workbench.calculation.preloading import DRAWINGS, when_loaded

        when_loaded(DRAWINGS, lambda: self._create(path))

    def _create(self, path: str) -> None:
        import FreeCAD

        if not targets.why_no_panel():
            document = targets.document() or FreeCAD.newDocument()
            create(document, self.text(), lambda: _group(document, path))


class Template(Command):
    """Makes a job of an imported drawing by the rules of a template."""

    name = "CNCStepper_Template"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Template", "Template…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Template", "Makes a job of an imported drawing by rules: layer, colour or name to operation"
    )

    def why_not(self) -> str:
        """Return why there is no drawing to make a job of."""
        no_panel = missing_packages.why_not() or targets.why_no_view() or targets.why_no_panel()
        return no_panel or ("" if targets.imported_drawing() is not None else tr("Import a drawing first"))

    def run(self) -> None:
        """Open the panel of the selected drawing, or of the document's last one."""
        from CNCStepper.workbench.calculation.preloading import TEMPLATES, when_loaded

        when_loaded(TEMPLATES, self._open)

    def _open(self) -> None:
        from CNCStepper.workbench.templates.panel import open_template_panel

        if not self.why_not():
            open_template_panel(targets.imported_drawing())


def _group(document: Any, path: str) -> Any:
    from CNCStepper.workbench import api

    return labelled(api.add_drawing(document, path), Path(path).stem)


class Slice(Command):
    """Cuts a body or a mesh into sheets."""

    name = "CNCStepper_Slices"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Slices", "Slice a solid…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Slices", "Cuts a solid into sheets with registration holes, and nests their pieces"
    )

    def why_not(self) -> str:
        """Return why nothing can be sliced."""
        return missing_packages.why_not() or targets.why_no_view() or targets.why_no_panel()

    def run(self) -> None:
        """Make the object of the selected solid, or the document's last one, and open its panel, which slices it."""
        document = targets.document()
        create(document, self.text(), lambda: _slices(document, [*document.Objects, *targets.selected()]))


def _slices(document: Any, objects: list[Any]) -> Any:
    """Return the slices of the last solid of some objects; raises JobError where there is none."""
    from CNCStepper.workbench import api
    from CNCStepper.workbench.features.drawings.slices import last_solid

    return labelled(api.add_slices(document, last_solid(objects)), tr("Slices"))


class Nest(Command):
    """Places drawings and outlines on sheets of material."""

    name = "CNCStepper_Nest"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Nest", "Nest on sheets…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Nest", "Places the selected drawings on sheets of material, as often as they are wanted"
    )

    def why_not(self) -> str:
        """Return why nothing can be nested."""
        return missing_packages.why_not() or targets.why_no_view() or targets.why_no_panel()

    def run(self) -> None:
        """Make the nest of what is selected, and open its panel."""
        document = targets.document()
        create(document, self.text(), lambda: _nest(document, targets.selected()))


def _nest(document: Any, objects: list[Any]) -> Any:
    """Return a nest of those of some objects that have outlines."""
    from CNCStepper.workbench import api
    from CNCStepper.workbench.features.drawings.nest import is_part

    return labelled(api.add_nest(document, [each for each in objects if is_part(each)]), tr("Nest"))


class Text(Command):
    """Adds a text; also a document, when none is open."""

    name = "CNCStepper_Text"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Text", "Text")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Text", "Adds a text in any font, or in single lines for engraving")

    def why_not(self) -> str:
        """Return why no text can be added."""
        return missing_packages.why_not() or targets.why_no_panel()

    def run(self) -> None:
        """Make the text and open its panel."""
        import FreeCAD

        from CNCStepper.workbench import api

        document = targets.document() or FreeCAD.newDocument()
        create(document, self.text(), lambda: labelled(api.add_text(document, tr("Text")), tr("Text")))


class Shapes(Command):
    """Shows the library of basic shapes, and adds one of them; also a document, when none is open."""

    name = "CNCStepper_Shapes"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Shapes", "Shapes…")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Shapes", "Adds a shape by its dimensions: holes, slots, flanges, brackets")

    def why_not(self) -> str:
        """Return why no shape can be added."""
        return missing_packages.why_not() or targets.why_no_panel()

    def run(self) -> None:
        """Show the pictures; FreeCAD 1.1 shows no task panel where no document is open."""
        import FreeCAD

        from CNCStepper.workbench.panels.shape_gallery import open_gallery

        if targets.document() is None:
            FreeCAD.newDocument()
        open_gallery(self.take)

    def take(self, kind: str) -> None:
        """Add a shape of a kind and open the panel of its dimensions."""
        from CNCStepper.drawing.shape_library.shape_families import library_shape
        from CNCStepper.workbench import api

        document, title = targets.document(), tr(library_shape(kind).title)
        create(document, title, lambda: labelled(api.add_shape(document, kind), title))
