# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole road, once: a drawing in headless FreeCAD becomes a part on a virtual table.

Run by `make demo`; results go to build/demo. Each step is what a user does: FreeCAD's document makes the
program, `prove_job` reads it back, `cncstepper virtual grbl` is the table, `cncstepper send` sends.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import demo_judge
import demo_part as part
import shapely
from rich.console import Console
from rich.table import Table

from CNCStepper.geometry.shapes.ellipse import Ellipse
from CNCStepper.job.model import load_job
from CNCStepper.job.prove import Proof, prove_job
from CNCStepper.state import Start

ROOT = Path(__file__).resolve().parent.parent
OUT = ROOT / "build" / "demo"
SPEED = 40  # the virtual table runs that many times faster than a real one
LIMIT_MM = 0.035  # cut against drawing: tolerance 0.01, half a step of two axes, and the trace's own spacing
console = Console(highlight=False, width=100)


def main() -> int:
    """Run the demo; return 0 when the part is right."""
    begun = time.monotonic()
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    step("1 draw      ", "plate, Sketcher ellipse and freehand map in headless FreeCAD")
    draw()
    step("2 prove     ", "read the program back, time, simulate and check it")
    proof = prove()
    step("3 cut       ", f"stream it to a virtual grbl over a pseudo-terminal, {SPEED} times faster than real")
    run_s = cut()
    step("4 compare   ", "the path its axes took with the drawing")
    judged = compare()
    console.print(table(proof, run_s, judged))
    for name in ("demo.FCStd", "program.nc", "report.json", "part.png", "trace.csv"):
        console.print(f"  {OUT / name}", soft_wrap=True, markup=False)
    good = not proof.refused and judged.worst_mm <= LIMIT_MM
    console.print(f"{'The part is right' if good else 'THE PART IS WRONG'} ({time.monotonic() - begun:.0f} s)")
    return 0 if good else 1


def step(name: str, text: str) -> None:
    """Tell what happens now."""
    console.print(f"[bold]{name}[/bold]{text}")


def draw() -> None:
    """Let FreeCAD draw and make the program."""
    freecad = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    if not freecad:
        sys.exit("freecadcmd is not installed: run 'make setup', which names the way to get it")
    command = [freecad, str(ROOT / "examples" / "demo_drawing.py"), "-M", str(ROOT)]
    done = subprocess.run(
        command,
        env=os.environ | {"CNCSTEPPER_DEMO_OUT": str(OUT)},
        capture_output=True,
        encoding="utf-8",
        errors="replace",
    )
    if done.returncode:
        sys.exit(f"FreeCAD could not draw the demo part:\n{done.stdout}\n{done.stderr}")


def prove() -> Proof:
    """Prove the program against the shapes of the drawing; write report and picture."""
    job, machine = load_job(OUT / "job.json")
    text = (OUT / "program.nc").read_text("ascii")
    start = Start((0.0, 0.0, 0.0), work_offsets_mm={job.work_offset: part.ZERO_MM}, zero_known=True)
    proof = prove_job(job, machine, text, str(OUT / "program.nc"), start)
    (OUT / "report.json").write_text(json.dumps(proof.report, indent=2, allow_nan=False), encoding="utf-8")
    proof.draw(OUT / "part.png", "Demo part: elliptical pocket and freehand map", job.cutters)
    for finding in proof.findings:
        console.print(f"  {finding}", soft_wrap=True, markup=False)
    return proof


def cut() -> float:
    """Stream the program to the virtual grbl; return how long its axes moved, in its own seconds."""
    with virtual_grbl() as port:
        set_zero(port)
        command = [cncstepper(), "send", str(OUT / "program.nc"), "--port", port, "--machine", "table-a"]
        sent = subprocess.run(
            [*command, "--zero-confirmed", "--resume-pauses", "--keep-open", "0"], stderr=subprocess.DEVNULL
        )
    if sent.returncode:
        sys.exit("the program was not cut to its end")
    return demo_judge.motion_s(OUT / "trace.csv")


@contextmanager
def virtual_grbl() -> Iterator[str]:
    """Run `cncstepper virtual grbl` and yield its port: a pseudo-terminal, or TCP where there are none."""
    with tempfile.TemporaryDirectory() as folder:
        where = ["--tcp", "127.0.0.1:2217"] if os.name == "nt" else ["--pty", str(Path(folder) / "grbl")]
        command = [cncstepper(), "virtual", "grbl", *where, "--speed", str(SPEED), "--trace", str(OUT / "trace.csv")]
        table = subprocess.Popen([*command, "--machine", "table-a"], stdout=subprocess.PIPE, encoding="utf-8")
        try:
            ready = table.stdout.readline() if table.stdout else ""
            if not ready:
                sys.exit("the virtual grbl did not come up")
            yield "socket://127.0.0.1:2217" if os.name == "nt" else where[1]
        finally:
            table.terminate()
            table.wait(10)


def set_zero(port: str) -> None:
    """Tell the controller where the plate's corner lies, as an operator does with jog and zero."""
    import serial

    with serial.serial_for_url(port, 115200, timeout=2) as line:
        line.read_until(b"help]\r\n")
        line.write(f"G10 L2 P1 X{part.ZERO_MM[0]} Y{part.ZERO_MM[1]} Z{part.ZERO_MM[2]}\n".encode("ascii"))
        if line.readline().strip() != b"ok":
            sys.exit("the virtual grbl did not take the work zero")


def compare() -> demo_judge.Cut:
    """Judge the axes' path against the drawing."""
    ellipse = Ellipse.of_radii(part.ELLIPSE_CENTRE_MM, *part.ELLIPSE_RADII_MM)
    return demo_judge.judge(
        OUT / "trace.csv",
        part.ZERO_MM,
        shapely.Polygon(ellipse.points(0.0002)),
        part.MILL_MM / 2,
        part.DEPTH_MM,
        shapely.LineString(part.brazil()),
        part.MAP_DEPTH_MM,
    )


def motion_s(proof: Proof) -> float:
    """Return the estimated time in motion: without the program's dwells, as the axes' trace counts it."""
    dwells_s = sum(event.value for event in proof.toolpath.events if event.kind == "dwell")
    return float(proof.report["time_s"]) - dwells_s


def table(proof: Proof, run_s: float, judged: demo_judge.Cut) -> Table:
    """Return the figures for people."""
    report = proof.report
    rows = (
        ("blocks in the program", f"{report['blocks']}", ""),
        ("time in motion, estimated / run", f"{minutes(motion_s(proof))} / {minutes(run_s)}", "min:s"),
        ("cut / rapid", f"{report['cut_length_mm'] / 1000:.2f} / {report['rapid_length_mm'] / 1000:.2f}", "m"),
        ("gouge, by exact sweep", f"{report['gouge_mm']:.4f}", "mm"),
        ("material left, by exact sweep", f"{report['left_over_mm']:.4f}", "mm"),
        ("axes' path: pocket wall off the drawing", f"{judged.wall_mm:.4f}", "mm"),
        ("axes' path: pocket floor off the drawing", f"{judged.floor_mm:.4f}", "mm"),
        ("axes' path: map off the drawing", f"{judged.line_mm:.4f}", "mm"),
        ("worst deviation", f"{judged.worst_mm:.4f}", "mm"),
    )
    figures = Table(title="What was cut", title_style="bold")
    for heading, side in (("figure", "left"), ("value", "right"), ("unit", "left")):
        figures.add_column(heading, justify=side)
    for row in rows:
        figures.add_row(*row)
    return figures


def minutes(time_s: float) -> str:
    """Return a time as minutes and seconds."""
    return f"{int(time_s // 60)}:{time_s % 60:04.1f}"


def cncstepper() -> str:
    """Return the command beside the Python that runs this."""
    return str(Path(sys.executable).with_name("cncstepper" + (".exe" if os.name == "nt" else "")))


if __name__ == "__main__":
    sys.exit(main())
