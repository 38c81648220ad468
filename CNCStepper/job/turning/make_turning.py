# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lathe's job to program text: the cycles fill one table of moves, the writer puts it into the machine's dialect."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any

import numpy as np

from CNCStepper.cycles.turning.turn_thread import thread_form
from CNCStepper.cycles.turning.turned_coordinates import Placement
from CNCStepper.cycles.turning.turning_cycles import cut
from CNCStepper.cycles.turning.turning_moves import TurningMoves
from CNCStepper.cycles.turning.turning_operation import TurnDrill, TurningOperation, TurnThread
from CNCStepper.cycles.turning.turning_setup import TurningAnswer, TurningSetup
from CNCStepper.errors import CNCStepperError, CycleError, JobError, Place
from CNCStepper.gcode.dialects import Dialect, dialect
from CNCStepper.gcode.writer.write import WriteOptions, write, write_split
from CNCStepper.job.make import numbered, operation_name
from CNCStepper.job.turning.bar_limits import require_in_bar
from CNCStepper.job.turning.cutting_warnings import cutting_warnings
from CNCStepper.job.turning.taper_profile import profile_of
from CNCStepper.job.turning.turning_job import TurningJob
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.machine.turning_forces import nearest_preset_rpm
from CNCStepper.state import Start, State
from CNCStepper.toolpath import ARC_CCW, ARC_CW, TableBuilder, Toolpath

LEFT_OUT = ("spindle", "coolant", "dwell", "pause", "tool")  # of a lathe whose operator does them by hand
USUAL_M_MIN = 100.0  # the surface speed of which a refusal names the spindle's


@dataclass(frozen=True)
class TurnedProgram:
    """One of the programs of a job: its number from 1, tool (0: all of them), text and what its operations answered."""

    number: int
    tool: int
    program: str
    answers: tuple[TurningAnswer, ...]

    @property
    def file_name(self) -> str:
        """The name of its file beside the others, for example program-2-T3.nc."""
        return f"program-{self.number}-T{self.tool}.nc" if self.tool else "program.nc"


def make_turning(job: TurningJob, machine: Machine, title: str = "") -> list[TurnedProgram]:
    """Return the programs of a job: one, or one for each stretch of operations with the same tool.

    Raises CycleError, JobError or ProgramError and makes nothing.
    """
    language, (table, answers) = dialect(machine.language()), turned_moves(job, machine)
    options = _options(job, machine, language, title, answers)
    if not is_split_turning(job, machine):
        return [TurnedProgram(1, 0, write(table, language, options), tuple(answers))]
    texts = write_split(table, language, options)
    stretches = groupby(answers, key=lambda answer: answer.tool)
    return [
        TurnedProgram(number, tool, text, tuple(own))
        for number, ((tool, text), (_, own)) in enumerate(zip(texts, stretches, strict=True), start=1)
    ]


def is_split_turning(job: TurningJob, machine: Machine) -> bool:
    """Return whether the job needs more than one program."""
    return machine.tool_change == "split" and len({operation.tool for operation in job.operation}) > 1


def placement_of(job: TurningJob, machine: Machine) -> Placement:
    """Return where the zero of the job's programs lies on the part, and the sign of their Z."""
    language = dialect(machine.language())
    zero = job.start_zr if language.starts_at_work_zero else (0.0, 0.0)
    return Placement(*zero, language.z_sign)


def in_part(toolpath: Toolpath, placement: Placement) -> Toolpath:
    """Return a program's moves in the part's coordinates: X the radius, Z of a right-handed lathe."""

    kinds = np.arange(256, dtype=np.uint8)
    if placement.mirrors:
        kinds[[ARC_CW, ARC_CCW]] = [ARC_CCW, ARC_CW]
    chunks = [
        replace(
            chunk,
            kind=kinds[chunk.kind],
            end=points_in_part(chunk.end, placement),
            centre=points_in_part(chunk.centre, placement),
        )
        for chunk in toolpath.chunks
    ]
    begin = points_in_part(np.array([toolpath.start.position_mm], float), placement)[0]
    start = replace(toolpath.start, position_mm=tuple(begin.tolist()))
    return Toolpath(start, chunks, toolpath.states, toolpath.events, toolpath.spans)


def points_in_part(points_mm: np.ndarray, placement: Placement) -> np.ndarray:
    """Return points of a program, float64[n, 3 or more], in the part's coordinates as `in_part` has them."""
    z, r = placement.part(points_mm).T
    return np.column_stack([r, points_mm[:, 1], z, points_mm[:, 3:]])


def turned_moves(job: TurningJob, machine: Machine) -> tuple[Toolpath, list[TurningAnswer]]:
    """Return the moves of all operations in the program's coordinates, and what each answered."""
    placement = placement_of(job, machine)
    begin = Start.at_zero() if dialect(machine.language()).starts_at_work_zero else Start()
    table = TableBuilder(begin, State(work_system=job.work_offset, plane="ZX"))
    answers = [
        _cut(number, operation, setup, table, placement, job, machine)
        for number, (operation, setup) in enumerate(_setups(job, machine), start=1)
    ]
    return table.toolpath(), answers


def _cut(
    number: int,
    operation: TurningOperation,
    setup: TurningSetup,
    table: TableBuilder,
    placement: Placement,
    job: TurningJob,
    machine: Machine,
) -> TurningAnswer:
    flood, mist = job.coolant == "flood", job.coolant == "mist"
    left = isinstance(operation, TurnThread) and thread_form(operation).left
    turning: dict[str, Any] = {"spindle": "ccw" if left else "cw", "spindle_rpm": setup.rpm, "feed_mode": "per_turn"}
    turning |= {"surface_m_min": setup.surface_m_min, "largest_rpm": setup.largest_rpm}
    table.set_state(replace(table.state, tool=setup.tool.number, flood=flood, mist=mist, **turning))
    table.open_span("operation", operation_name(operation.cycle))
    try:
        moves = TurningMoves(table, placement, setup)
        if number == 1 and math.isnan(table.position_mm[0]):
            table.rapid(placement.program(*job.start_zr))
        answer = cut(number, operation, setup, moves)
        answer = replace(answer, warnings=(*answer.warnings, *cutting_warnings(answer, job, machine)))
    except CNCStepperError as error:
        if error.place:
            raise
        raise error.at(Place(numbered(number, operation.cycle))) from error
    table.close_span()
    return answer


def _setups(job: TurningJob, machine: Machine) -> Iterator[tuple[TurningOperation, TurningSetup]]:
    """Yield each operation with its tool, the stock with what the ones before have drilled, and its speeds."""
    bore_mm = job.stock.bore_mm
    for number, operation in enumerate(job.operation, start=1):
        tool = job.tools[operation.tool]
        try:
            profile = profile_of(operation, job)
            require_in_bar(number, job, bore_mm)
            rpm = spindle_speed(operation, job, machine)
            surface = _surface_speed(operation, job, machine, rpm)
            feed_mm_rev = _feed_mm_rev(operation, tool)
            if feed_mm_rev <= 0:
                what, advice = "the operation has no feed", "give it or its tool a feed_mm_rev"
                raise CycleError("feed-missing", what, value="0 mm", limit="above 0 mm", advice=advice)
        except (CycleError, JobError) as error:
            raise error.at(Place(numbered(number, operation.cycle))) from error
        raw = (job.stock.diameter_mm / 2, job.stock.face_mm, bore_mm)
        yield operation, TurningSetup(tool, *raw, job.start_zr, feed_mm_rev, rpm, profile, machine, *surface)
        if isinstance(operation, TurnDrill):
            bore_mm = max(bore_mm, tool.diameter_mm)


def _feed_mm_rev(operation: TurningOperation, tool: TurningTool) -> float:
    """Return the feed a turn: of a thread its lead."""
    if isinstance(operation, TurnThread):
        return thread_form(operation).lead_mm
    return operation.feed_mm_rev or tool.feed_mm_rev


def _surface_speed(operation: TurningOperation, job: TurningJob, machine: Machine, rpm: float) -> tuple[float, float]:
    """Return the surface speed in m/min that an operation keeps, 0 for none, and the highest speed of the spindle.

    Raises CycleError for a machine that cannot, with the fixed speed at the bar.
    """
    tool = job.tools[operation.tool]
    if not operation.constant_surface_speed:
        return 0.0, 0.0
    if "G96" not in dialect(machine.language()).codes or machine.spindle.preset_rpm:
        what = "the spindle of this machine does not follow X: it has no G96"
        advice, limit = "take constant_surface_speed out, and give a fixed speed", f"spindle_rpm = {rpm:.0f}"
        raise CycleError("surface-speed", what, value="constant_surface_speed", limit=limit, advice=advice)
    surface = operation.surface_speed_m_min or tool.surface_speed_m_min  # spindle_speed has refused 0
    return surface, operation.max_rpm or tool.max_rpm or machine.spindle.max_rpm


def spindle_speed(operation: TurningOperation, job: TurningJob, machine: Machine) -> float:
    """Return the speed of an operation in rpm: its own or its tool's, or that of its surface speed at the bar.

    The nearest of the speeds that the machine has. Raises CycleError where there is none, with one that would do.
    """
    tool, spindle, diameter_mm = job.tools[operation.tool], machine.spindle, job.stock.diameter_mm
    rpm = operation.spindle_rpm or tool.spindle_rpm * (not operation.constant_surface_speed)
    surface = operation.surface_speed_m_min or tool.surface_speed_m_min
    most = operation.max_rpm or tool.max_rpm or spindle.max_rpm
    if not rpm and surface:
        rpm = min(1000.0 * surface / (math.pi * diameter_mm), most)
    if not rpm:
        usual = nearest_preset_rpm(spindle.preset_rpm, 1000.0 * USUAL_M_MIN / (math.pi * diameter_mm))
        what, limit = "a feed per revolution needs a speed of the spindle", f"spindle_rpm = {usual:.0f}, for example"
        raise CycleError(
            "speed-missing", what, value="0 rpm", limit=limit, advice="give spindle_rpm or surface_speed_m_min"
        )
    if rpm > most:
        what, value = "the spindle does not turn so fast", f"{rpm:g} rpm"
        raise CycleError("speed-high", what, value=value, limit=f"{most:g} rpm", advice="lower spindle_rpm")
    if rpm < spindle.min_rpm:
        what, value = "the spindle does not turn so slowly", f"{rpm:.4g} rpm"
        raise CycleError("speed-low", what, value=value, limit=f"{spindle.min_rpm:g} rpm", advice="raise spindle_rpm")
    return nearest_preset_rpm(spindle.preset_rpm, rpm)


def _options(
    job: TurningJob, machine: Machine, language: Dialect, title: str, answers: list[TurningAnswer]
) -> WriteOptions:
    if job.work_offset != "G54" and not (language.writing and language.writing.work_systems):
        what = "the machine has no work offsets"
        raise JobError("work-offset", what, value=job.work_offset, limit="G54", advice="take out work_offset")
    by_hand = "M3" not in language.codes
    x, y, z = machine.axes
    speeds = [f"tool {answer.tool}: {answer.figures['rpm']:g} rpm" for answer in answers] if by_hand else []
    return WriteOptions(
        units=job.units,
        work_offset=job.work_offset,
        spin_up_s=machine.spindle.spin_up_s,
        tool_change=machine.tool_change,
        title=title,
        comments=(f"X is the {job.x_is}", *dict.fromkeys(speeds)),
        tools={tool.number: tool.words for tool in job.tool},
        tool_length=machine.tool_length,
        retract=False,
        leave_out=LEFT_OUT if by_hand else (),
        chord_mm=job.arc_tolerance_mm,
        rapid_mm_min=machine.fastest_mm_min,
        x_is=job.x_is,
        incremental=job.distance == "incremental",
        steps_per_mm=(x.steps_per_mm, y.steps_per_mm, z.steps_per_mm),
        turning_cycles=job.canned,
    )
