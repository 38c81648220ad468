# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of an arrangement: programs with their counts, *Place*, the copies in the view by hand, *Write*."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from PySide import QtGui

from CNCStepper.job.nesting import nest_data
from CNCStepper.workbench.document.arrange_files import Arranging
from CNCStepper.workbench.features.drawings.made_files import is_stale
from CNCStepper.workbench.features.programs.arrangement import (
    MADE,
    PROGRAMS,
    counts_of,
    is_source,
    name_of,
    set_sources,
    sources,
)
from CNCStepper.workbench.panels.background_panel import button_row
from CNCStepper.workbench.panels.fields import NAME, ChoiceField, WorkNote
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.placing.part_table import Column, PartTable, choose_objects
from CNCStepper.workbench.panels.placing.placing_panel import PlacingPanel
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

MOST_COPIES = 2000


class JobField(ChoiceField):
    """One of the jobs of the document."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return the jobs by their labels."""
        from CNCStepper.workbench.features.base import JOB, proxy_type

        return [(each, each.Label) for each in self.obj.Document.Objects if proxy_type(each) == JOB]


class ArrangementPanel(PlacingPanel):
    """Edits an arrangement; what is made while it is open belongs to its one undo step."""

    def __init__(self, obj: Any, editor: Editor):
        super().__init__(obj, editor, WorkNote(f"{NAME}_arranging", editor), not obj.MadeOf)
        count = Column("count", tr("Count"), tr("How many are wanted"), bounds=(1, MOST_COPIES))
        self.table = PartTable((count,), editor)
        self.table.edited.connect(guarded(self.take_table))
        of_programs = (
            ("add_part", tr("Add…"), tr("Add jobs and programs of the document"), self.ask_programs),
            ("add_file", tr("File…"), tr("Add a G-code file"), self.ask_file),
            ("drop_part", tr("Leave out"), tr("Take the marked rows out"), self.drop_programs),
        )
        of_places = (
            ("place", tr("Place all"), tr("Place all copies that are not locked"), self.place),
            ("write", tr("Write program"), tr("Write the one checked program of all copies"), self.write),
        )
        for widget in (self.table, button_row(of_programs[:2], editor), button_row(of_programs[2:], editor)):
            editor.form.add_widget(PROGRAMS, widget)
        made = (self.note, button_row(of_places, editor), self.chosen_label, self.why, *self.hand_buttons())
        for widget in made:
            editor.form.add_widget(MADE, widget)
        self.fill_table()
        if obj.MadeOf or json.loads(obj.Placements):
            self.ask(nest_data.SHOW)

    def fill_table(self) -> None:
        """Show the programs of the object."""
        rows = [{"count": count} for count in counts_of(self.obj)]
        self.table.fill([name_of(each) for each in sources(self.obj)], rows)
        self.show_state()

    def take_table(self) -> None:
        """Write what stands in the table into the object."""
        set_sources(self.obj, sources(self.obj), self._counts())
        self.obj.Proxy.execute(self.obj)
        self.show_counts()

    def ask_programs(self) -> None:
        """Offer the jobs and programs of the document."""
        there = sources(self.obj)
        made = [each for each in self.obj.Document.Objects if is_source(each) and each not in there]
        button = self.editor.findChild(QtGui.QPushButton, f"{NAME}_add_part")
        choose_objects(made, tr("Add…"), self.add_sources, button)

    def ask_file(self) -> None:
        """Ask for a G-code file."""
        from CNCStepper.workbench.editor.file_dialogs import ask_which

        path = ask_which()
        if path is not None:
            self.add_sources([Path(path)])

    def add_sources(self, found: list[Any]) -> None:
        """Add programs, once each."""
        there = sources(self.obj)
        new = [each for each in found if each not in there]
        self._set([*there, *new], [*self._counts(), *(1 for _ in new)])

    def drop_programs(self) -> None:
        """Take the marked rows out; their copies go too."""
        marked = {index.row() for index in self.table.selectionModel().selectedRows()}
        kept = [number for number in range(self.table.rowCount()) if number not in marked]
        there, counts = sources(self.obj), self._counts()
        self._set([there[number] for number in kept], [counts[number] for number in kept])

    def place(self) -> None:
        """Place the copies by the values that stand here."""
        self.editor.apply()
        self.take_table()
        if not self.editor.refused:
            self.ask(nest_data.SEARCH)

    def fill(self) -> None:
        """Fill the work surface with more of the marked program, or the first."""
        self.ask(nest_data.FILL, item=max(self.table.currentRow(), 0))

    def write(self) -> None:
        """Write the program of the copies as they lie."""
        self.editor.apply()
        self.take_table()
        if not self.editor.refused:
            self.ask(nest_data.WRITE if self.rows() else nest_data.SEARCH)

    def ask(self, verb: str, **more: Any) -> None:
        """Ask the process; what it is about the copies lie as they are shown."""
        parts = self.rows() if self.nest is not None else self.rows_written()
        work = Arranging(self.obj, verb, guarded(self.done), guarded(self.failed), parts=parts, **more)
        self.begin(work, tr("Arranging…"))

    def done(self) -> None:
        """Show where the copies lie."""
        work = self.work
        assert isinstance(work, Arranging)
        answer = work.answer
        self.unwritten = not answer["written"] and answer["parts"] != self.rows_written()
        self._raise_counts(answer)
        self.show_nest(answer)
        super().done()

    def accept(self) -> bool:
        """Keep all as one undo step; what was moved or changed since the program was written is written first."""
        self.editor.apply()
        may_write = self.work is None and not self.editor.refused and bool(sources(self.obj))
        if may_write and (self.unwritten or is_stale(self.obj)):
            self.write()
        return super().accept()

    def refresh_report(self) -> None:
        """Show how many copies lie there."""
        self.show_counts()

    def rows(self) -> list[list[Any]]:
        """Return the copies as plain data."""
        return nest_data.rows_of(self.nest.parts) if self.nest is not None else []

    def rows_written(self) -> list[list[Any]]:
        """Return the copies as the object has them."""
        return list(json.loads(self.obj.Placements))

    def show_counts(self) -> None:
        """Show how many copies of each program lie there."""
        if self.nest is not None:
            lie = [count for count, _ in self.nest.counts()]
            self.table.show_counts(list(zip(lie, self._counts(), strict=False)))

    def _raise_counts(self, answer: dict[str, Any]) -> None:
        counts = self._counts()
        for number, count in enumerate(counts):
            lie = sum(row[1] == number for row in answer["parts"])
            if lie > count:
                counts[number] = lie
                self.table.set_cell(number, "count", lie)
        set_sources(self.obj, sources(self.obj), counts)

    def _counts(self) -> list[int]:
        return [row["count"] for row in self.table.rows()]

    def _set(self, found: list[Any], counts: list[int]) -> None:
        """Let these be arranged; copies keep their places by their program."""
        before = sources(self.obj)
        rows = self.rows() if self.nest is not None else self.rows_written()
        set_sources(self.obj, found, counts)
        after = sources(self.obj)
        numbers = {number: after.index(each) for number, each in enumerate(before) if each in after}
        self.obj.Placements = json.dumps([[row[0], numbers[row[1]], *row[2:]] for row in rows if row[1] in numbers])
        self.leave_mode()
        self.nest = None
        self.obj.Proxy.execute(self.obj)
        self.fill_table()
