# SPDX-License-Identifier: LGPL-2.1-or-later
"""A saved document opens in the same and in newer FreeCADs, with the same program."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

from helpers.freecad import whole_document as whole


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return Path(os.environ.get(whole.FOLDER, tmp_path))


def test_documents_of_this_and_of_older_freecads_open_with_the_same_program(folder: Path, tmp_path: Path) -> None:
    whole.save(folder)
    for version in [whole.version(), *whole.older()]:
        copy = shutil.copy(folder / f"{version}.FCStd", tmp_path / f"from {version}.FCStd")
        whole.check(Path(copy), (folder / f"{version}.nc").read_text("ascii"))
