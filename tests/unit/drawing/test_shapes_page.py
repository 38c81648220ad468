# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of the library and its pictures are what the shapes declare."""

from __future__ import annotations

from types import ModuleType

import pytest

from helpers.tools import load


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    return load("reference")


def test_the_page_is_what_the_shapes_declare(tool: ModuleType) -> None:
    assert tool.shapes_page() == tool.SHAPES_PAGE.read_text("utf-8"), "run 'python tools/reference.py'"


def test_every_shape_has_its_picture(tool: ModuleType) -> None:
    on_disk = {path.name: path.read_text("utf-8") for path in tool.SHAPE_PICTURES.iterdir()}
    assert tool.shape_pictures() == on_disk, "run 'python tools/reference.py'"
