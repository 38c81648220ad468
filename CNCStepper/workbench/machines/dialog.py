# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog of machine profiles: the list of all, and the one that is chosen with its fields.

Each profile that was opened has a draft here until the dialog is closed: choosing another one loses nothing, and a
draft with a bad value cannot be saved, but stays as it was typed.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.own_profiles import create, profile_content, profiles, save
from CNCStepper.machine.profile import Machine
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.help.topics import PROFILE
from CNCStepper.workbench.machines.declaration import NUMBER, Path, Row
from CNCStepper.workbench.machines.draft import Draft, text_of
from CNCStepper.workbench.machines.fields import words_of
from CNCStepper.workbench.machines.labels import label_of
from CNCStepper.workbench.machines.machine_test_view import MachineTest
from CNCStepper.workbench.machines.sections import Section, scrolled, sections
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, note_label
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.event_steps import in_events
from CNCStepper.workbench.services.front_window import in_front
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.standard_buttons import name_standard_buttons
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Machines"
SIZE = (1030, 660)
LIST_PX = 190
SOURCE = "table-a"


class Machines(QtGui.QDialog):
    """See the module."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.setObjectName(NAME)
        self.setWindowTitle(tr("Machines"))
        f1_key.attach(self, PROFILE)
        self.resize(*SIZE)
        self.drafts: dict[str, Draft] = {}
        self.name = ""
        self.list = QtGui.QListWidget()
        self.list.setObjectName(f"{NAME}_list")
        self.list.setAccessibleName(tr("Machines"))
        self.list.setFixedWidth(LIST_PX)
        self.list.currentItemChanged.connect(guarded(self._chosen))
        self.tabs = QtGui.QTabWidget()
        self.tabs.setObjectName(f"{NAME}_tabs")
        self.sections: dict[str, Section] = {}
        self.test: Any = None
        self.note = note_label(f"{NAME}_error", ERROR_COLOUR, self)
        self.about = QtGui.QLabel()
        self.about.setObjectName(f"{NAME}_about")
        self.about.setWordWrap(True)
        self._arrange()

    def make_tabs(self) -> Iterator[None]:
        """Make the tabs, a step each: all at once would keep the window too long."""
        for title, make in sections(self._typed, self._pin_typed, self.judge).items():
            self.sections[title] = make()
            self.tabs.addTab(scrolled(self.sections[title]), title)
            yield
        self.test = MachineTest(self.machine, self.propose)
        self.tabs.addTab(scrolled(self.test), tr("Machine test"))

    # --- what is asked of it -----------------------------------------------------------------------

    def look(self, wanted: str = "") -> None:
        """List the profiles that are there now; `wanted` is chosen, else what was."""
        wanted = wanted or self.name
        self.list.blockSignals(True)
        self.list.clear()
        for profile in profiles():
            item = QtGui.QListWidgetItem(profile.name)
            item.setData(QtCore.Qt.ItemDataRole.UserRole, profile.name)
            item.setToolTip(tr("yours") if profile.is_own else tr("shipped; your first change makes a copy of it"))
            self.list.addItem(item)
        self.list.blockSignals(False)
        found = self.list.findItems(wanted, QtCore.Qt.MatchFlag.MatchExactly)
        self.list.setCurrentItem(found[0] if found else self.list.item(0))
        self._show_marks()

    def look_in_front(self, wanted: str = "") -> None:
        """Do what `look` does, and show the dialog in front."""
        self.look(wanted)
        in_front(self)

    def choose(self, name: str) -> None:
        """Show a profile, with what was typed into it before."""
        try:
            draft = self.drafts.get(name) or Draft(name, profile_content(name))
        except CNCStepperError as error:
            messages.error(error)
            return
        self.drafts[name], self.name = draft, name
        for section in self.sections.values():
            section.show_draft(draft)
        self.judge()
        self.test.show_profile()

    @property
    def draft(self) -> Draft:
        """The draft that is shown."""
        return self.drafts[self.name]

    def machine(self) -> Machine | None:
        """Return the machine of the draft that is shown, None while it has a bad value."""
        if self.name not in self.drafts:
            return None
        content, problems = self.draft.judged()
        return None if problems else Machine.model_validate(content)

    def propose(self, path: Path, value: float) -> None:
        """Put a measured value into the draft, for a person to save."""
        self.draft.texts[path] = text_of(value, Row(path, NUMBER))
        self.choose(self.name)
        self.about.setText(tr("{0} is {1} now: save it.").format(label_of(path), self.draft.texts[path]))

    def judge(self) -> bool:
        """Show what is wrong with the draft, and return whether nothing is."""
        _, problems = self.draft.judged()
        words = {path: words_of(refused) for path, refused in problems.items()}
        for place, section in enumerate(self.sections.values()):
            here = section.mark(words)
            self.tabs.setTabIcon(place, _warning() if here else QtGui.QIcon())
            for path in here:
                words.pop(path, None)
        self.note.setText("\n".join(words.values()))
        self.note.setVisible(bool(words))
        self.save_button.setEnabled(not problems and self.draft.is_changed)
        self.save_button.setToolTip(tr("Correct the marked fields first.") if problems else "")
        self.revert_button.setEnabled(self.draft.is_changed)
        self._show_marks()
        return not problems

    def save(self) -> bool:
        """Write the draft that is shown; return whether it was written."""
        content, problems = self.draft.judged()
        if problems:
            return False
        try:
            written = save(self.name, content)
        except (CNCStepperError, OSError) as error:
            messages.error(error)
            return False
        self.draft.begin(profile_content(self.name))
        said = [tr("{0} is written.").format(written.path)]
        if written.copied_from:
            said.append(tr("It is your copy of a shipped profile, and is used in its place."))
        if not written.comments_kept:
            said.append(tr("The file has a new layout: its comments are not in it."))
        self.look(self.name)
        self.judge()
        self.about.setText(" ".join(said))
        return True

    def revert(self) -> None:
        """Show what the file holds; what was typed is forgotten."""
        self.draft.begin(profile_content(self.name))
        self.choose(self.name)

    def make(self, source: str) -> None:
        """Ask for a name, and make a profile from another one."""
        title = tr("Copy of {0}").format(source) if source == self.name else tr("New machine")
        name = self._ask_for_name(title, _free_name(source))
        if name is None:
            return
        try:
            create(name.strip(), source)
        except (CNCStepperError, OSError) as error:
            messages.error(error)
            return
        self.look(name.strip())

    def _ask_for_name(self, title: str, proposed: str) -> str | None:
        """Ask for the name of a profile; None when nobody gave one."""
        dialog = QtGui.QInputDialog(self)
        dialog.setObjectName(f"{NAME}_question")
        dialog.setWindowTitle(title)
        dialog.setLabelText(tr("Name of the profile: letters of a to z, digits, - and _"))
        dialog.setTextValue(proposed)
        dialog.setOkButtonText(tr("OK"))  # Qt makes line and buttons for it
        dialog.findChild(QtGui.QLineEdit).setObjectName(f"{NAME}_question_name")
        name_standard_buttons(dialog.findChild(QtGui.QDialogButtonBox), f"{NAME}_question")
        taken = getattr(dialog, "exec", dialog.exec_)()
        dialog.deleteLater()
        return str(dialog.textValue()) if taken else None

    # --- Qt ----------------------------------------------------------------------------------------

    def closeEvent(self, event: Any) -> None:
        """Close, unless somebody thinks better of losing what was typed."""
        event.accept() if self._may_close() else event.ignore()

    def reject(self) -> None:
        """Close, as Esc does."""
        self.close()

    # --- inside ------------------------------------------------------------------------------------

    def _may_close(self) -> bool:
        changed = [name for name, draft in self.drafts.items() if draft.is_changed]
        if not changed:
            self.drafts = {}
            return True
        answers = {"discard": (tr("Discard"), "Destructive"), "cancel": (tr("Cancel"), "Reject")}
        text = tr("These profiles have changes that are not saved: {0}").format(", ".join(changed))
        title = tr("Machines")
        if messages.choose(f"{NAME}_closing", "Warning", title, text, answers, "cancel") == "cancel":
            return False
        self.drafts = {}
        return True

    def _chosen(self, item: Any) -> None:
        if item is not None:
            self.about.setText("")
            self.choose(str(item.data(QtCore.Qt.ItemDataRole.UserRole)))

    def _typed(self, path: Path, text: str) -> None:
        self.draft.texts[path] = text
        if path[0] == "signals":
            self._show_wiring()
        self.judge()

    def _pin_typed(self, signal: str, text: str) -> None:
        self.draft.pins[signal] = text
        self._show_wiring()
        self.judge()

    def _show_wiring(self) -> None:
        for section in self.sections.values():
            if any(path[0] == "signals" for path in section.fields):
                section.show_draft(self.draft)

    def _show_marks(self) -> None:
        """Mark in the list what is changed."""
        for place in range(self.list.count()):
            item = self.list.item(place)
            name = str(item.data(QtCore.Qt.ItemDataRole.UserRole))
            changed = name in self.drafts and self.drafts[name].is_changed
            item.setText(f"{name} *" if changed else name)

    def _arrange(self) -> None:
        left = QtGui.QVBoxLayout()
        left.addWidget(self.list, 1)
        new = self._button("new", tr("New…"), lambda: self.make(SOURCE))
        copy = self._button("copy", tr("Copy…"), lambda: self.make(self.name))
        buttons = QtGui.QHBoxLayout()
        buttons.addWidget(new)
        buttons.addWidget(copy)
        left.addLayout(buttons)
        self.save_button = self._button("save", tr("Save"), self.save)
        self.revert_button = self._button("revert", tr("Revert"), self.revert)
        bottom = QtGui.QHBoxLayout()
        bottom.addWidget(self.about, 1)
        for button in (self.save_button, self.revert_button, self._button("close", tr("Close"), self.reject)):
            bottom.addWidget(button)
        right = QtGui.QVBoxLayout()
        right.addWidget(self.tabs, 1)
        right.addWidget(self.note)
        right.addLayout(bottom)
        whole = QtGui.QHBoxLayout(self)
        whole.addLayout(left)
        whole.addLayout(right, 1)

    def _button(self, name: str, text: str, clicked: Any) -> Any:
        button = QtGui.QPushButton(text, self)
        button.setObjectName(f"{NAME}_{name}")
        button.setAutoDefault(False)  # Return ends a line here, and saves nothing
        button.clicked.connect(guarded(clicked))
        return button


def shown(name: str = "") -> Machines:
    """Return the dialog, made at its first opening; it is shown when all its tabs are there."""
    window = FreeCADGui.getMainWindow()
    found = window.findChild(QtGui.QDialog, NAME)
    if not isinstance(found, Machines):
        made = Machines(window)
        in_events(made.make_tabs(), lambda: made.look_in_front(name))
        return made
    if found.test is not None:
        found.look_in_front(name)
    return found


def _free_name(source: str) -> str:
    names = {profile.name for profile in profiles()}
    return next(f"{source}-{number}" for number in range(2, len(names) + 3) if f"{source}-{number}" not in names)


def _warning() -> Any:
    return QtGui.QApplication.style().standardIcon(QtGui.QStyle.StandardPixmap.SP_MessageBoxWarning)
