# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drags in FreeCAD's tree that move parts of a job, or end on one.

FreeCAD itself replaces the row under the pointer by what is dropped on it, takes rows out of what holds them, and moves
them into other documents: each would throw an operation out of its job. Here dragging orders operations, and everything
else that would reach into a job is refused with a sentence.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from CNCStepper.workbench.document import targets, undo_steps
from CNCStepper.workbench.document.operation_order import duplicate, is_operation, job_of, move
from CNCStepper.workbench.features.base import TOOLS, is_job, proxy_type
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.messages import guarded, polled
from CNCStepper.workbench.services.translation import tr

PARTS = {*TOOLS, "CNCStepper_Preview", "CNCStepper_Program"}


@dataclass(frozen=True)
class Drop:
    """The effect of a drop: move operations next to one of their job (None: to its end), or none, with the reason."""

    job: Any = None
    operations: tuple[Any, ...] = ()
    beside: Any = None
    after: bool = True
    copies: bool = False
    why_not: str = ""

    def words(self) -> str:
        """Return for a person what would happen."""
        if self.why_not:
            return self.why_not
        if self.beside is None:
            return tr("At the end of {0}").format(self.job.Label)
        text = tr("After {0}") if self.after else tr("Before {0}")
        return text.format(self.beside.Label)

    def carry_out(self) -> None:
        """Order the operations, in one undo step."""
        document = self.job.Document
        undo_steps.begin(document, tr("Duplicate operations") if self.copies else tr("Move operations"))
        moved = duplicate(self.operations) if self.copies else self.operations
        move(self.job, moved, self.beside, self.after)
        document.commitTransaction()
        document.recompute()


def drop_of(dragged: Sequence[Any], target: Any, after: bool, copies: bool = False) -> Drop | None:
    """Return what is to happen when objects are dropped on another one (None: a document); None: what FreeCAD does.

    after: whether the pointer is on the lower half of the row. copies: whether Ctrl is held.
    """
    parts = [obj for obj in dragged if is_part(obj)]
    if not dragged or not (parts or is_part(target) or is_job(target)):
        return None
    why_not = _why_not(dragged, target)
    if why_not:
        return Drop(why_not=why_not)
    job = target if is_job(target) else job_of(target)
    beside = target if is_operation(target) else None
    return Drop(job, tuple(dragged), beside, after, copies)


def _why_not(dragged: Sequence[Any], target: Any) -> str:
    strangers = [obj for obj in dragged if not is_operation(obj)]
    if strangers:
        return tr("{0} is no operation and is not moved").format(strangers[0].Label)
    jobs = {job_of(obj) for obj in dragged}
    job = target if is_job(target) else job_of(target) if is_operation(target) else None
    if job is None:
        return tr("{0} stays in its job: drop it on another operation, or on the job").format(dragged[0].Label)
    if jobs != {job}:
        return tr("{0} stays in its job; copy and paste it into another document").format(dragged[0].Label)
    return targets.why_no_panel()


def is_part(obj: Any) -> bool:
    """Return whether an object stands below its job in the tree."""
    return is_operation(obj) or proxy_type(obj) in PARTS


def row_object(index: Any) -> Any:
    """Return the object that a row of the tree shows, None for a document or where it is not certain.

    A row knows only its label: the parts of a job are told apart by their place below it. It is asked for by its index,
    because PySide may hand out an item of the tree that FreeCAD has deleted.
    """
    import FreeCAD

    lineage = _lineage(index)
    if len(lineage) < 2:
        return None
    holder = row_object(index.parent())
    if holder is not None and is_job(holder):
        children = holder.ViewObject.Proxy.claimChildren()
        if index.row() < len(children) and children[index.row()].Label == lineage[0]:
            return children[index.row()]
    documents = [document for document in FreeCAD.listDocuments().values() if document.Label == lineage[-1]]
    found = [obj for document in documents for obj in document.getObjectsByLabel(lineage[0])]
    ours = [obj for obj in found if is_part(obj) or is_job(obj)]
    return next(iter(ours or found), None)


def _lineage(index: Any) -> list[str]:
    """Return the labels of a row and of those above it: an object, what holds it, its document."""
    labels = []
    while index.isValid():
        labels.append(index.sibling(index.row(), 0).data())
        top, index = index, index.parent()
    return labels[:-1] if labels and _is_program(top) else labels


def _is_program(top: Any) -> bool:
    """Return whether the first row of the tree stands for the program, as before FreeCAD 1.1, and no document."""
    import FreeCAD

    below = {top.model().index(row, 0, top).data() for row in range(top.model().rowCount(top))}
    return bool(below) and below <= {document.Label for document in FreeCAD.listDocuments().values()}


def install(viewport: Any) -> None:
    """Watch the drags over a tree's viewport."""
    viewport.installEventFilter(_make_filter(viewport))


def _make_filter(parent: Any) -> Any:
    """Return the filter; its class is made here because Qt is loaded only with a window."""
    from PySide import QtCore

    moves, drop = QtCore.QEvent.Type.DragMove, QtCore.QEvent.Type.Drop

    class Drops(QtCore.QObject):
        """Answers for FreeCAD's tree where a drag reaches into a job."""

        def eventFilter(self, viewport: Any, event: Any) -> bool:
            """Return whether the event goes no further."""
            if not isinstance(event, QtCore.QEvent) or event.type() not in (moves, drop):
                return False  # PySide2 may take an event for a deleted object that lay at its address
            return bool(self.answer(viewport, event, event.type() == drop))

        @polled
        def answer(self, viewport: Any, event: Any, is_drop: bool) -> bool:
            """Accept or refuse a drag, and carry out a drop when FreeCAD's own drag is over."""
            planned = _planned(viewport.parent(), event) if event.source() is viewport.parent() else None
            if planned is None:
                return False
            _show(viewport, event, planned, is_drop)
            if is_drop and not planned.why_not:
                QtCore.QTimer.singleShot(0, guarded(planned.carry_out))
            return True

    return Drops(parent)


def _planned(tree: Any, event: Any) -> Drop | None:
    import FreeCADGui
    from PySide import QtCore, QtGui

    place = event.position().toPoint() if hasattr(event, "position") else event.pos()
    index = tree.indexAt(place)
    after = place.y() > tree.visualRect(index).center().y()
    dragged = list(dict.fromkeys(FreeCADGui.Selection.getSelection("*")))
    copies = bool(QtGui.QApplication.keyboardModifiers() & QtCore.Qt.KeyboardModifier.ControlModifier)
    return drop_of(dragged, row_object(index.sibling(index.row(), 0)), after, copies)


def _show(viewport: Any, event: Any, planned: Drop, is_drop: bool) -> None:
    """Let the pointer and a tooltip show what a drop does; a refused drop is said in the status bar too."""
    from PySide import QtCore, QtGui

    ignore = QtCore.Qt.DropAction.IgnoreAction
    wanted = QtCore.Qt.DropAction.CopyAction if planned.copies else QtCore.Qt.DropAction.MoveAction
    if planned.why_not:
        messages.note(planned.why_not)
    if is_drop:
        QtGui.QToolTip.hideText()
        event.setDropAction(ignore)  # for Move Qt would take the row out of the tree
        event.accept()
        return
    event.setDropAction(ignore if planned.why_not else wanted)
    event.ignore() if planned.why_not else event.accept()
    QtGui.QToolTip.showText(QtGui.QCursor.pos(), planned.words(), viewport)
