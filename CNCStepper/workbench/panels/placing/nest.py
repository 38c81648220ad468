# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of a nest: parts with their counts, sheets, *Nest* and *Stop*, and the parts in the view by hand."""

from __future__ import annotations

import json
from dataclasses import asdict, replace
from typing import Any

from PySide import QtGui

from CNCStepper import text_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.job.nesting import nest_data
from CNCStepper.nesting.nesting_model import MOST_PARTS
from CNCStepper.workbench.document.nest_files import BETWEEN_SHEETS_MM, Nesting
from CNCStepper.workbench.features.drawings.made_files import is_stale
from CNCStepper.workbench.features.drawings.nest import (
    GRAINS,
    MADE,
    PARTS,
    SHEETS,
    TURNS,
    PartValues,
    is_part,
    part_values,
    set_parts,
)
from CNCStepper.workbench.panels.background_panel import button_row
from CNCStepper.workbench.panels.fields import NAME, WARNING_COLOUR, WorkNote, note_label
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.placing.part_table import Column, PartTable, choose_objects
from CNCStepper.workbench.panels.placing.placing_panel import PlacingPanel
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

MOST_PRIORITY = 1000
MOST_THICKNESS_MM = 1000.0
FILL_S = 20.0  # the most that filling takes


class NestPanel(PlacingPanel):
    """Edits a nest; what is made while it is open belongs to its one undo step."""

    BETWEEN_MM = BETWEEN_SHEETS_MM

    def __init__(self, obj: Any, editor: Editor):
        super().__init__(obj, editor, WorkNote(f"{NAME}_nesting", editor), not obj.MadeOf)
        self.table = PartTable(_columns(), editor)
        self.table.edited.connect(guarded(self.take_table))
        self.remnants = QtGui.QLabel(editor)
        self.remnants.setObjectName(f"{NAME}_remnants")
        self.remnants.setWordWrap(True)
        self.summary = QtGui.QLabel(editor)
        self.summary.setObjectName(f"{NAME}_nest_report")
        self.summary.setWordWrap(True)
        self.warnings = note_label(f"{NAME}_nest_warnings", WARNING_COLOUR, editor)
        of_parts = (
            ("add_part", tr("Add…"), tr("Add drawings, sketches or operations of the document"), self.ask_parts),
            ("drop_part", tr("Leave out"), tr("Take the marked rows out of the nest"), self.drop_parts),
        )
        of_rests = (
            ("add_rest", tr("Remnant…"), tr("Use a drawing of a rest of a sheet first"), self.ask_remnants),
            ("drop_rests", tr("None"), tr("Use whole sheets only"), self.drop_remnants),
        )
        of_search = (
            ("nest", tr("Nest"), tr("Place all parts that are not locked"), self.search),
            ("stop", tr("Stop"), tr("End the search with the best so far"), self.stop),
        )
        form = editor.form
        for widget in (self.table, button_row(of_parts, editor)):
            form.add_widget(PARTS, widget)
        for widget in (self.remnants, button_row(of_rests, editor)):
            form.add_widget(SHEETS, widget)
        made = (self.note, button_row(of_search, editor), self.chosen_label, self.why, *self.hand_buttons())
        for widget in (*made, self.summary, self.warnings):
            form.add_widget(MADE, widget)
        self.fill_table()
        self.refresh_report()
        if obj.MadeOf:
            self.ask(nest_data.SHOW)

    def fill_table(self) -> None:
        """Show the parts of the object."""
        self.table.fill([part.Label for part in self.obj.Parts], [asdict(each) for each in part_values(self.obj)])
        names = ", ".join(each.Label for each in self.obj.Remnants)
        self.remnants.setText(tr("Remnants: {0}").format(names or tr("none")))
        self.show_state()

    def take_table(self) -> None:
        """Write what stands in the table into the object."""
        set_parts(self.obj, self.obj.Parts, [PartValues(**row) for row in self.table.rows()])
        self.obj.Proxy.execute(self.obj)
        if self.nest is not None:
            self.nest.items = tuple(
                replace(item, count=row["count"]) for item, row in zip(self.nest.items, self.table.rows(), strict=False)
            )
        self.show_counts()

    def ask_parts(self) -> None:
        """Offer what may be a part."""
        found = [each for each in self.obj.Document.Objects if self._may_add(each) and each not in self.obj.Parts]
        choose_objects(found, tr("Add…"), self.add_parts, self.editor.findChild(QtGui.QPushButton, f"{NAME}_add_part"))

    def add_parts(self, parts: list[Any]) -> None:
        """Add parts to the object, once each."""
        self._set_parts([*self.obj.Parts, *parts], [*self._wanted(), *(PartValues() for _ in parts)])

    def drop_parts(self) -> None:
        """Take the marked rows out; their places go too."""
        marked = {index.row() for index in self.table.selectionModel().selectedRows()}
        kept = [number for number in range(len(self.obj.Parts)) if number not in marked]
        parts, wanted = list(self.obj.Parts), self._wanted()
        self._set_parts([parts[number] for number in kept], [wanted[number] for number in kept])

    def ask_remnants(self) -> None:
        """Offer what may be a remnant."""
        found = [each for each in self.obj.Document.Objects if self._may_add(each) and each not in self.obj.Remnants]
        button = self.editor.findChild(QtGui.QPushButton, f"{NAME}_add_rest")
        choose_objects(found, tr("Remnant…"), self.add_remnants, button)

    def add_remnants(self, rests: list[Any]) -> None:
        """Add remnants, once each."""
        self._set_remnants([*self.obj.Remnants, *rests])

    def drop_remnants(self) -> None:
        """Use no remnants."""
        self._set_remnants([])

    def search(self) -> None:
        """Place the parts by the values that stand here."""
        self.editor.apply()
        self.take_table()
        if not self.editor.refused:
            self.ask(nest_data.SEARCH)

    def stop(self) -> None:
        """End the search with the best so far."""
        if isinstance(self.work, Nesting):
            self.work.stop()

    def fill(self) -> None:
        """Fill a sheet with more of the part that is chosen, or marked in the table."""
        if self.nest is None:
            self.search()
            return
        chosen = self.mode.chosen if self.mode is not None else None
        sheet = 0 if chosen is None else self.nest.parts[chosen].placement.sheet
        item = self.table.currentRow()
        if item < 0:
            item = 0 if chosen is None else self.nest.parts[chosen].placement.item
        self.ask(nest_data.FILL, item=item, sheet=sheet, time_s=FILL_S)

    def ask(self, verb: str, **more: Any) -> None:
        """Ask the process; what it is about the parts lie as they are shown."""
        if self.nest is not None:
            more["parts"] = self.rows()
        work = Nesting(self.obj, verb, guarded(self.done), guarded(self.failed), self._share, **more)
        self.begin(work, tr("Nesting…"))

    def done(self) -> None:
        """Show what was found."""
        work = self.work
        assert isinstance(work, Nesting)
        answer = work.answer
        self.unwritten = answer["parts"] != self.rows_written()
        self._raise_counts(answer)
        self.leave_mode()
        self.show_nest(answer)
        super().done()

    def _raise_counts(self, answer: dict[str, Any]) -> None:
        """Want as many of each part as lie there after filling."""
        wanted = self._wanted()
        lie = [sum(row[1] == number for row in answer["parts"]) for number in range(len(wanted))]
        for number, count in enumerate(lie):
            if count > wanted[number].count:
                wanted[number].count = answer["order"]["items"][number]["count"] = count
                self.table.set_cell(number, "count", count)
        set_parts(self.obj, self.obj.Parts, wanted)

    def failed(self, error: CNCStepperError) -> None:
        """Say why nothing was made."""
        super().failed(error)
        self.show_state()

    def accept(self) -> bool:
        """Keep all as one undo step; what was never nested, moved by hand or changed since, is made first."""
        self.editor.apply()
        if self.work is None and not self.editor.refused and self.obj.Parts:
            if self.nest is not None and self.unwritten:
                self.take_table()
                self.ask(nest_data.WRITE)
            elif is_stale(self.obj):
                self.search()
        return super().accept()

    def refresh_report(self) -> None:
        """Show what was made."""
        told = text_json.loads(self.obj.Report) if self.obj.Report else None
        lines = [_summary(self.obj, told), *map(translated, told.get("saving", ()))] if told else []
        self.summary.setText("\n".join(lines))
        self.summary.setVisible(bool(told))
        rows = [translated(each) for each in told["unplaced"]] if told else []
        self.warnings.setText("\n".join(rows))
        self.warnings.setVisible(bool(rows))

    def rows(self) -> list[list[Any]]:
        """Return the parts as plain data."""
        return nest_data.rows_of(self.nest.parts) if self.nest is not None else []

    def rows_written(self) -> list[list[Any]]:
        """Return the parts as the object has them."""
        return list(json.loads(self.obj.Placements))

    def show_counts(self) -> None:
        """Show how many of each part lie on the sheets."""
        if self.nest is not None:
            self.table.show_counts(self.nest.counts())

    def _wanted(self) -> list[PartValues]:
        return [PartValues(**row) for row in self.table.rows()]

    def _may_add(self, each: Any) -> bool:
        """Return whether an object may be a part or a remnant: no child of this nest, and with an outline."""
        own = {each.Name for drawing in self.obj.Group for each in (drawing, *drawing.Group)}
        return each is not self.obj and each.Name not in own and is_part(each)

    def _set_parts(self, parts: list[Any], wanted: list[PartValues]) -> None:
        """Let these be the parts; what lies on the sheets keeps its place by its part."""
        before = list(self.obj.Parts)
        rows = self.rows() if self.nest is not None else self.rows_written()
        numbers = {number: parts.index(part) for number, part in enumerate(before) if part in parts}
        kept = [[row[0], numbers[row[1]], *row[2:]] for row in rows if row[1] in numbers]
        set_parts(self.obj, parts, wanted)
        self.obj.Placements = json.dumps(kept)
        self._forget_nest()

    def _set_remnants(self, rests: list[Any]) -> None:
        """Let these be the remnants; the numbers of the sheets change with them, so that nothing lies there then."""
        self.obj.Remnants = rests
        self.obj.Placements = "[]"
        self._forget_nest()

    def _forget_nest(self) -> None:
        self.leave_mode()
        self.nest = None
        self.obj.Proxy.execute(self.obj)
        self.fill_table()

    def _share(self, share: float) -> None:
        self.note.say(tr("Nesting: {0} %").format(f"{100 * share:.0f}"))


def _columns() -> tuple[Column, ...]:
    turns = {"fixed": tr("as drawn"), "half": tr("0°, 180°"), "quarter": tr("0° to 270°"), "any": tr("any")}
    grains = tuple((key, words_of(key)) for key in GRAINS)
    return (
        Column("count", tr("Count"), tr("How many are wanted"), bounds=(1, MOST_PARTS)),
        Column("turn", tr("Turn"), tr("The rotations in which it may lie"), tuple((key, turns[key]) for key in TURNS)),
        Column("grain", tr("Grain"), tr("Its direction that lies along the grain of the material"), grains),
        Column(
            "priority",
            tr("First"),
            tr("Parts of a larger number are placed first"),
            bounds=(-MOST_PRIORITY, MOST_PRIORITY),
        ),
        Column(
            "thickness_mm",
            tr("Thickness"),
            tr("Of its sheet, mm; 0: that of the sheets of material"),
            bounds=(0.0, MOST_THICKNESS_MM),
        ),
    )


def _summary(obj: Any, told: dict[str, Any]) -> str:
    return tr("{0} parts on {1} sheets, {2} missing; the sheets are used to {3} %").format(
        obj.Placed, obj.SheetCount, obj.Missing, f"{100 * told['density']:.1f}"
    )
