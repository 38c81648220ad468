# SPDX-License-Identifier: LGPL-2.1-or-later
"""DXF files that we write: one drawing is the same bytes in every process."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import ezdxf

from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.dxf.reader import read_dxf
from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
from CNCStepper.geometry.curve import circle

CODE = """
import sys
from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
from CNCStepper.geometry.curve import circle, straight
chains = (Chain(circle((0, 0), 5), Attributes("CUT", "#ff0000")), Chain(straight((9, 0), (9, 7)), Attributes("MARK")))
sys.stdout.buffer.write(dxf_bytes(Drawing(chains)))
"""


def written(seed: int) -> bytes:
    """Return the file that a process writes whose hashes begin with a seed."""
    environment = {**os.environ, "PYTHONHASHSEED": f"{seed}"}
    return subprocess.run([sys.executable, "-c", CODE], capture_output=True, check=True, env=environment).stdout


def test_the_order_of_hashes_is_not_in_the_file() -> None:
    found = {written(seed) for seed in (1, 4)}  # ezdxf alone writes two different files
    assert len(found) == 1
    assert found.pop().count(b"LWPOLYLINE") == 2


def test_layers_keep_their_letters_and_no_two_become_one_but_for_case(tmp_path: Path) -> None:
    named = {
        "çã corte é": "çã corte é",
        "切断": "切断",
        "a_b": "a_b",
        "a;b": "a_b_2",
        "a*b": "a_b_3",
        "A*B": "A_B_4",
        "Cut": "Cut",
        "cUT": "Cut",  # DXF compares names without case
        "": "0",
        "0": "0",
        "x" * 300: "x" * 255,
        "x" * 299: "x" * 247 + "_2",
    }
    chains = tuple(Chain(circle((9 * number, 0), 3), Attributes(name)) for number, name in enumerate(named))
    path = tmp_path / "nomes ç.dxf"
    path.write_bytes(dxf_bytes(Drawing(chains)))
    assert [chain.attributes.layer for chain in read_dxf(path, 0.01).chains] == list(named.values())
    assert {layer.dxf.name for layer in ezdxf.readfile(path).layers} >= {"çã corte é", "a_b_2"}
