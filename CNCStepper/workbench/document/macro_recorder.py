# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a transaction of ours has changed, as lines of FreeCAD's macro (Macro, Macro recording…).

    begin ──► changes of objects ──► commit ──► macro.begin(…), macro.add(…), macro.change(…), macro.commit()
                    (names only)       └─ abort ──► nothing

FreeCAD records only what passes `FreeCADGui.doCommand`, which also runs it. So the lines call `workbench/macro.py`,
which does nothing while they are written. A command that writes no line would be recorded as `Gui.runCommand`, and open
its panel again when the macro runs; `services/command.py` prevents that. Nothing that moves a machine is recorded.
"""

from __future__ import annotations

import base64
import tempfile
import zlib
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import is_job, proxy_type, value_of

GROUPS_OF_FILES = {  # what is read from files again, and the property that says that it was read in this step
    "CNCStepper_Drawing": "ReadWith",
    "CNCStepper_Slices": "MadeOf",
    "CNCStepper_Nest": "MadeOf",
    "CNCStepper_Arrangement": "MadeOf",
}
ALWAYS = ("Label", "Placement")  # of any object
OUTPUTS = ("MadeFrom", "File", "Placements")  # outputs that a recompute does not make

_following: list[Recorder] = []
_writing: list[bool] = []


def follow(document: Any, name: str) -> None:
    """Collect what the transaction of a document changes that was opened just now."""
    recorder = _recorder()
    recorder.documents.add(document.Name)
    recorder.steps[document.Name] = Step(name)


def follow_deletion(document: Any) -> None:
    """Let FreeCAD's own deletion, which has begun, be one step of the macro; FreeCAD itself writes what it deletes."""
    if document.Name not in (recorder := _recorder()).deleting:
        recorder.documents.add(document.Name)
        recorder.steps.pop(document.Name, None)
        recorder.deleting.add(document.Name)
        _write(["macro.begin('Delete')"])


def note_deletion(document: Any, name: str) -> None:
    """Write that an object goes with one that FreeCAD deletes, which writes that one alone."""
    if document.Name in _recorder().deleting:
        _write([f"macro.remove({name!r})"])


def _recorder() -> Recorder:
    import FreeCAD

    if not _following:
        _following.append(Recorder())
        FreeCAD.addDocumentObserver(_following[0])
    return _following[0]


def is_writing() -> bool:
    """Return whether lines run only to be written."""
    return bool(_writing)


class Step:
    """What one open transaction has touched so far, by the names of objects, in order."""

    def __init__(self, name: str):
        self.name = name
        self.created: dict[str, None] = {}
        self.deleted: dict[str, None] = {}
        self.extended: dict[str, list[str]] = {}
        self.changed: dict[str, dict[str, str | None]] = {}  # each property with what it was before, as text

    def delete(self, name: str) -> None:
        """Forget an object of this step, or note that an older one goes."""
        if name in self.created:
            del self.created[name]
        else:
            self.deleted[name] = None
        self.changed.pop(name, None)
        self.extended.pop(name, None)


class Recorder:
    """FreeCAD's observer of documents: follows the steps that are open.

    documents: in which one was; steps: by the name of the document; deleting: where FreeCAD is deleting objects.
    """

    def __init__(self) -> None:
        self.documents: set[str] = set()
        self.steps: dict[str, Step] = {}
        self.deleting: set[str] = set()

    def _step(self, obj: Any) -> Step | None:
        """Return the open step of an object's document; a view provider's document is the window's, without a name."""
        return self.steps.get(getattr(getattr(obj, "Document", None), "Name", ""))

    def slotCreatedObject(self, obj: Any) -> None:
        """FreeCAD calls this for each new object."""
        if step := self._step(obj):
            step.created[obj.Name] = None

    def slotDeletedObject(self, obj: Any) -> None:
        """FreeCAD calls this before an object goes."""
        if step := self._step(obj):
            step.delete(obj.Name)

    def slotAppendDynamicProperty(self, obj: Any, name: str) -> None:
        """FreeCAD calls this for each property that an object gets besides those of its type."""
        if step := self._step(obj):
            step.extended.setdefault(obj.Name, []).append(name)

    def slotBeforeChangeObject(self, obj: Any, name: str) -> None:
        """FreeCAD calls this before every change of a property."""
        if (step := self._step(obj)) and name not in (changed := step.changed.setdefault(obj.Name, {})):
            changed[name] = None if obj.Name in step.created or name == "Shape" else literal(getattr(obj, name, None))

    def slotOpenTransaction(self, document: Any, name: str) -> None:
        """FreeCAD calls this at a transaction's first change; one that was taken back before it had any is not told."""
        if (step := self.steps.get(document.Name)) and step.name != name:
            del self.steps[document.Name]

    def slotAbortTransaction(self, document: Any) -> None:
        """FreeCAD calls this when a transaction is taken back."""
        self.steps.pop(document.Name, None)
        self._end_deletion(document)

    def slotDeletedDocument(self, document: Any) -> None:
        """FreeCAD calls this before a document goes."""
        self.steps.pop(document.Name, None)
        self.documents.discard(document.Name)
        self.deleting.discard(document.Name)

    def _end_deletion(self, document: Any) -> None:
        if document.Name in self.deleting:
            self.deleting.remove(document.Name)
            _write(["macro.commit()"])

    def slotUndoDocument(self, document: Any) -> None:
        """Write that a step was undone; FreeCAD would not where its undo has ended an open step, which is written."""
        self._write_going_back(document, "undo")

    def slotRedoDocument(self, document: Any) -> None:
        """Write that a step was done again."""
        self._write_going_back(document, "redo")

    def _write_going_back(self, document: Any, way: str) -> None:
        self.steps.pop(document.Name, None)  # what a step that is open has collected is that of the undo or redo
        if document.Name in self.documents:  # in others FreeCAD's own line does
            _write([f"macro.{way}()"])

    def slotCommitTransaction(self, document: Any) -> None:
        """Write what the transaction has done; FreeCAD calls this when it is kept."""
        self._end_deletion(document)
        step = self.steps.pop(document.Name, None)
        if step is not None and (lines := list(lines_of(document, step))):
            _write(lines)


def _write(lines: Iterable[str]) -> None:
    """Let FreeCAD record lines, which it runs: they do nothing meanwhile."""
    import FreeCADGui

    _writing.append(True)
    try:
        FreeCADGui.doCommand("\n".join(["from CNCStepper.workbench import macro", *lines]))
    finally:
        _writing.pop()


def lines_of(document: Any, step: Step) -> Iterator[str]:
    """Yield the lines that do again what a step has done; none for a step that touched nothing."""
    touched = [name for name in {**step.created, **step.changed} if document.getObject(name) is not None]
    read = [name for name in touched if _was_read(document.getObject(name), step)]
    inside = {each for name in read for each in held_by(document.getObject(name))}
    made = [name for name in touched if name not in inside]
    changes = [line for name in made for line in _change_lines(document.getObject(name), step)]
    new = [_add_line(document.getObject(name)) for name in made if name in step.created]
    gone = [f"macro.remove({name!r})" for name in step.deleted if name not in inside]
    if touched and not (new or changes or read or gone):  # FreeCAD keeps it all the same: an undo takes it back
        changes = [f"macro.unchanged({touched[0]!r})"]
    if new or changes or read or gone:
        yield f"macro.begin({step.name!r})"
        yield from new
        yield from changes
        yield from (f"macro.read({name!r})" for name in read)
        yield from gone
        yield "macro.commit()"


def _was_read(obj: Any, step: Step) -> bool:
    """Return whether a step has read the files of a group."""
    return GROUPS_OF_FILES.get(proxy_type(obj)) in step.changed.get(obj.Name, ())


def held_by(group: Any) -> Iterator[str]:
    """Yield the names of all objects in a group, and in those."""
    for each in getattr(group, "Group", ()):
        yield each.Name
        yield from held_by(each)


def _add_line(obj: Any) -> str:
    """Return the line that makes an object, of ours by the class of its proxy."""
    if not proxy_type(obj):
        return f"macro.add({obj.Name!r}, {obj.TypeId!r})"
    kind = type(obj.Proxy)
    more = f", {obj.ShapeKind!r}" if hasattr(obj, "ShapeKind") else ""
    return f'macro.add({obj.Name!r}, {obj.TypeId!r}, "{kind.__module__}.{kind.__qualname__}"{more})'


def _change_lines(obj: Any, step: Step) -> Iterator[str]:
    """Yield the lines that give an object its properties."""
    changed = step.changed.get(obj.Name, {})
    own = bool(proxy_type(obj))
    if not own:
        for name in step.extended.get(obj.Name, ()):
            yield f"macro.extend({obj.Name!r}, {obj.getTypeIdOfProperty(name)!r}, {name!r})"
    is_new = obj.Name in step.created
    names = _own_names(obj, changed, is_new) if own else _plain_names(obj, changed, is_new)
    values = {name: literal(getattr(obj, name)) for name in names}
    if given := [f"{name}={value}" for name, value in values.items() if value not in (None, changed[name])]:
        yield f"macro.change({obj.Name!r}, {', '.join(given)})"
    yield from (f"# {obj.Name}.{name} cannot be written as text" for name, value in values.items() if value is None)
    if own and "Program" in changed and not is_job(obj):  # a job makes its own
        yield f"macro.program({obj.Name!r}, {program_file.load(obj)!r})"


def _own_names(obj: Any, changed: Iterable[str], is_new: bool) -> list[str]:
    """Return the changed properties of one of our objects that a recompute does not make, usual values left out."""
    entries = [entry for entry in obj.Proxy.PROPERTIES if not entry.output and entry.name in changed]
    given = [entry.name for entry in entries if not (is_new and value_of(obj, entry) == entry.default)]
    return [*(name for name in ALWAYS if name in changed), *given, *(name for name in OUTPUTS if name in changed)]


def _plain_names(obj: Any, changed: Iterable[str], is_new: bool) -> list[str]:
    """Return the changed properties of another's object that can be set; an older one makes its shape itself."""
    kept = set(obj.PropertiesList) - {"Visibility", "ExpressionEngine"} if is_new else ALWAYS
    return [name for name in changed if name in kept]


def literal(value: Any) -> str | None:
    """Return the Python text of a property's value, None where it has none."""
    if value is None or isinstance(value, bool | int | float | str):
        return repr(value)
    if isinstance(value, list | tuple | set):
        rows = [literal(each) for each in value]
        return None if None in rows else f"[{', '.join(map(str, rows))}]"
    return next((write(value) for kind, write in _kinds() if isinstance(value, kind)), None)


def _kinds() -> Iterator[tuple[type, Callable[[Any], str]]]:
    """Yield FreeCAD's kinds of values, each with how its text is written."""
    import FreeCAD
    import Part

    yield FreeCAD.Vector, lambda each: repr(tuple(each))
    yield FreeCAD.Units.Quantity, lambda each: repr(each.Value)
    yield FreeCAD.Placement, lambda each: f"macro.placement({tuple(each.Base)}, {each.Rotation.Q})"
    yield FreeCAD.DocumentObject, lambda each: f"macro.named({each.Name!r})"
    yield Part.Shape, lambda each: f"macro.shape({_packed(each.exportBrepToString().encode())!r})"
    import Mesh

    yield Mesh.Mesh, lambda each: f"macro.mesh({_packed(_mesh_bytes(each))!r})"


def _packed(content: bytes) -> str:
    return base64.b64encode(zlib.compress(content)).decode("ascii")


def _mesh_bytes(mesh: Any) -> bytes:
    """Return a mesh as binary STL."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "mesh.stl"
        mesh.write(str(path))
        return path.read_bytes()
