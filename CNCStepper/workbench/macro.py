# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the lines of a recorded macro call; `document/macro_recorder.py` writes them.

    from CNCStepper.workbench import macro
    macro.begin("Rectangular pocket")
    macro.add("Pocket", "App::FeaturePython", "CNCStepper.workbench.features.rectangular_pocket.RectangularPocket")
    macro.change("Pocket", Depth=5.0, Tool=macro.named("Tool"))
    macro.commit()

All of it acts on the active document; objects are named by `Name`, properties as FreeCAD's property editor names them.
A script of one's own is easier to write with `api.py`.
"""

from __future__ import annotations

import base64
import importlib
import json
import tempfile
import zlib
from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any, TypeVar, cast

from CNCStepper.errors import JobError, Text
from CNCStepper.workbench.document.macro_recorder import is_writing

Act = TypeVar("Act", bound=Callable[..., Any])


def _repeats(act: Act) -> Act:
    """Return a function that does nothing while its line is only written."""

    @wraps(act)
    def repeat(*given: Any, **more: Any) -> Any:
        return None if is_writing() else act(*given, **more)

    return cast(Act, repeat)


def _document() -> Any:
    import FreeCAD

    return FreeCAD.ActiveDocument or FreeCAD.newDocument()


def _found(name: str) -> Any:
    obj = _document().getObject(name)
    if obj is None:
        what = Text("the macro needs the object {name}, which this document does not have", name=name)
        raise JobError("macro-object", what, advice="run it in a document like the one it was recorded in")
    return obj


@_repeats
def begin(title: str) -> None:
    """Open an undo step of that name, in a new document where none is open."""
    _document().openTransaction(title)


@_repeats
def commit() -> None:
    """Make all again and keep the undo step."""
    _document().recompute()
    _document().commitTransaction()


@_repeats
def undo() -> None:
    """Undo the last step."""
    _document().undo()
    _document().recompute()


@_repeats
def redo() -> None:
    """Do again what was undone last."""
    _document().redo()
    _document().recompute()


@_repeats
def add(name: str, freecad_type: str, proxy: str = "", kind: str = "") -> None:
    """Make an object; proxy: the class of one of ours; kind: of a shape of the library."""
    obj = _document().addObject(freecad_type, name)
    if proxy:
        module, _, class_name = proxy.rpartition(".")
        made = getattr(importlib.import_module(module), class_name)(obj)
        if kind:
            made.become(obj, kind)


@_repeats
def extend(name: str, property_type: str, property_name: str) -> None:
    """Add a property to an object."""
    _found(name).addProperty(property_type, property_name, "CNCStepper")


@_repeats
def change(name: str, **properties: Any) -> None:
    """Set properties of an object."""
    obj = _found(name)
    for key, value in properties.items():
        setattr(obj, key, value)


@_repeats
def unchanged(name: str) -> None:
    """Leave an object as it is in a step that an undo takes back: FreeCAD keeps no step in which nothing was set."""
    obj = _found(name)
    said = obj.Label2
    obj.Label2 = f"{said} "
    obj.Label2 = said


@_repeats
def remove(name: str) -> None:
    """Delete an object."""
    _document().removeObject(name)


@_repeats
def program(name: str, text: str) -> None:
    """Set the text of an edited program."""
    from CNCStepper.workbench.document import program_file

    program_file.store(_found(name), text)


@_repeats
def read(name: str) -> None:
    """Read again the files that an object follows: a drawing, slices, a nest, an arrangement."""
    from CNCStepper.workbench import api
    from CNCStepper.workbench.document.nest_files import nest_now

    obj = _found(name)
    acts: dict[str, Callable[[], None]] = {
        "CNCStepper_Drawing": lambda: api.reload_drawing(obj),
        "CNCStepper_Slices": lambda: api.slice_solid(obj),
        "CNCStepper_Nest": lambda: nest_now(obj, "write"),
        "CNCStepper_Arrangement": lambda: api.arrange_programs(obj, [row[1:5] for row in json.loads(obj.Placements)]),
    }
    acts[obj.Proxy.Type]()


@_repeats
def named(name: str) -> Any:
    """Return an object of the document."""
    return _found(name)


@_repeats
def placement(base: tuple[float, float, float], quaternion: tuple[float, float, float, float]) -> Any:
    """Return a placement from its base, mm, and the quaternion of its rotation."""
    import FreeCAD

    return FreeCAD.Placement(FreeCAD.Vector(*base), FreeCAD.Rotation(*quaternion))


@_repeats
def shape(packed: str) -> Any:
    """Return a shape from its BREP text, packed by zlib and base64."""
    import Part

    made = Part.Shape()
    made.importBrepFromString(_unpacked(packed).decode())
    return made


@_repeats
def mesh(packed: str) -> Any:
    """Return a mesh from its binary STL, packed by zlib and base64."""
    import Mesh

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "mesh.stl"
        path.write_bytes(_unpacked(packed))
        return Mesh.Mesh(str(path))


def _unpacked(packed: str) -> bytes:
    return zlib.decompress(base64.b64decode(packed))
