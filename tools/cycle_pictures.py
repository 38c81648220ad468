# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of the cycles in docs/pictures/cycles anew, each from the proven program of its example job.

Then look at them. Part of `make pictures`; with names of cycles only those.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from pictures import ROOT, kept
from PIL import Image

from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.prove import prove_job

JOBS = ROOT / "examples" / "jobs" / "cycles"
KEPT = ROOT / "docs" / "pictures" / "cycles"


def keep(name: str) -> None:
    """Make, prove and draw one example job; ends with its findings when it may not be cut."""
    job, machine = load_job(JOBS / f"{name}.toml")
    made = make_program(job, machine, name)
    proof = prove_job(job, machine, made.program, f"{name}.nc")
    if proof.refused:
        sys.exit("\n".join(str(finding) for finding in proof.findings))
    with tempfile.TemporaryDirectory() as folder:
        drawn = Path(folder) / "part.png"
        proof.draw(drawn, name.replace("-", " "), job.cutters)
        with Image.open(drawn) as picture:
            kept(picture).save(KEPT / f"{name}.png", optimize=True)


if __name__ == "__main__":
    for chosen in sys.argv[1:] or sorted(path.stem for path in JOBS.glob("*.toml")):
        keep(chosen)
