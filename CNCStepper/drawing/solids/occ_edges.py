# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that reads a solid with OCCT as CadQuery brings it: `python occ_edges.py FILE HEIGHT TOLERANCE`.

HEIGHT is in mm, or "outline", or "slices AXIS THICKNESS" for all sections of a stack (sheet_heights.py). FILE is STEP,
BREP, or a script (.py) whose shapes are given to `show_object` or named `result`. The answer is that of
`edge_curves.py`. It runs in CadQuery's own Python: only the standard library, OCP, and what a script imports.
`workbench/drawings/solid_edges.py` does the same inside FreeCAD.
"""

from __future__ import annotations

import importlib.util
import math
import sys
from collections.abc import Iterator
from typing import Any

from CNCStepper.drawing.solids.process_limits import answer, guard_script, limit_process, refuse
from CNCStepper.drawing.solids.sheet_heights import AXES, MOST_SLICES, asked_slices, section_heights, sheet_count
from CNCStepper.tolerances import SAME_MM

SCRIPT_MODULES = ("cadquery", "build123d")
LEVEL = 1e-9  # of a face's direction


def main(path: str, height: str, tolerance: str) -> None:
    """Answer with the edges of the solid in a file at a height, or with its triangles and level faces."""
    try:
        shape = _script_shape(path) if path.endswith(".py") else _file_shape(path)
        if asked := asked_slices(height):
            answer(_slices(shape, *asked))
        answer(_outline(shape, float(tolerance)) if height == "outline" else _at_height(shape, float(height)))
    except MemoryError:
        refuse("solid-memory", "it takes more memory than it may")
    except Exception as error:
        refuse("solid-file", f"{type(error).__name__}: {error}"[:400])


def _file_shape(path: str) -> Any:
    limit_process()
    if path.lower().endswith((".step", ".stp")):
        from OCP.IFSelect import IFSelect_ReturnStatus
        from OCP.STEPControl import STEPControl_Reader

        reader = STEPControl_Reader()
        if reader.ReadFile(path) != IFSelect_ReturnStatus.IFSelect_RetDone:
            refuse("solid-file", "it is no STEP file")
        reader.TransferRoots()
        return reader.OneShape()
    from OCP.BRep import BRep_Builder
    from OCP.BRepTools import BRepTools
    from OCP.TopoDS import TopoDS_Shape

    shape = TopoDS_Shape()
    if not BRepTools.Read_s(shape, path, BRep_Builder()):
        refuse("solid-file", "it is no BREP file")
    return shape


def _script_shape(path: str) -> Any:
    """Return what a script shows as one shape; whatever it prints goes to standard error."""
    import OCP.STEPControl  # before the guard: it and the modules of a script write caches

    assert OCP
    for name in SCRIPT_MODULES:
        if importlib.util.find_spec(name) is not None:
            importlib.import_module(name)
    with open(path, "rb") as file:
        code = compile(file.read(), path, "exec")
    shown: list[Any] = []
    names: dict[str, Any] = {"__name__": "__main__", "__file__": path}
    names["show_object"] = lambda thing, *_, **__: shown.append(thing)
    sys.stdout = sys.stderr
    guard_script()
    try:
        exec(code, names)
    except SystemExit:
        pass
    except MemoryError:
        raise
    except BaseException as error:
        refuse("solid-script", f"it ends with {type(error).__name__}: {error}"[:400])
    things = shown or [names[name] for name in ("result", "part") if name in names]
    return _compound([shape for thing in things for shape in _shapes(thing)])


def _shapes(thing: Any) -> Iterator[Any]:
    """Yield the OCCT shapes of what a CadQuery or build123d script makes."""
    if hasattr(thing, "vals"):  # a Workplane
        for value in thing.vals():
            yield from _shapes(value)
    elif hasattr(thing, "toCompound"):  # an Assembly
        yield from _shapes(thing.toCompound())
    elif isinstance(thing, list | tuple):  # build123d's ShapeList is a list
        for each in thing:
            yield from _shapes(each)
    elif getattr(thing, "part", None) is not None:  # build123d's BuildPart
        yield from _shapes(thing.part)
    elif getattr(thing, "sketch", None) is not None:  # its BuildSketch
        yield from _shapes(thing.sketch)
    elif hasattr(getattr(thing, "wrapped", None), "ShapeType"):
        yield thing.wrapped


def _compound(shapes: list[Any]) -> Any:
    if not shapes:
        refuse("solid-script", "it shows no solid: give one to show_object, or name it result")
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Compound

    builder, whole = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(whole)
    for shape in shapes:
        builder.Add(whole, shape)
    return whole


def _found(shape: Any, kind: str) -> list[Any]:
    """Return the faces or edges of a shape, each once."""
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp
    from OCP.TopoDS import TopoDS

    try:
        from OCP.TopTools import TopTools_IndexedMapOfShape as IndexedMap  # OCCT 7, which CadQuery has
    except ImportError:
        from OCP.collections import (
            IndexedMap_TopoDS_Shape_TopTools_ShapeMapHasher as IndexedMap,
        )  # OCCT 8, of build123d

    found = IndexedMap()
    TopExp.MapShapes_s(shape, getattr(TopAbs_ShapeEnum, f"TopAbs_{kind.upper()}"), found)
    cast = getattr(TopoDS, f"{kind.capitalize()}_s", None) or getattr(TopoDS, kind.capitalize())
    return [cast(found.FindKey(number)) for number in range(1, found.Extent() + 1)]


def _level_faces(shape: Any) -> dict[float, list[Any]]:
    """Return the plane faces that lie level, by their heights, mm."""
    from OCP.BRepAdaptor import BRepAdaptor_Surface
    from OCP.GeomAbs import GeomAbs_SurfaceType

    faces: dict[float, list[Any]] = {}
    for face in _found(shape, "face"):
        surface = BRepAdaptor_Surface(face)
        if surface.GetType() == GeomAbs_SurfaceType.GeomAbs_Plane:
            plane = surface.Plane()
            if abs(abs(plane.Axis().Direction().Z()) - 1.0) <= LEVEL:
                faces.setdefault(round(plane.Location().Z(), 6), []).append(face)
    return faces


def _at_height(shape: Any, height_mm: float) -> dict[str, Any]:
    """Return the edges of the level faces at a height, or of the section where there is no such face."""
    faces = [face for z, own in _level_faces(shape).items() if abs(z - height_mm) <= SAME_MM for face in own]
    if faces:
        return {"loops": [_edges(face) for face in faces]}
    return {"loops": [_section(shape, height_mm)]}


def _section(shape: Any, height_mm: float) -> list[list[Any]]:
    """Return the edges in which a shape meets a level plane."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Section
    from OCP.gp import gp_Dir, gp_Pln, gp_Pnt

    section = BRepAlgoAPI_Section(shape, gp_Pln(gp_Pnt(0, 0, height_mm), gp_Dir(0, 0, 1)), False)
    section.Approximation(False)
    section.Build()
    return _edges(section.Shape())


def _slices(shape: Any, axis: str, thickness_mm: float) -> dict[str, Any]:
    """Return the bounds and the volume of the solids, and the edges of each solid in the section of each sheet."""
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer

    loose = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE, TopAbs_ShapeEnum.TopAbs_SOLID).More()
    solids = [_upright(solid, axis) for solid in _found(shape, "solid")]
    if loose or not solids:
        refuse("slice-open", "it has a face that belongs to no solid" if loose else "it has no solid")
    bounds, volume_mm3 = Bnd_Box(), 0.0
    for solid in solids:
        BRepBndLib.AddOptimal_s(solid, bounds, False, False)
        held = GProp_GProps()
        BRepGProp.VolumeProperties_s(solid, held)
        volume_mm3 += abs(held.Mass())
    bounds.SetGap(0.0)
    low_mm, high_mm = bounds.CornerMin().Z(), bounds.CornerMax().Z()
    if sheet_count(low_mm, high_mm, thickness_mm) > MOST_SLICES:
        refuse("slice-count", f"the stack has more than {MOST_SLICES} sheets; use thicker ones")
    levels = [level for solid in solids for level in _level_faces(solid)]
    heights = section_heights(low_mm, high_mm, thickness_mm, levels)
    sections = [[_section(solid, height_mm) for solid in solids] for height_mm in heights]
    return {"low_mm": low_mm, "high_mm": high_mm, "volume_mm3": volume_mm3, "sections": sections}


def _upright(shape: Any, axis: str) -> Any:
    """Return a copy of a shape with an axis as Z, the other two in their cyclic order as X and Y."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
    from OCP.gp import gp_Trsf

    turn = gp_Trsf()
    rows = [[float(column == number) for column in range(3)] for number in AXES[axis]]
    turn.SetValues(*(value for row in rows for value in (*row, 0.0)))
    return BRepBuilderAPI_Transform(shape, turn, True).Shape()


def _outline(shape: Any, tolerance_mm: float) -> dict[str, Any]:
    from OCP.BRep import BRep_Tool
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.TopLoc import TopLoc_Location

    BRepMesh_IncrementalMesh(shape, tolerance_mm, False, 0.2)
    triangles = []
    for face in _found(shape, "face"):
        place = TopLoc_Location()
        mesh = BRep_Tool.Triangulation_s(face, place)
        if mesh is None:
            continue
        moved = place.Transformation()
        nodes = [mesh.Node(number).Transformed(moved) for number in range(1, mesh.NbNodes() + 1)]
        flat = [(node.X(), node.Y()) for node in nodes]
        triangles += [
            [flat[corner - 1] for corner in mesh.Triangle(number).Get()] for number in range(1, mesh.NbTriangles() + 1)
        ]
    levels = [[edge for face in faces for edge in _edges(face)] for faces in _level_faces(shape).values()]
    return {"triangles": triangles, "levels": levels}


def _edges(shape: Any) -> list[list[Any]]:
    """Return the edges of a shape in a level plane, as edge_curves.py takes them."""
    from OCP.BRepAdaptor import BRepAdaptor_Curve

    return [_edge(BRepAdaptor_Curve(edge)) for edge in _found(shape, "edge")]


def _edge(curve: Any) -> list[Any]:
    from OCP.GeomAbs import GeomAbs_CurveType

    first, last = curve.FirstParameter(), curve.LastParameter()
    kind = curve.GetType()
    if kind == GeomAbs_CurveType.GeomAbs_Line:
        begin, end = curve.Value(first), curve.Value(last)
        return ["line", begin.X(), begin.Y(), end.X(), end.Y()]
    if kind == GeomAbs_CurveType.GeomAbs_Circle:
        round_one = curve.Circle()
        return ["ellipse", *_axes(round_one.Position(), round_one.Radius(), round_one.Radius()), first, last]
    if kind == GeomAbs_CurveType.GeomAbs_Ellipse:
        oval = curve.Ellipse()
        return ["ellipse", *_axes(oval.Position(), oval.MajorRadius(), oval.MinorRadius()), first, last]
    return _spline(curve, first, last)


def _axes(place: Any, major: float, minor: float) -> list[float]:
    centre, along, across = place.Location(), place.XDirection(), place.YDirection()
    return [
        centre.X(), centre.Y(), major * along.X(), major * along.Y(), minor * across.X(), minor * across.Y(),
    ]  # fmt: skip


def _spline(curve: Any, first: float, last: float) -> list[Any]:
    from OCP.BRep import BRep_Tool
    from OCP.Geom import Geom_TrimmedCurve
    from OCP.GeomConvert import GeomConvert

    whole = BRep_Tool.Curve_s(curve.Edge(), first, last)
    spline = GeomConvert.CurveToBSplineCurve_s(Geom_TrimmedCurve(whole, first, last))
    if spline.IsPeriodic():
        spline.SetNotPeriodic()
    numbers = range(1, spline.NbPoles() + 1)
    moved = curve.Trsf()
    poles = [spline.Pole(number).Transformed(moved) for number in numbers]
    knots = [
        spline.Knot(number) for number in range(1, spline.NbKnots() + 1) for _ in range(spline.Multiplicity(number))
    ]
    weights = [spline.Weight(number) for number in numbers]
    return ["spline", spline.Degree(), [(pole.X(), pole.Y()) for pole in poles], weights, knots]


if __name__ == "__main__":
    assert math.isfinite(float(sys.argv[3]))
    main(*sys.argv[1:4])
