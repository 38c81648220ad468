# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog that asks before packages are installed, shows how far that is, and lets one end it.

It loads nothing that a package of others is needed for.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

from CNCStepper import dependencies
from CNCStepper.control.processes.bootstrap import python_version
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench import packages
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.installation.pip_messages import progress
from CNCStepper.workbench.installation.pip_python import container
from CNCStepper.workbench.installation.process import Installation
from CNCStepper.workbench.services import command, missing_packages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded, sentence
from CNCStepper.workbench.services.theme_colours import ERROR, letters
from CNCStepper.workbench.services.translation import later, tr

NAME = "CNCStepper_Install"
SIZE = (640, 520)
DETAILS_PX = 140
PURPOSES = {
    dependencies.PROGRAM: later("to make programs"),
    dependencies.MACHINE: later("to reach a machine"),
    dependencies.FILES: later("to read and write files"),
    dependencies.TERMINAL: later("for the command line"),
    dependencies.SPEED: later("to plan and simulate fast"),
    dependencies.NESTING: later("to nest parts on sheets"),
}


class Installer(QtGui.QDialog):
    """See the module. wanted: which packages may be installed; target: into which folder."""

    def __init__(self, parent: Any, wanted: list[dependencies.Need] | None = None, target: Path | None = None):
        super().__init__(parent)
        self.setObjectName(NAME)
        self.setWindowTitle(tr("Install packages"))
        f1_key.attach(self, "installing.md")
        self.resize(*SIZE)
        self._wanted, self.target = wanted, target or packages.own_folder()
        self.run: Installation | None = None
        self._make()
        self._arrange()
        self.look()

    # --- what is asked of it -----------------------------------------------------------------------

    def look(self) -> None:
        """List what is missing now, each to be installed unless its mark is taken away."""
        self.list.clear()
        for need in self.lacking():
            item = QtGui.QListWidgetItem(_about(need))
            item.setData(QtCore.Qt.ItemDataRole.UserRole, need.module)
            item.setCheckState(QtCore.Qt.CheckState.Checked)
            self.list.addItem(item)
        version = python_version()
        some = tr("CNCStepper works with these packages, which the Python {0} of this FreeCAD lacks:").format(version)
        none = tr("All packages that CNCStepper works with are there.")
        self.intro.setText(some if self.list.count() else none)
        self._show_state()

    def lacking(self) -> list[dependencies.Need]:
        """Return the packages that are missing, of those that a person at the window has a use for."""
        needs = self._wanted or [need for need in dependencies.NEEDS if need.purposes != (dependencies.CLUSTER,)]
        names = packages.missing(*(need.module for need in needs))
        return [need for need in needs if need.module in names]

    def chosen(self) -> list[str]:
        """Return the modules whose mark is set."""
        items = [self.list.item(row) for row in range(self.list.count())]
        marked = [item for item in items if item.checkState() == QtCore.Qt.CheckState.Checked]
        return [item.data(QtCore.Qt.ItemDataRole.UserRole) for item in marked]

    def install(self, source: Path | None = None) -> None:
        """Begin to install what is marked, from the package index or from a folder or zip."""
        self._say_error(None)
        self.details.clear()
        self.run = Installation(self.target, dependencies.requirements(self.chosen()), source, self)
        self.run.said.connect(guarded(self._said))
        self.run.ended.connect(guarded(self._ended))
        self.status.setText(tr("Looking for pip…"))
        self._show_state()

    def cancel(self) -> None:
        """End what is under way."""
        self._let_go()
        self.status.setText(tr("Cancelled: nothing was installed."))
        self._show_state()

    def reject(self) -> None:
        """Close; what is under way ends."""
        if self.run is not None:
            self.cancel()
        super().reject()

    # --- what happens ------------------------------------------------------------------------------

    def _let_go(self) -> None:
        run, self.run = self.run, None
        if run is not None:
            run.cancel()
            run.deleteLater()

    def _said(self, line: str) -> None:
        self.details.appendPlainText(line)
        if (found := progress(line)) is not None:
            self.status.setText(translated(found) + "…")

    def _ended(self, error: CNCStepperError | None) -> None:
        installed = self.chosen()
        self._let_go()
        missing_packages.look_again()
        self.look()
        if error is not None:
            self.status.setText(tr("Nothing was installed."))
            self._say_error(error)
            return
        words = [tr("Installed. CNCStepper can work now.")]
        if dependencies.FAST in installed and "CNCStepper.kernels" in sys.modules:
            words.append(tr("numba makes it fast from the next start of FreeCAD on."))
        self.status.setText(" ".join(words))
        begin_to_work()

    def _say_error(self, error: CNCStepperError | None) -> None:
        self.error.setVisible(error is not None)
        if error is not None:
            sentences = (sentence(error), translated(error.advice))
            self.error.setText("\n".join(f"{text[:1].upper()}{text[1:]}." for text in sentences))

    def _show_state(self) -> None:
        """Enable what can be pressed now."""
        idle, some = self.run is None, bool(self.chosen())
        self.list.setEnabled(idle)
        self.install_button.setEnabled(idle and some)
        self.files_button.setEnabled(idle and some)
        self.close_button.setText(tr("Close") if idle else tr("Cancel"))
        self.bar.setVisible(not idle)
        self.details_button.setEnabled(not self.details.document().isEmpty() or not idle)

    def _close_or_cancel(self) -> None:
        self.reject() if self.run is None else self.cancel()

    def _from_zip(self) -> None:
        self._ask_for_files(QtGui.QFileDialog.FileMode.ExistingFile, tr("Zip with packages ({0})").format("*.zip"))

    def _from_folder(self) -> None:
        self._ask_for_files(QtGui.QFileDialog.FileMode.Directory, "")

    def _ask_for_files(self, mode: Any, name_filter: str) -> None:
        dialog = QtGui.QFileDialog(self, tr("Install from files"), str(Path.home()), name_filter)
        dialog.setObjectName(f"{NAME}_file")
        dialog.setFileMode(mode)
        dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.fileSelected.connect(guarded(lambda path: self.install(Path(path))))
        dialog.open()

    # --- its widgets -------------------------------------------------------------------------------

    def _make(self) -> None:
        self.intro, self.place, self.status = (_label(self, name) for name in ("intro", "place", "status"))
        self.error = _label(self, "error")
        self.error.setStyleSheet(f"color: {letters(ERROR)};")
        self.error.hide()
        self.place.setText(_place_words(self.target))
        self.list = QtGui.QListWidget()
        self.list.setObjectName(f"{NAME}_list")
        self.list.setAccessibleName(tr("Packages to install"))
        self.list.itemChanged.connect(guarded(self._show_state))
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 0)  # pip does not say how much there is to come
        self.details = QtGui.QPlainTextEdit()
        self.details.setObjectName(f"{NAME}_details")
        self.details.setAccessibleName(tr("Details"))
        self.details.setReadOnly(True)
        self.details.setMinimumHeight(DETAILS_PX)
        self.details.hide()
        self.install_button = _button(self, "install", tr("Install"), self.install_from_index)
        self.files_button = _button(self, "files", tr("From files"))
        menu = QtGui.QMenu(self.files_button)
        menu.addAction(tr("From a zip…")).triggered.connect(guarded(self._from_zip))
        menu.addAction(tr("From a folder…")).triggered.connect(guarded(self._from_folder))
        self.files_button.setMenu(menu)
        self.details_button = _button(self, "details_button", tr("Details"))
        self.details_button.setCheckable(True)
        self.details_button.toggled.connect(guarded(lambda shown: self.details.setVisible(shown)))
        self.close_button = _button(self, "close", tr("Close"), self._close_or_cancel)

    def install_from_index(self) -> None:
        """Install from Python's package index: the only thing here that takes something from the internet."""
        self.install()

    def _arrange(self) -> None:
        column = QtGui.QVBoxLayout(self)
        for widget in (self.intro, self.list, self.place, self.bar, self.status, self.error, self.details):
            column.addWidget(widget)
        column.setStretchFactor(self.list, 1)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.install_button)
        row.addWidget(self.files_button)
        row.addStretch()
        row.addWidget(self.details_button)
        row.addWidget(self.close_button)
        column.addLayout(row)


def begin_to_work() -> None:
    """Let commands see what was installed, and compile what a first cut needs."""
    if missing_packages.why_not():
        return
    from CNCStepper.workbench import first_run
    from CNCStepper.workbench.calculation import kernel_warmup

    kernel_warmup.begin()
    first_run.show_once()
    command.look_again(*(name for name in FreeCADGui.listCommands() if name.startswith("CNCStepper_")))


def _about(need: dependencies.Need) -> str:
    version = dependencies.pins().get(need.pip, "")
    return f"{need.pip} {version} – {', '.join(tr(PURPOSES[purpose]) for purpose in need.purposes)}"


def _place_words(target: Path) -> str:
    words = [tr("'Install' fetches them from Python's package index and puts them into:"), str(target)]
    if name := container():
        words.append(
            tr(
                "FreeCAD runs as {0}, which nothing can be written into: this folder is outside, and stays with the "
                "next one."
            ).format(name)
        )
    return "\n".join(words)


def _label(parent: Any, name: str) -> Any:
    label = QtGui.QLabel(parent)
    label.setObjectName(f"{NAME}_{name}")
    label.setWordWrap(True)
    label.setTextFormat(QtCore.Qt.TextFormat.PlainText)
    label.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
    return label


def _button(parent: Any, name: str, text: str, pressed: Any = None) -> Any:
    button = QtGui.QPushButton(text, parent)
    button.setObjectName(f"{NAME}_{name}")
    button.setAutoDefault(False)
    if pressed is not None:
        button.clicked.connect(guarded(pressed))
    return button
