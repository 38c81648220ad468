# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by freecadcmd: draw the demo part, let the document make its program, save both.

Takes its folder from the environment (freecadcmd of 0.20 knows no arguments): CNCSTEPPER_DEMO_OUT.
"""

import os
import sys
import traceback
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import demo_part as part


def draw(out: Path) -> None:
    """Draw plate, pocket and map; write demo.FCStd, program.nc and job.json into `out`."""
    import FreeCAD
    import Part

    from CNCStepper.job.model import save_job
    from CNCStepper.workbench import api
    from CNCStepper.workbench.document.core_job import job_of

    document = FreeCAD.newDocument("Demo")
    sketch = document.addObject("Sketcher::SketchObject", "PocketSketch")
    sketch.addGeometry(Part.Ellipse(FreeCAD.Vector(*part.ELLIPSE_CENTRE_MM, 0), *part.ELLIPSE_RADII_MM), False)
    freehand = api.add_freehand(document, part.brazil(), closed=True)

    job = api.new_job(document, machine="table-a", stock_size_mm=part.PLATE_MM, stock_origin="top-left-front")
    mill = api.add_tool(
        job, number=1, shape="flat", diameter_mm=part.MILL_MM, feed_mm_min=1200, plunge_mm_min=300, spindle_rpm=10000
    )
    ball = api.add_tool(
        job, number=2, shape="ball", diameter_mm=part.BALL_MM, feed_mm_min=1500, plunge_mm_min=200, spindle_rpm=12000
    )
    api.add_elliptical_pocket(
        job,
        drawing=sketch,
        tool=mill,
        depth_mm=part.DEPTH_MM,
        stepdown_mm=2,
        stepover_mm=2.4,
        finish_stepdown_mm=0.2,
        finish_stepover_mm=0.3,
        tolerance_mm=0.01,
        entry="helix",
    )
    api.add_engrave(job, drawing=freehand, tool=ball, depth_mm=part.MAP_DEPTH_MM)
    document.recompute()
    (out / "program.nc").write_text(api.program_text(job), encoding="ascii", newline="\n")
    save_job(job_of(job), out / "job.json")
    document.saveAs(str(out / "demo.FCStd"))


status = 1
try:
    draw(Path(os.environ["CNCSTEPPER_DEMO_OUT"]))
    status = 0
except BaseException:  # freecadcmd would end with status 0 and run the script a second time
    traceback.print_exc()
finally:
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)
