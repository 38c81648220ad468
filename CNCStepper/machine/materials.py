# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of materials: how fast a cutter's edge may run through each, and how thick a chip a tooth takes.

    speed_m_min      of the cutter's rim         rpm  = 1000 speed / (pi diameter)
    chip_load_mm     feed a tooth                feed = rpm flutes chip_load

Both are ranges; `materials.toml` names where they were published. A file of the user's in the same form,
CONFIG/cncstepper/materials.toml, adds materials and takes the place of shipped ones.
"""

from __future__ import annotations

import tomllib
from functools import cache, lru_cache
from importlib import resources
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, model_validator

from CNCStepper.errors import JobError, MissingPackage, Text
from CNCStepper.machine.files.profile_files import config_folder
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.profile import validated
from CNCStepper.quantities import MOST_ITEMS, Bounds, ChipLoadOr0, Ratio, Width

CutterOf = Literal["carbide", "hss"]
Surface = Annotated[float, Bounds("surface_speed")]
Range = tuple[float, float]
ChipLoadRow = tuple[Width, ChipLoadOr0, ChipLoadOr0]  # diameter, least, most


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class Cutting(_Checked):
    """What one kind of cutter does in a material: surface speeds, and rows of (diameter, least, most) chip load."""

    speed_m_min: tuple[Surface, Surface]
    chip_load_mm: tuple[ChipLoadRow, ...] = Field(default=(), max_length=MOST_ITEMS["diameters"])

    @model_validator(mode="after")
    def _is_ordered(self) -> Cutting:
        diameters = [row[0] for row in self.chip_load_mm]
        ranges = [self.speed_m_min, *((least, most) for _, least, most in self.chip_load_mm)]
        if diameters != sorted(set(diameters)) or any(not 0 < least <= most for least, most in ranges):
            raise ValueError("diameters must rise, and each range lead from its least value above 0 to its most")
        return self


class Turning(_Checked):
    """What a lathe needs to know: K_s = force_n_mm2 / f^exponent (f in mm a turn), and the modulus of elasticity."""

    force_n_mm2: Annotated[float, Bounds("specific_force")]
    exponent: Annotated[float, Bounds("share", most=0.99)]
    elasticity_n_mm2: Annotated[float, Bounds("elasticity")]


class Material(_Checked):
    """A material; stepdown and stepover are shares of the tool's diameter, plunge_factor one of the feed."""

    name: str
    title: str
    source: str
    plunge_factor: Annotated[float, Bounds("share")]
    stepdown: Ratio
    stepover: Annotated[float, Bounds("share")]
    carbide: Cutting
    hss: Cutting | None = None
    turning: Turning | None = None

    def speed_m_min(self, cutter: CutterOf) -> Range:
        """Return the least and the most surface speed; raises JobError where such a cutter is of no use."""
        return self._cutting(cutter).speed_m_min

    def chip_load_mm(self, diameter_mm: float, cutter: CutterOf) -> Range:
        """Return the least and the most feed a tooth for a tool of that diameter; raises as `speed_m_min` does."""
        rows = np.array(self._cutting(cutter).chip_load_mm or self.carbide.chip_load_mm)
        least, most = (float(np.interp(diameter_mm, [0.0, *rows[:, 0]], [0.0, *rows[:, column]])) for column in (1, 2))
        return least, most

    def turning_data(self) -> Turning:
        """Return what a lathe needs to know; raises JobError where the table does not have it."""
        if self.turning is None:
            known = ", ".join(name for name in material_names() if materials()[name].turning)
            raise JobError(
                "material-not-turned",
                Text("the cutting force of {title} in turning is not in the table", title=self.title),
                advice=Text("use one of: {known}", known=known),
            )
        return self.turning

    def _cutting(self, cutter: CutterOf) -> Cutting:
        if cutter == "hss" and self.hss is None:
            raise JobError(
                "material-hss",
                Text("{title} blunts tools of HSS at once", title=self.title),
                advice="use one of carbide",
            )
        return self.carbide if self.hss is None or cutter == "carbide" else self.hss


def material_names() -> list[str]:
    """Return the names of all materials."""
    return list(materials())


def turned_materials() -> list[str]:
    """Return the names of those whose forces in turning are known."""
    return [name for name in material_names() if material(name).turning is not None]


def material(name: str) -> Material:
    """Return a material of the table; raises JobError that names those there are."""
    if name not in materials():
        raise JobError(
            "material-unknown",
            Text("there is no material '{name}'", name=name),
            advice=Text("use one of: {material_names}", material_names=", ".join(material_names())),
        )
    return materials()[name]


def materials() -> dict[str, Material]:
    """Return all materials by name: those that ship, and the user's own, which take the place of shipped ones.

    Raises JobError for a file of the user's that cannot be read.
    """
    try:
        path = own_materials_path()
        stamp = path.stat()
    except (OSError, MissingPackage):  # a user without a folder has none of his own
        return shipped_materials()
    return shipped_materials() | _read(path, (stamp.st_mtime_ns, stamp.st_size))


def own_materials_path() -> Path:
    """Return the file of the user's materials, which need not be there; raises MissingPackage without platformdirs."""
    return config_folder() / "materials.toml"


@cache
def shipped_materials() -> dict[str, Material]:
    """Return the materials of the table that ships, by name."""
    text = (resources.files("CNCStepper.machine") / "materials.toml").read_text("utf-8")
    return _checked(tomllib.loads(text), "materials.toml")


@lru_cache(maxsize=2)
def _read(path: Path, stamp: tuple[int, ...]) -> dict[str, Material]:
    return _checked(read_toml(path), str(path))


def _checked(tables: dict[str, Any], file: str) -> dict[str, Material]:
    return {name: validated(Material, {"name": name, **table}, file) for name, table in tables.items()}
