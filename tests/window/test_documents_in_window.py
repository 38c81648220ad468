# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document saved in a window opens in the window of the same and of newer FreeCADs: tree and picture with it."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest

from CNCStepper.workbench.calculation import kernel_warmup
from helpers.freecad import whole_document as whole
from window_helpers.hand import Hand

pytestmark = pytest.mark.window("timed")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return Path(os.environ.get(whole.FOLDER, tmp_path))


def test_documents_of_this_and_of_older_windows_open_with_the_same_program(
    hand: Hand, folder: Path, tmp_path: Path
) -> None:
    hand.wait(lambda: kernel_warmup.running() is None, 300, "the kernels")
    hand.expect_report("Recomputation required")  # FreeCAD's own word about shapes that an older one saved
    hand.main(whole.save, folder)
    for version in [whole.version(), *whole.older()]:
        copy = Path(shutil.copy(folder / f"{version}.FCStd", tmp_path / f"from {version}.FCStd"))
        hand.main(whole.check, copy, (folder / f"{version}.nc").read_text("ascii"))
        hand.main(FreeCAD.openDocument, str(copy))
        hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
        assert hand.main(without_proxy) == []
        hand.shot(f"document-of-{version}")


def without_proxy() -> list[Any]:
    """Return our objects that the tree shows without what we made for it."""
    ours = [obj for obj in FreeCAD.ActiveDocument.Objects if hasattr(obj, "Proxy") and obj.TypeId.startswith("App::")]
    assert ours
    return [obj.Name for obj in ours if not (obj.ViewObject and getattr(obj.ViewObject, "Proxy", None))]
