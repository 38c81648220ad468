# SPDX-License-Identifier: LGPL-2.1-or-later
"""No number of a job, a tool or a machine goes without bounds, and what is beyond them is refused with its key."""

from __future__ import annotations

import types
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, Literal, Union, get_args, get_origin

import pytest
from pydantic import BaseModel, Strict
from pydantic.fields import FieldInfo

from CNCStepper.cycles.catalogue import CYCLES, cycle_class
from CNCStepper.errors import JobError
from CNCStepper.job.model import Job, ToolFile, load_job
from CNCStepper.job.shapes import ShapeForm
from CNCStepper.machine.materials import Material
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.quantities import Bounds

MODELS = [Job, Machine, ShapeForm, ToolFile, Material, *map(cycle_class, CYCLES)]
UNIONS = (Union, types.UnionType)


def unbounded(model: type[BaseModel], seen: set[type[BaseModel]] | None = None) -> Iterator[str]:
    """Yield the keys that take a number without bounds, a truth value that may be a text, or an endless list."""
    seen = set() if seen is None else seen
    if model in seen:
        return
    seen.add(model)
    for name, field in model.model_fields.items():
        for found in _loose(field.annotation, list(field.metadata), seen):
            yield f"{model.__name__}.{name}: {found}"


def _loose(kind: Any, told: list[Any], seen: set[type[BaseModel]]) -> Iterator[str]:
    if get_origin(kind) is Annotated:
        kind, *more = get_args(kind)
        more = [rule for entry in more for rule in (entry.metadata if isinstance(entry, FieldInfo) else [entry])]
        yield from _loose(kind, more, seen)
    elif get_origin(kind) in UNIONS:
        for part in get_args(kind):
            yield from _loose(part, told, seen)
    elif kind in (int, float) and not any(isinstance(rule, Bounds | Strict) for rule in told):
        yield kind.__name__
    elif kind is bool and not any(isinstance(rule, Strict) for rule in told):
        yield "bool"
    elif get_origin(kind) in (tuple, list, dict):
        parts = get_args(kind)
        endless = get_origin(kind) is list or (get_origin(kind) is tuple and parts[-1] is ...)
        if endless and not any(getattr(rule, "max_length", None) for rule in told):
            yield "a list of any length"
        for part in parts:
            yield from _loose(part, [], seen)
    elif isinstance(kind, type) and issubclass(kind, BaseModel):
        yield from unbounded(kind, seen)


def test_every_number_and_list_of_every_model_is_bounded() -> None:
    assert [key for model in MODELS for key in unbounded(model)] == []


class Inner(BaseModel):
    bare: float
    may: int | None = None
    flag: bool = False
    good: Annotated[float, Bounds("feed")] | None = None


class Outer(BaseModel):
    inner: tuple[Inner, ...] = ()
    pair: tuple[float, Annotated[float, Bounds("feed")]]
    word: Literal["a", "b"] = "a"


def test_the_walk_sees_what_is_loose() -> None:
    found = unbounded(Outer)
    assert sorted(key.split(": ")[-2] for key in found) == [
        "Inner.bare",
        "Inner.flag",
        "Inner.may",
        "Outer.inner",
        "Outer.pair",
    ]


JOB = """
machine = "table-a"
clearance_mm = 10
retract_mm = 2
[stock]
size_mm = [100, 70, 20]
origin = "top-centre"
[[tool]]
number = 1
shape = "flat"
diameter_mm = 6.0
feed_mm_min = 800
plunge_mm_min = 200
spindle_rpm = 12000
[[operation]]
cycle = "circular_pocket"
tool = 1
radius_mm = 20
depth_mm = 10.0
stepdown_mm = 2
stepover_mm = 2.4
"""


def job_error(folder: Path, old: str, new: str) -> str:
    """Return how the job is refused in which `old` is replaced by `new`."""
    assert JOB.count(old) >= 1
    (folder / "job.toml").write_text(JOB.replace(old, new, 1), "utf-8")
    with pytest.raises(JobError) as refused:
        load_job(folder / "job.toml")
    assert refused.value.place and "job.toml" in refused.value.place.file
    return str(refused.value)


def test_the_job_itself_loads(tmp_path: Path) -> None:
    (tmp_path / "job.toml").write_text(JOB, "utf-8")
    assert load_job(tmp_path / "job.toml")[0].clearance_mm == 10.0


CLAMPS = "clamp = [" + "{corners_mm = [[0, 0], [1, 1]], top_mm = 1}," * 1001 + "]"
MOTOR = "[axis.x.motor]\ntravel_per_turn_mm = 5\nmass_kg = 1\ntorque = [" + "[1, 1]," * 20_000 + "]"


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("depth_mm = 10.0", "depth_mm = true", ["operation 1: depth_mm must be a number", "value True"]),
        ("depth_mm = 10.0", 'depth_mm = "1.5"', ["depth_mm must be a number", "value '1.5'"]),
        ("depth_mm = 10.0", f"depth_mm = 1{'0' * 400}", ["depth_mm", "hundreds of digits", "0.001 to 10000 mm"]),
        ("depth_mm = 10.0", f"depth_mm = 0x1{'0' * 9000}", ["depth_mm", "limit 0.001 to 10000 mm"]),
        ("depth_mm = 10.0", f"depth_mm = 1{'0' * 5000}", ["not a TOML file", "digits"]),
        ("stepover_mm = 2.4", "stepover_mm = 1e-9", ["stepover_mm", "value 1e-09 mm", "limit 0.001"]),
        ("clearance_mm = 10", "clearance_mm = 1e5", ["clearance_mm", "value 100000 mm", "no axis lifts"]),
        ("feed_mm_min = 800", "feed_mm_min = 1e18", ["tool.0.feed_mm_min", "1e+18 mm/min", "1000000 mm/min, or 0"]),
        ("number = 1", "number = 1.0", ["tool.0.number must be a whole number"]),
        ("stepover_mm = 2.4", "stepover_mm = 2.4\npoints = 17", ["points", "17"]),
        ('machine = "table-a"', "machine = 17", ["machine"]),
        (
            "[stock]",
            f"{CLAMPS}\n[stock]",
            ["clamp is too long", "limit 1000"],
        ),
        ("clearance_mm = 10", f"deep = {'[' * 5000}{']' * 5000}\nclearance_mm = 10", ["nested"]),
        ("clearance_mm = 10", f"{'a.' * 100_000}a = 1\nclearance_mm = 10", ["nested"]),
    ],
    ids=range(14),
)
def test_what_is_beyond_the_bounds_is_refused_with_key_value_and_limit(
    old: str, new: str, told: list[str], tmp_path: Path
) -> None:
    sentence = job_error(tmp_path, old, new)
    assert all(words in sentence for words in told), sentence
    assert len(sentence) < 1000 and sentence.isprintable()


def test_a_shape_that_a_list_names_twice_is_refused(tmp_path: Path) -> None:
    (tmp_path / "job.toml").write_text(
        JOB.partition("[[operation]]")[0]
        + """
[[shape]]
name = "hole"
circle_mm = { centre = [0, 0], radius = 5 }
[[operation]]
cycle = "pocket"
tool = 1
region = ["""
        + '"hole", ' * 20_000
        + "]\ndepth_mm = 1\nstepdown_mm = 1\nstepover_mm = 2\n",
        "utf-8",
    )
    with pytest.raises(JobError, match="region names the shape 'hole' twice"):
        load_job(tmp_path / "job.toml")


MACHINE = Path(__file__).parents[3] / "CNCStepper" / "machine" / "profiles" / "table-a.toml"


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("acceleration_mm_s2 = 250", "acceleration_mm_s2 = 1e-308", ["axis.x.acceleration_mm_s2", "1e-308 mm/s²"]),
        ("max_rpm = 24000", "max_rpm = 1e18", ["spindle.max_rpm", "1e+18 rpm", "1000000 rpm"]),
        ("laser = false", "laser = 0", ["spindle.laser"]),
        ("steps_per_mm = 80", 'steps_per_mm = "80"', ["axis.x.steps_per_mm", "'80'"]),
        (
            "[spindle]",
            f"{MOTOR}\n[spindle]",
            ["torque is too long"],
        ),
    ],
)
def test_profiles_are_held_to_the_same_bounds(old: str, new: str, told: list[str], tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(MACHINE.read_text("utf-8").replace(old, new, 1), "utf-8")
    with pytest.raises(JobError) as refused:
        load_machine(tmp_path / "mine.toml")
    assert all(words in str(refused.value) for words in [*told, "mine.toml"]), str(refused.value)
