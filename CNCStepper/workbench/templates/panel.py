# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel *Template*: a template of the shop, its rules, which contours each takes, and the job that they make.

template file, or the job ──► Draft ──► list and form of rules ──typed──► Draft ──► TemplateQuestion
                                                                            └──► counts, contours in the 3D view
OK ──► TemplateQuestion with "make" ──► `template_jobs.made`: one undo step
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.job.drawings.packed_curves import unpacked_curves
from CNCStepper.job.templates.template import template_of
from CNCStepper.job.templates.template_files import template_folder, template_paths, with_whole_paths, write_template
from CNCStepper.machine.files.profile_files import SUFFIX
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.workbench import packages
from CNCStepper.workbench.calculation.remake_beside import DONE, RemakeBeside
from CNCStepper.workbench.document import targets, undo_steps
from CNCStepper.workbench.document.template_jobs import TemplateQuestion, asked_of, made, new_template
from CNCStepper.workbench.features.base import JOB, proxy_type
from CNCStepper.workbench.features.drawings.drawing import path_of
from CNCStepper.workbench.panels.background_panel import button_row
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, NAME, WorkNote, named_button, note_label
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded, note
from CNCStepper.workbench.services.object_observers import ProgramObserver
from CNCStepper.workbench.services.standard_buttons import PanelButtons
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.services.view_fit import show_all
from CNCStepper.workbench.templates.draft import Content, Draft, rule_of, texts_of
from CNCStepper.workbench.templates.rule_form import RuleForm
from CNCStepper.workbench.templates.rule_list import RuleList
from CNCStepper.workbench.templates.taken_view import TakenView
from CNCStepper.workbench.templates.tool_dialog import open_template_tools

ASK_AFTER_MS = 200  # without a key
STOCK = ("thickness_mm", "margin_mm")
FILTERS = f"*{SUFFIX}"
NEW = ""  # the choice of a template that is made from the job
Work = Callable[[], None]


class TemplatePanel(PanelButtons):
    """The interface for FreeCAD's task view; nothing of the document changes before OK."""

    def __init__(self, drawing: Any):
        import FreeCADGui

        self.drawing, self._place = drawing, (drawing.Document.Name, drawing.Name)
        self._question: TemplateQuestion | None = None
        self._answer: Content | None = None
        self._making: Iterator[None] | None = None
        self._remaking: RemakeBeside | None = None
        self.draft = Draft({}, path_of(drawing))
        self._watch = ProgramObserver(drawing, lambda: None, self._close_soon, self._document_closing)
        self._view = TakenView(FreeCADGui.getDocument(drawing.Document.Name).activeView())
        self._build()
        self.form.destroyed.connect(self._leave)  # however FreeCAD closes the panel
        self._timer = QtCore.QTimer(self.form)
        self._timer.setSingleShot(True)
        self._timer.setInterval(ASK_AFTER_MS)
        self._timer.timeout.connect(guarded(self._ask))
        self._load()

    # --- the parts ---------------------------------------------------------------------------------

    def _build(self) -> None:
        self.form = QtGui.QWidget()
        self.form.setObjectName(f"{NAME}_Template")
        self.form.setWindowTitle(tr("Template: {0}").format(self.drawing.Label))
        self.template = self._box("template", tr("Template"), self._templates())
        self.template.activated.connect(guarded(lambda *_: self._load()))
        milled = [job for job in targets.jobs() if proxy_type(job) == JOB]
        jobs = [(job.Name, tr("{0}: its operations are replaced").format(job.Label)) for job in milled]
        self.job = self._box("template_job", tr("Job"), [(NEW, tr("New job")), *jobs])
        bare = next((job.Name for job in milled if not job.Operations), NEW)
        self.job.setCurrentIndex(self.job.findData(bare))
        self.stock = {
            "thickness_mm": self._line("template_thickness", tr("Thickness"), tr("Of the stock, in mm")),
            "margin_mm": self._line("template_margin", tr("Margin"), tr("Of the stock around the drawing, in mm")),
            "material": self._line("template_material", tr("Material"), tr("As the machine's cut charts name it")),
        }
        self.rules, self.rule = RuleList(self._act, self.form), RuleForm(self.form)
        self.rules.chosen.connect(guarded(lambda row: self._show(row)))
        self.rule.changed.connect(guarded(self._typed))
        self.problem = note_label(f"{NAME}_template_problem", ERROR_COLOUR, self.form)
        self.work = WorkNote(f"{NAME}_template_work", self.form)
        self.counts = QtGui.QLabel(self.form)
        self.counts.setObjectName(f"{NAME}_template_counts")
        self.counts.setWordWrap(True)
        self._lay_out()

    def _lay_out(self) -> None:
        files = (
            ("template_open", tr("Open…"), tr("Take the template of a file"), self._ask_to_open),
            ("template_save", tr("Save as…"), tr("Save these rules as a template of the shop"), self._ask_to_save),
        )
        head, foot = QtGui.QFormLayout(), QtGui.QFormLayout()
        head.addRow(tr("Template"), self.template)
        head.addRow(button_row(files, self.form))
        tip = tr("Add, change and delete the tools of this template")
        self.tools = named_button(f"{NAME}_template_tools", tr("Tools…"), tip, self._ask_tools, self.form)
        for line in self.stock.values():
            head.addRow(line.accessibleName(), line)
        head.addRow(self.tools)
        foot.addRow(tr("Job"), self.job)
        column = QtGui.QVBoxLayout(self.form)
        column.addLayout(head)
        for widget in (self.rules, self.counts, self.rule, self.work, self.problem):
            column.addWidget(widget)
        column.addLayout(foot)

    def _box(self, name: str, label: str, choices: list[tuple[str, str]]) -> Any:
        box = QtGui.QComboBox(self.form)
        box.setObjectName(f"{NAME}_{name}")
        box.setAccessibleName(label)
        box.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        for value, words in choices:
            box.addItem(words, value)
        return box

    def _line(self, name: str, label: str, tip: str) -> Any:
        line = QtGui.QLineEdit(self.form)
        line.setObjectName(f"{NAME}_{name}")
        line.setAccessibleName(label)
        line.setToolTip(tip)
        line.textEdited.connect(guarded(lambda *_: self._typed()))
        return line

    def _templates(self) -> list[tuple[str, str]]:
        """Return the templates to choose from: the shop's, the examples, and a new one where a job gives its tools."""
        examples = sorted((packages.ROOT / "examples" / "templates").glob(FILTERS))
        new = [(NEW, tr("New, with the tools of the job"))] if _job() is not None else []
        shop = [(str(path), path.stem) for path in template_paths()]
        return [*shop, *new, *((str(path), tr("{0} (example)").format(path.stem)) for path in examples)]

    # --- the template ------------------------------------------------------------------------------

    def _load(self) -> None:
        """Show the template that is chosen, from its file or from the job."""
        path = self.template.itemData(self.template.currentIndex())
        try:
            self._take(_read(Path(path)) if path else self._new())
        except CNCStepperError as error:
            self._say(translated(error.sentence))

    def _new(self) -> Draft:
        return Draft(new_template(self.drawing, _job()), path_of(self.drawing).with_suffix(SUFFIX))

    def _take(self, draft: Draft) -> None:
        self.draft, self._answer = draft, None
        for key in STOCK:
            value = draft.content["stock"].get(key)
            self.stock[key].setText("" if value is None else f"{value:.10g}")
        self.stock["material"].setText(str(draft.content.get("material", "")))
        self._refill(0)
        self._ask()

    def open_template(self, path: str) -> None:
        """Take the template of a file, and list it."""
        self.template.addItem(Path(path).stem, path)
        self.template.setCurrentIndex(self.template.count() - 1)
        self._load()

    def save_template(self, path: str) -> None:
        """Write the rules as they are here, and go on with that file."""
        target = Path(path)
        content = with_whole_paths(self.draft.content, self.draft.path.parent)
        write_template(content, target)
        note(tr("{0} was written").format(target))
        self.draft.content, self.draft.path = copy.deepcopy(content), target
        if self.template.findData(str(target)) < 0:
            self.template.addItem(target.stem, str(target))
        self.template.setCurrentIndex(self.template.findData(str(target)))

    # --- rules -------------------------------------------------------------------------------------

    def _act(self, what: str) -> None:
        """Add, delete or move the marked rule."""
        row, last = self.rules.row, len(self.draft.rules) - 1
        if what == "add":
            row = self.draft.add(min(row, last))
        elif 0 <= row <= last:
            if what == "delete":
                self.draft.delete(row)
                row = min(row, last - 1)
            else:
                row = self.draft.move(row, -1 if what == "up" else 1)
        self._answer = None
        self._refill(row)
        self._timer.start()

    def _typed(self) -> bool:
        """Take what a person has typed, or say what is wrong with it; return whether all of it could be taken."""
        row, before = self.rules.row, copy.deepcopy(self.draft.content)
        try:
            for key in STOCK:
                self.draft.put_stock(key, self.stock[key].text())
            self.draft.put_material(self.stock["material"].text())
            if 0 <= row < len(self.draft.rules):
                self.draft.rules[row] = rule_of(self.rule.read(), self.draft.rules[row])
        except Refused as error:
            self._say(tr(error.sentence).format(*map(translated, error.values)))
            return False
        except CNCStepperError as error:
            self._say(translated(error.sentence))
            return False
        if self.draft.content != before or self._answer is None:
            self._answer = None
            self._list(row)
            self._timer.start()
        self._say("")
        return True

    def _refill(self, row: int) -> None:
        self._list(row)
        self._show(row)

    def _list(self, row: int) -> None:
        counts = [taken["count"] for taken in self._answer["rules"]] if self._answer else None
        untaken = self._answer["untaken"]["count"] if self._answer else 0
        self.rules.show_rules(self.draft.rules, counts, untaken, row)

    def _show(self, row: int) -> None:
        """Show a rule in the form, and its contours in the 3D view; the last row has those of no rule."""
        is_rule = 0 <= row < len(self.draft.rules)
        self.rule.setVisible(is_rule)
        if is_rule:
            self.rule.show_rule(texts_of(self.draft.rules[row]), self.draft.tools, self.draft.sheet_cuts)
        taken = self._answer and (self._answer["rules"][row] if is_rule else self._answer["untaken"])
        self._view.draw(unpacked_curves(taken["curves"]) if taken and row >= 0 else (), untaken=not is_rule)
        self.counts.setText("\n".join(map(_count_words, taken["rows"])) if taken and row >= 0 else "")

    def _ask_tools(self) -> None:
        """Let a person change the template's tools; the rule that is shown then offers them."""
        if self._typed():
            open_template_tools(self.draft, lambda: self._show(self.rules.row), self.form)

    # --- the process -------------------------------------------------------------------------------

    def _ask(self) -> None:
        """Ask which contours each rule takes."""
        self._begin(False, self._counted)

    def _begin(self, make: bool, done: Callable[[Content], None]) -> None:
        self._end_question()
        self.work.say(tr("Making the job…") if make else tr("Reading the drawing…"))
        self.work.begin()
        asked = asked_of(self.drawing, self.draft.content, self.draft.path, make)
        self._question = TemplateQuestion(asked, guarded(done), guarded(self._failed))
        self._question.begin()

    def _end_question(self) -> None:
        self._timer.stop()
        self.work.end()
        self._forget_question()

    def _forget_question(self) -> None:
        if self._question is not None:
            self._question.end()
            self._question = None

    def _leave(self, *_form: Any) -> None:
        """Take back what is begun, in the document and in its view; a second time there is nothing."""
        self._watch.end()
        self._undo()
        self._forget_question()
        self._view.end()

    def _counted(self, answer: Content) -> None:
        self._end_question()
        self._say("")
        self._answer = answer
        row = self.rules.row
        self._list(row)
        self._show(row)

    def _failed(self, error: CNCStepperError) -> None:
        self._end_question()
        self._say(translated(error.sentence))

    def _say(self, sentence: str) -> None:
        self.problem.setText(sentence)
        self.problem.setVisible(bool(sentence))

    # --- FreeCAD's buttons -------------------------------------------------------------------------

    @guarded
    def accept(self) -> bool:
        """Make the job, and close when it is made; stay open where it cannot be. FreeCAD calls this for OK."""
        if self._remaking is None and self._typed():
            self._begin(True, self._make)
        return False

    def _make(self, answer: Content) -> None:
        """Begin to make the objects as one undo step."""
        import FreeCAD

        self._end_question()
        document = FreeCAD.listDocuments().get(self._place[0])
        if document is None or document.getObject(self._place[1]) is None:
            self._close()
            return
        job = document.getObject(self.job.itemData(self.job.currentIndex())) if self.job.currentIndex() else None
        undo_steps.begin(document, tr("Template"))
        self.work.say(tr("Making the job…"))
        self.work.begin()
        self._making = made(self.drawing, answer, job)
        self._remaking = RemakeBeside(document, lambda words: self.work.say(tr(words)), guarded(self._made))
        self._step()

    def _step(self) -> None:
        """Make an object of the job, and the next when the window has seen to its events; then what they cut."""
        if self._making is None or self._remaking is None:
            return
        try:
            more = next(self._making, DONE) is not DONE
        except CNCStepperError as error:
            self._undo()
            self._failed(error)
            return
        except Exception:
            self._undo()
            raise
        if more:
            QtCore.QTimer.singleShot(0, guarded(self._step))
        else:
            self._remaking.begin()

    def _made(self) -> None:
        """End the undo step and the panel."""
        import FreeCAD

        self._making = self._remaking = None
        document = FreeCAD.listDocuments().get(self._place[0])
        if document is not None:
            document.commitTransaction()
        self._close()
        QtCore.QTimer.singleShot(0, guarded(show_all))  # an event of its own: each takes some 20 ms

    def _undo(self) -> None:
        """Take back what is made of the job so far."""
        import FreeCAD

        if self._remaking is None:
            return
        self._remaking.end()
        self._making = self._remaking = None
        document = FreeCAD.listDocuments().get(self._place[0])
        if document is not None:
            document.abortTransaction()

    @guarded
    def reject(self) -> bool:
        """Make nothing; FreeCAD calls this for Cancel and Esc."""
        self._close()
        return True

    def _document_closing(self, name: str) -> None:
        if name == self._place[0]:
            self._close_soon()

    def _close_soon(self) -> None:
        """Close when the drawing, or its document, is gone."""
        self._forget_question()
        QtCore.QTimer.singleShot(0, guarded(self._close))

    def _close(self) -> None:
        import FreeCADGui

        self._end_question()
        self._leave()
        FreeCADGui.Control.closeDialog()

    # --- files -------------------------------------------------------------------------------------

    def _ask_to_open(self) -> None:
        dialog = self._dialog(tr("Open template"), self.open_template)
        dialog.setFileMode(dialog.FileMode.ExistingFile)
        dialog.open()

    def _ask_to_save(self) -> None:
        dialog = self._dialog(tr("Save template"), self.save_template)
        dialog.setFileMode(dialog.FileMode.AnyFile)
        dialog.setAcceptMode(dialog.AcceptMode.AcceptSave)
        dialog.setDefaultSuffix(SUFFIX[1:])
        dialog.selectFile(self.draft.path.name)
        dialog.open()

    def _dialog(self, title: str, take: Callable[[str], None]) -> Any:
        import FreeCADGui

        folder = template_folder()
        folder.mkdir(parents=True, exist_ok=True)
        dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), title, str(folder))
        dialog.setObjectName("CNCStepper_Template_file")
        dialog.setNameFilters([tr("Templates ({0})").format(FILTERS), tr("All files ({0})").format("*")])
        dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.fileSelected.connect(guarded(take))
        return dialog


def _read(path: Path) -> Draft:
    """Return the template of a file; raises JobError for one that is none."""
    content = read_toml(path)
    template_of(content, path)
    return Draft(content, path)


def _job() -> Any:
    """Return the job of the document that is meant, None for one of a lathe."""
    job = targets.job()
    return job if job is not None and proxy_type(job) == JOB else None


def _count_words(row: list[Any]) -> str:
    layer, colour, closed, opened, length_mm = row
    return tr("layer '{0}' {1}: {2} closed, {3} open, {4} mm").format(layer, colour, closed, opened, f"{length_mm:.5g}")


def open_template_panel(drawing: Any) -> None:
    """Show the panel of a drawing."""
    import FreeCADGui

    packages.require()
    FreeCADGui.Control.showDialog(TemplatePanel(drawing))
