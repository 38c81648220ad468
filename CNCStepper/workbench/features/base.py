# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of all document objects: a table of properties, and a proxy that survives save and reopen.

A property has two names: `key`, by which job files, cycles and scripts know it, with the unit as its
suffix ("depth_mm"), and `name`, by which FreeCAD's property editor shows it ("Depth"), with a unit of
its own. Everything that crosses between the two passes `value_of` and `set_value` here.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from CNCStepper.errors import CNCStepperError, JobError, Text
from CNCStepper.units import mm_min_from_mm_s, mm_s_from_mm_min
from CNCStepper.workbench.services import object_observers
from CNCStepper.workbench.services.jit_guard import without_compiling
from CNCStepper.workbench.services.translation import later

JOB = "CNCStepper_Job"
LATHE_JOB = "CNCStepper_LatheJob"
JOBS = (JOB, LATHE_JOB)
TOOLS = ("CNCStepper_Tool", "CNCStepper_TurningTool")
FAILED = "object-failed"  # the code of an error that another object has caused
STALE = "object-stale"  # and of one that says only that something has to be made again
HIDDEN = 2  # FreeCAD's mode of a property that its editor does not show
OUTPUT = 8  # FreeCAD's Prop_Output: a change of it makes nothing out of date
SPEED = "App::PropertySpeed"  # FreeCAD keeps speeds in mm/s, everything of ours is mm/min
DISTANCE = "App::PropertyDistance"  # not PropertyLength: that turns a negative value into 0 without a word
ANGLE = "App::PropertyAngle"
POSITION = "App::PropertyVectorDistance"
POINTS = "App::PropertyVectorList"
ENUMERATION = "App::PropertyEnumeration"
INTEGER = "App::PropertyInteger"
BOOL = "App::PropertyBool"
TEXT = "App::PropertyString"
LINK = "App::PropertyLink"
DRAWINGS = "App::PropertyLinkSubListGlobal"  # inside parts too; FreeCAD follows faces and edges that get new numbers
CONTAINERS = "App::PropertyLinkListGlobal"
FLOAT = "App::PropertyFloat"
NUMBERS = (SPEED, DISTANCE, ANGLE, FLOAT)


@dataclass(frozen=True)
class Property:
    """One property of a document object; `default` is a value for `key`, in the unit that its suffix names.

    group, label, text: English, marked for the translators with `later`; a panel shows the label and explains it
    with the text. choices: of an enumeration. output: shown, saved, and set by the object alone. only: the key of
    another property and those of its values with which this one counts; () where it always does. plane: whether only
    X and Y of a position count.
    """

    key: str
    name: str
    type: str
    group: str
    label: str
    text: str
    default: Any = None
    choices: tuple[str, ...] = ()
    output: bool = False
    only: tuple[str, tuple[str, ...]] | tuple[()] = ()
    plane: bool = False


PROBLEM = Property(
    "problem", "Problem", TEXT, later("Problem"), later("Problem"), later("Why it cannot be made; empty when it can"),
    "", output=True,
)  # fmt: skip


IDENTITY = Property(
    "identity", "Identity", TEXT, later("Problem"), later("Identity"),
    later("The document and the name of the object itself; a copy still has those of its original"), "", output=True,
)  # fmt: skip


class Feature:
    """The proxy that all our document objects have in common.

    An object that cannot be made says so in its property "Problem" (`problem_of`) and not by FreeCAD's own error
    state: that is only set by an exception, which FreeCAD prints with its traceback into the report view, and
    then leaves all that stands on the object as it was.
    """

    Type = ""
    PROPERTIES: tuple[Property, ...] = ()
    WHY_FIXED = ""  # why some of them cannot be typed
    JOB_TYPE = JOB  # in which jobs it belongs
    refusal: CNCStepperError | None = None  # why the last `make` failed
    is_copy = False  # whether FreeCAD has copied or pasted the object since the document was opened
    original_name = ""  # of the object that it is a copy of, where that is in the same document

    def __init__(self, obj: Any):
        obj.Proxy = self
        self.add_properties(obj)
        object_observers.announce(obj)

    def add_properties(self, obj: Any) -> None:
        """Add the properties and choices that `obj` lacks, which in a document of an older version may be some."""
        for entry in (*self.PROPERTIES, PROBLEM, IDENTITY):
            if entry.name not in obj.PropertiesList:
                _add_property(obj, entry)
            elif set(entry.choices) - set(obj.getEnumerationsOfProperty(entry.name) or ()):
                chosen = getattr(obj, entry.name)
                setattr(obj, entry.name, list(entry.choices))
                setattr(obj, entry.name, chosen)
        self.identify(obj)

    def identify(self, obj: Any) -> None:
        """Note whether the object is a copy, and of which one: a copy still has the identity of its original."""
        document, _, name = obj.Identity.partition(" ")
        own = f"{obj.Document.Uid} {obj.Name}"
        if obj.Identity == own:
            return
        self.is_copy = bool(name)
        self.original_name = name if document == obj.Document.Uid else ""
        obj.Identity = own
        obj.setEditorMode(IDENTITY.name, HIDDEN)

    def given(self, found: dict[str, Any]) -> dict[str, Any]:
        """Return those of an object's values, by key, that the core is to be given."""
        return found

    def counts(self, entry: Property, found: dict[str, Any]) -> bool:
        """Return whether a property counts with an object's other values, by key."""
        if not entry.only:
            return True
        chooser, choices = entry.only
        return found.get(chooser) in choices and self.counts(entry_of(self, chooser), found)

    def show_what_counts(self, obj: Any) -> None:
        """Hide the properties that do not count."""
        found = self.known(obj)
        for entry in self.PROPERTIES:
            if entry.only:
                obj.setEditorMode(entry.name, 0 if self.counts(entry, found) else HIDDEN)

    def known(self, obj: Any) -> dict[str, Any]:
        """Return the object's values by key, and what else decides which of them count."""
        return values(obj)

    def check(self, obj: Any) -> None:
        """Raise a CNCStepperError for a property of `obj` that is invalid whatever it depends on."""

    def question(self, obj: Any) -> dict[str, Any] | None:
        """Return what the cut process is to be asked before `obj` is made, None where it need not.

        Raises the CNCStepperError for which `make` would refuse without any cut.
        """
        self.check(obj)
        return None

    def make(self, obj: Any) -> None:
        """Make the content of `obj` from its properties; raises a CNCStepperError with an advice."""

    def execute(self, obj: Any) -> None:
        """Make `obj` for FreeCAD; an error is shown on it and invalidates the dependent programs."""
        try:
            with without_compiling():
                self.make(obj)
        except CNCStepperError as error:
            self._refuse(obj, error)
        except Exception as error:
            self._take_back(obj, str(error))
            raise
        else:
            self.refusal = None
            obj.Problem = ""

    def _refuse(self, obj: Any, error: CNCStepperError) -> None:
        self.refusal = error.with_traceback(None)
        obj.Problem = error.sentence
        self._take_back(obj, error.sentence)

    def _take_back(self, obj: Any, why: str) -> None:
        """Take back the programs that stand on `obj` now, whether FreeCAD recomputes their jobs or not."""
        for job in [obj, *obj.InListRecursive]:
            if is_job(job):
                job.Proxy.invalidate(job, named(obj, why))

    def onDocumentRestored(self, obj: Any) -> None:
        """Let a document of an older version catch up; FreeCAD calls this after opening it."""
        self.add_properties(obj)
        object_observers.announce(obj)

    def __getstate__(self) -> None:
        """Keep nothing in the proxy: all state is in properties (FreeCAD before 0.21)."""

    def __setstate__(self, state: Any) -> None:
        """Restore nothing (FreeCAD before 0.21)."""

    def dumps(self) -> None:
        """Keep nothing in the proxy: all state is in properties (FreeCAD from 0.21 on)."""

    def loads(self, state: Any) -> None:
        """Restore nothing (FreeCAD from 0.21 on)."""


def _add_property(obj: Any, entry: Property) -> None:
    obj.addProperty(entry.type, entry.name, entry.group, entry.text, OUTPUT if entry.output else 0)
    if entry.choices:
        setattr(obj, entry.name, list(entry.choices))
    if entry.default is not None:
        set_value(obj, entry, entry.default)
    if entry.output:
        obj.setEditorMode(entry.name, 1)


def original_of(obj: Any) -> Any:
    """Return the object of the same document that one of ours was copied from, None for none of its kind."""
    obj.Proxy.identify(obj)
    name = obj.Proxy.original_name
    original = obj.Document.getObject(name) if name and name != obj.Name else None
    return original if proxy_type(original) == proxy_type(obj) else None


def entry_of(proxy: Feature, key: str) -> Property:
    """Return the property of that key."""
    return next(entry for entry in proxy.PROPERTIES if entry.key == key)


def proxy_type(obj: Any) -> str:
    """Return which of our document objects `obj` is, as "CNCStepper_Job", or "" for one that is not ours."""
    return getattr(getattr(obj, "Proxy", None), "Type", "")


def is_job(obj: Any) -> bool:
    """Return whether an object is one of our jobs, a lathe's or another machine's."""
    return proxy_type(obj) in JOBS


def is_tool(obj: Any) -> bool:
    """Return whether an object is one of our tools, a lathe's or a cutter."""
    return proxy_type(obj) in TOOLS


def problem_of(obj: Any) -> str:
    """Return why one of our objects cannot be made, or ""; its dependents name it and its reason."""
    problem = getattr(obj, PROBLEM.name, "") if proxy_type(obj) else ""
    refusal = obj.Proxy.refusal if problem else None
    return refusal.sentence if refusal is not None and refusal.sentence == problem else problem


def require_parts(parts: Iterable[Any]) -> None:
    """Raise JobError that names the first of the objects that has a problem, in FreeCAD's eyes or ours."""
    for part in parts:
        if problem_of(part):
            raise JobError(FAILED, named(part, problem_of(part)))
        if not part.isValid():
            raise JobError(FAILED, named(part, part.getStatusString()), advice="mend that object first")


def named(obj: Any, sentence: str) -> str:
    """Return a sentence about `obj` that begins with its label, once."""
    return sentence if sentence.startswith(f"{obj.Label}: ") else Text("{label}: {why}", label=obj.Label, why=sentence)


def value_of(obj: Any, entry: Property) -> Any:
    """Return a property's value in the unit that its key names."""
    value = getattr(obj, entry.name)
    if entry.type in NUMBERS:
        number = float(getattr(value, "Value", value))
        return round(mm_min_from_mm_s(number), 6) if entry.type == SPEED else number
    if entry.type == POSITION:
        return tuple(value)[: 2 if entry.plane else 3]
    if entry.type == POINTS and entry.plane:
        return [tuple(point)[:2] for point in value]
    if entry.type == DRAWINGS:
        return drawing_pairs(value)
    return value


def set_value(obj: Any, entry: Property, value: Any) -> None:
    """Set a property from a value in the unit that its key names; raises JobError and changes nothing."""
    if entry.type in NUMBERS:
        value = _finite(entry, value)
        value = mm_s_from_mm_min(value) if entry.type == SPEED else value
    elif entry.choices and value not in entry.choices:
        raise JobError(
            "bad-value",
            Text("{key} cannot be '{value}'", key=entry.key, value=value),
            advice=Text("choose one of: {choices}", choices=", ".join(entry.choices)),
        )
    elif entry.type == POSITION:
        value = _vector(entry, value)
    elif entry.type == POINTS:
        value = [_vector(entry, row) for row in value]
    elif entry.type == DRAWINGS:
        value = [(drawing, list(names) or "") for drawing, names in drawing_pairs(value)]
    try:
        setattr(obj, entry.name, value)
    except (TypeError, ValueError) as error:
        raise JobError(
            "bad-value",
            Text("{key} cannot be {value}: {error}", key=entry.key, value=repr(value), error=error),
            advice="correct that value",
        ) from error


def drawing_pairs(value: Any) -> tuple[tuple[Any, tuple[str, ...]], ...]:
    """Return drawings, each once with the names of its faces and edges that count, () where all of it does.

    value: an object, or a row of objects and of such pairs, as scripts and FreeCAD's own property give them.
    """
    rows = value if isinstance(value, list | tuple) else [value] if value is not None else []
    found: dict[Any, tuple[str, ...]] = {}
    for row in rows:
        drawing, names = row if isinstance(row, tuple) else (row, ())
        if drawing is None:
            continue
        given = (names,) if isinstance(names, str) else tuple(names)
        found[drawing] = tuple(dict.fromkeys((*found.get(drawing, ()), *filter(None, given))))
    return tuple(found.items())


def values(obj: Any) -> dict[str, Any]:
    """Return what the properties of one of our objects hold, by key, outputs left out."""
    return {entry.key: value_of(obj, entry) for entry in obj.Proxy.PROPERTIES if not entry.output}


def show(obj: Any, figures: dict[str, float]) -> None:
    """Set those outputs of an object that are figures: to the one of their key, or to 0."""
    for entry in obj.Proxy.PROPERTIES:
        if entry.output and entry.type in (*NUMBERS, INTEGER):
            figure = figures.get(entry.key, 0)
            set_value(obj, entry, int(figure) if entry.type == INTEGER else figure)


def edit(obj: Any, **changes: Any) -> None:
    """Set properties by key; raises JobError for an unknown key or a bad value, and then changes nothing."""
    entries = {entry.key: entry for entry in obj.Proxy.PROPERTIES if not entry.output}
    if "drawing" in changes and "drawings" in entries:  # one, as scripts of the first release have it
        one = changes.pop("drawing"), tuple(changes.pop("picked", ()))
        changes["drawings"] = drawing_pairs([one])
    unknown = sorted(set(changes) - set(entries))
    if unknown:
        raise JobError(
            "unknown-key",
            Text("{obj} has no '{unknown}'", obj=obj.Label, unknown=unknown[0]),
            advice=Text("it has: {entries}", entries=", ".join(sorted(entries))),
        )
    before = {key: getattr(obj, entries[key].name) for key in changes}
    try:
        for key, value in changes.items():
            set_value(obj, entries[key], value)
    except JobError:
        for key, old in before.items():
            setattr(obj, entries[key].name, old)
        raise


def _finite(entry: Property, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise JobError(
            "bad-value", Text("{key} must be a number", key=entry.key), value=repr(value), advice="give a finite number"
        )
    return number


def _vector(entry: Property, row: Any) -> Any:
    import FreeCAD

    numbers = [_finite(entry, number) for number in row]
    if len(numbers) not in (2, 3):
        raise JobError(
            "bad-value",
            Text("{key} needs X, Y or X, Y, Z", key=entry.key),
            value=repr(row),
            advice="give 2 or 3 numbers",
        )
    return FreeCAD.Vector(*numbers)
