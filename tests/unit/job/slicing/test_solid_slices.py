# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stacks of sheets: their volume is the solid's, holes go straight through, marks lie on the pieces."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
import shapely

from CNCStepper.errors import JobError
from CNCStepper.job.slicing.sections import mesh_sections, section_area, slab_volumes_mm3, volume_mm3
from CNCStepper.job.slicing.slice_files import mark_chains, nest_order, without_holes
from CNCStepper.job.slicing.solid_slices import Stack, stack_of
from helpers.solids.closed_meshes import box, hull_with_cavities, inside_out, sphere, thin_wall

PARTS = ("front", "middle", "back")
SOLIDS = {"sphere": sphere(20.0, rings=40), "hull": hull_with_cavities(), "wall": thin_wall()}


def sliced(mesh: np.ndarray, axis: str, thickness_mm: float, hole_mm: float = 0.0) -> Stack:
    return stack_of(mesh_sections(mesh, axis, thickness_mm), PARTS, hole_mm)


@pytest.mark.parametrize(("name", "axis"), [*itertools.product(("sphere", "hull"), "xyz"), ("wall", "z")])
def test_the_stack_has_the_volume_of_the_solid(name: str, axis: str) -> None:
    stack = sliced(SOLIDS[name], axis, 1.0)
    assert stack.solid_volume_mm3 == pytest.approx(volume_mm3(SOLIDS[name]))
    assert stack.volume_mm3 == pytest.approx(stack.solid_volume_mm3, rel=0.01)


@pytest.mark.parametrize("name", SOLIDS)
def test_the_volume_in_each_sheet_is_exact(name: str) -> None:
    mesh = SOLIDS[name]
    heights = np.linspace(mesh[:, :, 2].min(), mesh[:, :, 2].max(), 14)
    volumes = slab_volumes_mm3(mesh, heights)
    assert (
        sum(volumes) == pytest.approx(volume_mm3(mesh)) == pytest.approx(sum(slab_volumes_mm3(mesh[:, ::-1], heights)))
    )
    within = np.linspace(heights[6], heights[7], 41)
    areas = [section_area(mesh, height).area for height in (within[1:] + within[:-1]) / 2.0]
    assert volumes[6] == pytest.approx(np.mean(areas) * (heights[7] - heights[6]), rel=0.002)


def test_sheets_that_are_thicker_than_the_solid_are_told_with_the_share() -> None:
    assert sliced(SOLIDS["sphere"], "z", 1.0).notes == sliced(SOLIDS["wall"], "z", 1.0).notes == ()
    notes = sliced(SOLIDS["wall"], "x", 1.0).notes
    assert notes[0].startswith("sheet 1: the solid is thinner there than the sheet and fills ") and len(notes) == 3
    assert notes[-1].startswith("the volume of the stack is off by +1")


def test_sections_of_a_sphere_are_discs_and_cavities_are_holes() -> None:
    disc = section_area(SOLIDS["sphere"], 12.3)
    assert disc.area == pytest.approx(np.pi * (400.0 - 12.3**2), rel=0.01)
    hull = section_area(SOLIDS["hull"], 0.0)
    assert len(hull.interiors) == 2
    assert hull.area == pytest.approx(np.pi * (625.0 - 81.0 + 9.0) - 11.0 * 12.0, rel=0.01)
    island = section_area(np.concatenate([SOLIDS["hull"], sphere(4.0, (-8.0, 0.0, 3.0), 20)]), 0.0)
    assert len(shapely.get_parts(island)) == 2, "a solid in a cavity is a piece of its own"


def test_parts_numbers_and_registration_holes() -> None:
    stack = sliced(SOLIDS["hull"], "x", 3.0, hole_mm=2.0)
    assert [each.number for each in stack.slices] == list(range(1, 18))
    runs = [(part, len(list(run))) for part, run in itertools.groupby(each.part for each in stack.slices)]
    assert [part for part, _ in runs] == list(PARTS) and max(n for _, n in runs) - min(n for _, n in runs) <= 1
    holes = {hole for each in stack.slices for piece in each.pieces for hole in piece.holes}
    assert len(holes) == 2
    for hole in holes:
        numbers = [each.number for each in stack.slices if any(hole in piece.holes for piece in each.pieces)]
        assert len(numbers) > len(stack.slices) / 2 and numbers == list(range(numbers[0], numbers[-1] + 1))
    for piece in (piece for each in stack.slices for piece in each.pieces):
        assert without_holes(piece).is_valid and without_holes(piece).area > 0


def test_sheets_without_a_registration_hole_are_told() -> None:
    wide = sliced(SOLIDS["sphere"], "z", 5.0, hole_mm=100.0)
    assert not any(piece.holes for each in wide.slices for piece in each.pieces)
    count = len(wide.slices)
    assert wide.notes == (f"{count} of {count} sheets have no registration hole: one of 100 mm takes 200 mm across",)


def test_marks_lie_on_the_material_between_the_holes() -> None:
    marked = 0
    for each in sliced(SOLIDS["hull"], "z", 2.0, hole_mm=3.0).slices:
        for piece in each.pieces:
            strokes = list(mark_chains(piece, str(each.number)))
            free = without_holes(piece)
            assert all(free.contains(shapely.LineString(stroke.curve.xy)) for stroke in strokes)
            marked += bool(strokes)
    assert marked > 20


def test_pieces_of_the_stack_are_an_order_of_its_parts() -> None:
    stack = sliced(SOLIDS["wall"], "y", 4.0)
    order = nest_order(stack, (100.0, 80.0), 1.0, 2.0)
    assert len(order.items) == sum(len(each.pieces) for each in stack.slices) == len(order.chains)
    assert order.items[0].priority > order.items[-1].priority and order.items[0].name.startswith("front")
    assert all(item.outline.buffer(1e-6).covers(item.exact) for item in order.items)


def test_an_open_mesh_and_too_many_sheets_are_refused() -> None:
    with pytest.raises(JobError) as refused:
        sliced(SOLIDS["sphere"][1:], "z", 1.0)
    assert refused.value.code == "slice-open" and refused.value.value == "3 open edges"
    with pytest.raises(JobError) as refused:
        sliced(SOLIDS["sphere"], "z", 0.001)
    assert refused.value.code == "slice-count"


def test_the_volume_of_a_box_and_of_one_with_a_cavity() -> None:
    outer, inner = box((0, 0, 0), (10, 20, 30)), box((2, 2, 2), (5, 6, 7))
    assert volume_mm3(outer) == pytest.approx(6000.0)
    assert volume_mm3(np.concatenate([outer, inside_out(inner)])) == pytest.approx(6000.0 - 60.0)
