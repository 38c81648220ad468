# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper simulate`: the part that a program cuts, as picture, animation, mesh and figures, at any moment."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click
import numpy as np

from CNCStepper.cli.common.findings_output import show_findings, write_report
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.lathe_options import LatheOptions, lathe_options, show_x
from CNCStepper.cli.common.options import NumberType, program_argument, read_program
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.program_options import ProgramOptions, program_options
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool

if TYPE_CHECKING:
    from CNCStepper.job.prove import Proof
    from CNCStepper.simulation.removal.heightmap import HeightMap
    from CNCStepper.simulation.removal.timeline import Timeline, TimelinePosition
    from CNCStepper.simulation.views.scene import Scene

VIEWS = ("isometric", "xy", "zy", "depth")
ANIMATION_S = 6.0


@click.command("simulate", cls=Verb)
@program_argument
@program_options()
@lathe_options
@click.option(
    "-o",
    "--out",
    type=OutputPath("picture"),
    required=True,
    help="The picture, PNG or SVG; with --view also an animation: GIF, APNG, WebP, or MP4 where ffmpeg is.",
)
@click.option("--view", type=click.Choice(VIEWS), help="One view alone. [default: isometric and depth on one sheet]")
@click.option("--at", "at_s", type=click.FloatRange(min=0), help="Show the part after that many seconds.")
@click.option("--line", type=click.IntRange(min=1), help="Show the part after that line of the program.")
@click.option("--stl", type=OutputPath("mesh"), help="Also write the part there, as STL in mm.")
@click.option(
    "--read-at",
    "read_at_mm",
    multiple=True,
    type=NumberType(),
    help="Say the turned part's diameter and bore at this Z.",
)
@click.option("--json", "json_path", type=OutputPath("report"), help="Also write the report there.")
def command(
    program: Path,
    out: Path,
    view: str | None,
    at_s: float | None,
    line: int | None,
    stl: Path | None,
    read_at_mm: tuple[float, ...],
    json_path: Path | None,
    given: ProgramOptions,
    lathe: LatheOptions,
) -> None:
    """Draw what PROGRAM leaves of the stock, at its end or at a moment; times are the job's machine's
    or table-a's unless told.

    A PNG of the end stands there at once, plain, until the full one takes its place. With --work-zero the pictures
    of one view show the machine's work surface. --bar and --turning-tool, or the job of a lathe, give the half section
    of a turned part. Exit 1 when a finding is an error.
    """
    from CNCStepper.job.prove import prove, prove_job

    if lathe.turns(given):
        if view or (at_s is not None and line is not None):
            raise click.UsageError(Text("a turned part is drawn as its half section, at one moment: leave --view out"))
        _Turned(program, given, lathe).conclude(out, at_s, line, read_at_mm, json_path, stl)
    given.check_stock(required=True)
    if read_at_mm:
        raise click.UsageError(Text("--read-at is for a turned part: give --bar"))
    if at_s is not None and line is not None:
        raise click.UsageError(Text("give either --at or --line"))
    job, named = given.job_and_machine()
    machine = named or load_machine("table-a")
    text = read_program(program)
    words: dict[str, Any] = {"file": str(program), "start": given.start_options.start()}
    words["dialect"] = given.dialect_on(machine)
    out.parent.mkdir(parents=True, exist_ok=True)
    if out.suffix.lower() == ".png" and view in (None, "depth") and at_s is line is None:
        words["see"] = partial(_show_first, out)
    own: dict[str, Any] = {"stock": given.stock, "tools": given.tool}
    proof = prove_job(job, machine, text, **words) if job else prove(text, machine, **own, **words)
    show = _Show(proof, program.stem)
    show.draw(out, view, show.time_s(at_s, line))
    if stl:
        show.save_stl(stl)
    if json_path:
        write_report(json_path, proof.report)
    show_findings(proof.findings)
    click.echo(f"{out}: {show.words}")
    sys.exit(1 if proof.refused else 0)


def _show_first(out: Path, part: HeightMap) -> None:
    """Write a picture of the part at once: the one that is asked for takes its place when all is known."""
    from CNCStepper.simulation.views.quick_picture import save_first_picture

    save_first_picture(out, part)


class _Turned:
    """A lathe program's proof, to be drawn as a half section."""

    def __init__(self, program: Path, given: ProgramOptions, lathe: LatheOptions):
        machine = given.job_and_machine()[1] or load_machine("mini-lathe")
        text, language = read_program(program), given.dialect_on(machine)
        show_x(program, text, language, machine)
        start = given.start_options.start()
        self._title = program.stem
        self._proof, self._verdict = lathe.prove(text, given, machine, str(program), language, start)

    def conclude(
        self,
        out: Path,
        at_s: float | None,
        line: int | None,
        read_at_mm: Iterable[float],
        json_path: Path | None,
        stl: Path | None,
    ) -> NoReturn:
        """Draw the part at a time or line, else at the end, say what was asked for, and end the command."""
        from CNCStepper.quantities import duration_text

        if stl:
            self.save_stl(stl, at_s, line)
        out.parent.mkdir(parents=True, exist_ok=True)
        self._verdict.draw(out, self._title, duration_text(self._proof.report["time_s"]), self._row(at_s, line))
        if json_path:
            write_report(json_path, self._proof.report)
        show_findings(self._proof.findings)
        for z_mm in read_at_mm:
            outer_mm, bore_mm = self._verdict.dimension_at(z_mm)
            show_text(
                "Z{z_mm:g}: diameter {outer_mm:.4f} mm, bore {bore_mm:.4f} mm",
                z_mm=z_mm,
                outer_mm=outer_mm,
                bore_mm=bore_mm,
            )
        removed = self._proof.report["removed_volume_mm3"] / 1000
        show_text(
            "{out}: {removed:.1f} cm³ removed in {time_s:.1f} s",
            out=out,
            removed=removed,
            time_s=self._proof.report["time_s"],
        )
        sys.exit(1 if self._proof.refused else 0)

    def save_stl(self, path: Path, at_s: float | None, line: int | None) -> None:
        """Write the part at a time or line, else at the end, as a mesh."""
        from CNCStepper.simulation.meshes.turned_mesh import turned_mesh

        part, row = self._verdict.part, self._row(at_s, line)
        turned_mesh(part.section if row is None else part.at(row)).save_stl(path)

    def _row(self, at_s: float | None, line: int | None) -> int | None:
        """Return the last row that is done at a time or with a line, None for the end; -1 before the first."""
        if line is not None:
            done = self._proof.toolpath.table().line <= line
        elif at_s is not None:
            done = self._proof.times_s <= at_s
        else:
            return None
        rows = np.flatnonzero(done)
        return int(rows[-1]) if len(rows) else -1


class _Show:
    """A proof to look at; after `draw`, the moment that was drawn."""

    def __init__(self, proof: Proof, title: str):
        assert proof.given.tools is not None
        self._proof = proof
        self._title = title
        self._tools = proof.given.tools
        self._scene = proof.scene()
        self._moment: TimelinePosition | None = None

    def time_s(self, at_s: float | None, line: int | None) -> float | None:
        """Return the requested time, None for the end: a time, or the end of the last move of a line."""
        if line is None:
            return at_s
        rows = np.flatnonzero(self._proof.toolpath.table().line <= line)
        return float(self._proof.times_s[rows[-1]]) if len(rows) else 0.0

    def draw(self, out: Path, view: str | None, time_s: float | None) -> None:
        """Draw the part at a time (None: the end), or animate all up to it."""
        from CNCStepper.simulation.views.animation import is_movie, save_animation
        from CNCStepper.simulation.views.proof_picture import save_picture
        from CNCStepper.simulation.views.single_view import save_view

        if is_movie(out):
            if view is None:
                raise click.UsageError(Text("an animation needs --view"))
            save_animation(out, view, self._frames(time_s), self._title)
            return
        if time_s is not None:
            self._scene = self._at(self._timeline(), time_s)
        if view is None:
            save_picture(out, self._scene, self._title, self._facts())
        else:
            save_view(out, view, self._scene, self._title, self._facts())

    def save_stl(self, path: Path) -> None:
        """Write the part that was drawn as a mesh."""
        from CNCStepper.simulation.meshes.stl_mesh import mesh_of

        mesh_of(self._scene.part).save_stl(path)

    @property
    def words(self) -> str:
        """What is left of the stock, in one line."""
        time_s = self._proof.report["time_s"] if self._moment is None else self._moment.time_s
        at = "" if self._moment is None else f", line {self._moment.line}"
        return f"{self._scene.part.removed_volume_mm3 / 1000:.1f} cm³ removed in {time_s:.1f} s{at}"

    def _frames(self, time_s: float | None) -> Iterator[tuple[Scene, list[str]]]:
        from CNCStepper.simulation.views.animation import FRAMES_A_S

        timeline = self._timeline()
        end_s = timeline.duration_s if time_s is None else time_s
        for moment_s in np.linspace(0.0, end_s, int(ANIMATION_S * FRAMES_A_S)):
            self._scene = self._at(timeline, float(moment_s))
            yield self._scene, self._facts()

    def _timeline(self) -> Timeline:
        from CNCStepper.simulation.removal.timeline import Timeline

        stock = self._scene.part.stock
        return Timeline(self._proof.toolpath, self._proof.times_s, self._tools, stock)

    def _at(self, timeline: Timeline, time_s: float) -> Scene:
        self._moment = timeline.moment(time_s)
        return self._proof.scene(self._moment, timeline.at(time_s))

    def _facts(self) -> list[str]:
        from CNCStepper.simulation.views.proof_picture import facts_of

        tools = [self._tools] if isinstance(self._tools, Tool) else self._tools.values()
        words = ", ".join(tool.words for tool in tools)
        return facts_of(self._scene, words, self._proof.report["time_s"], self._moment)
