# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a proof to its certificate: the one place where proofs and senders meet."""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, replace
from typing import Any, Protocol, TypeVar

import numpy as np
from pydantic import TypeAdapter

from CNCStepper import __version__
from CNCStepper.control.program.certificate import CHECK_AGAIN, FORMAT, OTHER, VERSION, Certificate, digest_of
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.errors import JobError
from CNCStepper.gcode.interpreter.functions.coordinate_offsets import HOMES
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.syntax.words import code_pattern
from CNCStepper.gcode.wire.backlash_compensation import backlash_of
from CNCStepper.gcode.wire.wire_text import WireText
from CNCStepper.job.proof_inputs import Given
from CNCStepper.job.start_state_file import start_from
from CNCStepper.job.wire_round_trip import translated_to, wire_of
from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.controller_family import makes_pulses
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import Process
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.wiring import seen_by_sender
from CNCStepper.motion.interpolation.dda_stream import dda_stream
from CNCStepper.motion.planner.buffers import TICKS_PER_S
from CNCStepper.motion.planner.plan import begun
from CNCStepper.motion.signals.peak_rate import PeakRate
from CNCStepper.motion.signals.pulse_stream import PulseChunk, PulseStream, pulse_stream
from CNCStepper.motion.signals.step_direction import Timeline
from CNCStepper.simulation.checks.clamps import Clamp
from CNCStepper.simulation.cutter_solid import Tools
from CNCStepper.simulation.stock import HeightField, Stock
from CNCStepper.state import ZERO3, Start
from CNCStepper.toolpath import require_straight_axes

FIGURES = ("blocks", "moves", "cut_length_mm", "air_length_mm", "rapid_length_mm", "pierces", "removed_volume_mm3")
VERDICT = ("gouge_mm", "left_over_mm")
SENT = (
    "file",
    "expected",
    "work_offsets_mm",
    "work_system",
    "retrace",
    "plan",
    "inputs",
)
Read = TypeVar("Read")
_PLAY = TypeAdapter(Backlash)
SOURCE = ("number", "name", "source")  # of a chart's row: where it comes from
MOST_NAMED = 4  # values in a refusal
ANY_TOOL = "any"  # the number of a tool that applies to every number


class Sent(Protocol):
    """What is sent of a program."""

    @property
    def lines(self) -> Sequence[str]:
        """The lines, without their newline."""

    @property
    def file_lines(self) -> np.ndarray | Sequence[int]:
        """The file's line of each, from 1."""

    @property
    def messages(self) -> Mapping[int, str]:
        """Messages to the operator, by the index (from 0) of the line after them."""

    @property
    def sha256(self) -> str:
        """The fingerprint of the lines as they are sent."""


class Proven(Protocol):
    """A proof in a certificate; plan: from `milestones`, cell_mm: of the cut part, None for none."""

    @property
    def wire(self) -> Sent:
        """What is sent."""

    @property
    def program_sha256(self) -> str:
        """The fingerprint of the program's text."""

    @property
    def start(self) -> Start:
        """The start state."""

    @property
    def plan(self) -> list[list[float]]:
        """The planned times."""

    @property
    def given(self) -> Given:
        """What it was proven against."""

    @property
    def report(self) -> dict[str, Any]:
        """What was found."""

    @property
    def cell_mm(self) -> tuple[float, float] | None:
        """The sides of a cell."""


def certificate_of(proof: Proven) -> Certificate:
    """Return the certificate of a proof, clean or not."""
    given, report = proof.given, proof.report
    job = send_job(proof.wire, given.machine, report["program"], proof.start, given.dialect, proof.plan)
    return Certificate(
        {
            "format": FORMAT,
            "version": VERSION,
            "made_by": f"CNCStepper {__version__}",
            "program": {"file": report["program"], "sha256": proof.program_sha256, **_language(given)},
            "wire": {
                "sha256": proof.wire.sha256,
                "lines": len(proof.wire.lines),
                "dialect": given.machine.wire_language(given.dialect),
                "play": _play(given),
            },
            "start": {"sha256": proof.start.sha256(), "state": _start(proof.start)},
            "machine": {"sha256": machine_digest(given.machine), "name": given.machine.name},
            "stock": {"sha256": stock_digest(given.stock), "stock": _stock(given.stock)},
            "before": list(given.before),
            "tools": {"sha256": tools_digest(given.tools), "tools": _tools(given.tools)},
            "keep_out": {
                "sha256": keep_out_digest(given.keep_out, given.edge_mm),
                **_keep_out(given.keep_out, given.edge_mm),
            },
            "cut": cut_content(given.machine, given.process, given.cut_data),
            "tolerance": _tolerance(proof),
            "times": {"program_s": report["time_s"], "operations_s": _times(report["operations"])},
            "figures": {name: report[name] for name in (*FIGURES, *VERDICT)},
            "findings": report["findings"],
            "send": _sent(job),
        },
        job.lines,
        job.file_lines,
        job.messages,
    )


def _language(given: Given) -> dict[str, str]:
    """Return the program's language where the wire text is in another one."""
    return {"dialect": given.dialect} if translated_to(given.machine, given.dialect) is not None else {}


def _play(given: Given) -> dict[str, Any] | None:
    """Return the backlash of the axes that the wire text compensates; None for none."""
    play = backlash_of(given.machine, given.dialect)
    return asdict(play) if play else None


def proven_wire(certificate: Certificate, text: str, dialect: str, file: str, start: Start | None) -> WireText:
    """Return the wire text of a program with the backlash that a certificate's proof has compensated.

    start: None is the one of the proof. Raises ProgramError as `prepare` does,
    JobError where the certificate's play or start is none.
    """
    play, machine = _part_of(certificate, _play_in), _part_of(certificate, _machine_in)
    return wire_of(text, machine, dialect, file, start or (proven_start(certificate) if play else None), play)


def proven_start(certificate: Certificate) -> Start:
    """Return the start state of a certificate's proof; raises JobError where it holds none that can be."""
    return _part_of(certificate, lambda content: start_from(content["start"]["state"]))


def _machine_in(content: Mapping[str, Any]) -> Machine | None:
    told = content["send"].get("retrace", {}).get("machine")
    return Machine.model_validate(told) if told else None


def _play_in(content: Mapping[str, Any]) -> Backlash | None:
    told = content["wire"].get("play")
    play = _PLAY.validate_python(told) if told is not None else None
    if play and {len(play.backlash_mm), len(play.true_sense), len(play.steps_per_mm)} != {len(ZERO3)}:
        raise ValueError("backlash has three values, one for each axis")
    return play


def _part_of(certificate: Certificate, read: Callable[[Mapping[str, Any]], Read]) -> Read:
    """Return the checked content of a certificate, which may be hand-made."""
    try:
        return read(certificate.content)
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        what = "the certificate has an entry that no proof has"
        raise JobError("certificate-bad", what, value=str(error)[:60], advice=CHECK_AGAIN) from error


def send_job(
    wire: Sent,
    machine: Machine | None,
    file: str,
    start: Start | None = None,
    dialect: str = "",
    plan: Sequence[Sequence[float]] = (),
) -> SendJob:
    """Return the job of sending `wire`, whose port is still to be chosen and whose zero is not confirmed.

    machine: its settings must hold on the controller. start: so must its work zero, where that is known. None
    compares nothing. dialect: in which it was read, the machine's own when left out. plan: as `milestones` gives it.
    """
    known = start if start is not None and start.zero_known else None
    return SendJob(
        port="",
        lines=wire.lines,
        file=file,
        file_lines=wire.file_lines.tolist() if isinstance(wire.file_lines, np.ndarray) else wire.file_lines,
        messages=wire.messages,
        expected=expected_settings(machine) if machine else {},
        work_offsets_mm=(_offsets(known) if known else {}) | (_places(start, wire.lines) if start else {}),
        work_system=known.work_system if known else "",
        dialect=machine.wire_language(dialect) if machine else dialect,
        program_dialect=machine.language(dialect) if translated_to(machine, dialect) is not None and machine else "",
        machine=machine.name if machine else "",
        retrace=_path_retract(machine, start or Start(), dialect) if machine else {},
        plan=plan,
        inputs=[entry.model_dump(mode="json") for entry in seen_by_sender(machine.input)] if machine else (),
    )


def peak_rate(job: SendJob) -> float:
    """Return the fastest rate of pulses of a job, pulses/s, as the planner times its lines; 0 where none are ours.

    Raises MachineRefusal where the times of the machine's signals do not allow these pulses.
    """
    profile = job.retrace.get("machine")
    machine = Machine.model_validate(profile) if profile else None
    if machine is None or not makes_pulses(machine):
        return 0.0
    text = "".join(f"{line}\n" for line in job.lines)
    path = interpret(text, start_from(job.retrace["start"]), job.dialect, job.file)
    rate, way = PeakRate(), begun(require_straight_axes(path, job.file))
    stream = pulse_stream(way, machine) if machine.interpolation == "planner" else dda_stream(way, machine)
    for _ in Timeline(replace(stream, chunks=_counted(stream, rate)), machine.signals):
        pass
    return rate.per_s(TICKS_PER_S)


def _counted(stream: PulseStream, rate: PeakRate) -> Iterator[PulseChunk]:
    for chunk in stream:
        rate.add(chunk.ticks)
        yield chunk


def _path_retract(machine: Machine, start: Start, dialect: str) -> dict[str, Any]:
    """Return the data with which a retract along the cut is proven."""
    profile = machine.model_dump(mode="json")
    return {"machine": profile, "start": _start(start), "dialect": machine.wire_language(dialect)}


def _offsets(start: Start) -> dict[str, tuple[float, ...]]:
    """Return the offsets that act from the start on, those that are zero too."""
    return {start.work_system: ZERO3, **start.work_offsets_mm, "G92": start.g92_mm}


def _places(start: Start, lines: Sequence[str]) -> dict[str, tuple[float, ...]]:
    """Return the positions of G28 and G30 that the proof has used, machine coordinates in mm."""
    return {
        name: tuple(start.parameters[first + axis] * start.machine_unit_mm for axis in range(len(ZERO3)))
        for name, first in HOMES.items()
        if all(first + axis in start.parameters for axis in range(len(ZERO3)))
        and any(re.search(code_pattern("G", name[1:]), line) for line in lines)
    }


def machine_digest(machine: Machine) -> str:
    """Return the fingerprint of a machine profile without its buttons and rates, which change no proof."""
    return digest_of(machine.model_dump(mode="json", exclude={"input", "rates"}))


def cut_content(machine: Machine, process: Process, row: CutData | None) -> dict[str, Any]:
    """Return the process of a program and its row of the cut chart as a certificate has them.

    A process that the machine does not have was not named by anybody: it is null.
    """
    name = process.name if process.name in machine.processes else None
    return {"process": name, "row": row.model_dump(mode="json") if row else None}


def check_cut(certificate: Certificate, machine: Machine | None, wanted: Mapping[str, Any] | None) -> None:
    """Refuse a program whose proven process the machine does not have, or whose process or chart row is another one.

    machine: None is that of the proof. wanted: as `cut_content` gives it, None compares nothing. Raises JobError that
    names the values that differ.
    """
    theirs = _part_of(certificate, lambda content: _cut_values(content.get("cut") or {"process": None, "row": None}))
    on = machine or _part_of(certificate, _machine_in)
    if theirs["process"] is not None and on:
        on.process(str(theirs["process"]))
    if wanted is None:
        return
    ours = _cut_values(wanted)
    other = [key for key in {**ours, **theirs} if ours.get(key) != theirs.get(key)]
    if other:
        raise JobError("certificate-cut", OTHER["cut"], value=_named(ours, other), limit=_named(theirs, other),
                       advice=CHECK_AGAIN)  # fmt: skip


def _cut_values(cut: Mapping[str, Any]) -> dict[str, Any]:
    """Return the process and the values of the row that cut."""
    return {"process": cut["process"]} | {key: value for key, value in (cut["row"] or {}).items() if key not in SOURCE}


def _named(values: Mapping[str, Any], keys: Sequence[str]) -> str:
    """Return the first of some values, each with its key."""
    return ", ".join(f"{key} = {values[key]}" for key in keys[:MOST_NAMED] if key in values) or "none"


def stock_digest(stock: Stock | None) -> str:
    """Return the fingerprint of a stock; None has one too."""
    return digest_of(_stock(stock))


def tools_digest(tools: Tools | None) -> str:
    """Return the fingerprint of the tools; None has one too."""
    return digest_of(_tools(tools))


def keep_out_digest(clamps: Sequence[Clamp], edge_mm: float | None) -> str:
    """Return the fingerprint of the obstacles of the tool: the clamps and the sheet's rim."""
    return digest_of(_keep_out(clamps, edge_mm))


def _keep_out(clamps: Sequence[Clamp], edge_mm: float | None) -> dict[str, Any]:
    return {"clamps": [asdict(clamp) for clamp in clamps], "edge_mm": edge_mm}


def _stock(stock: Stock | None) -> dict[str, Any] | None:
    if stock is None:
        return None
    told: dict[str, Any] = {
        "form": type(stock).__name__.lower(),
        "size_mm": list(stock.size_mm),
        "origin": stock.origin,
    }
    if isinstance(stock, HeightField) and stock.heights_mm is not None:
        told["heights_sha256"] = hashlib.sha256(stock.heights_mm.astype("<f8").tobytes()).hexdigest()
        told["points"] = list(stock.heights_mm.shape)
    return told


def _tools(tools: Tools | None) -> dict[str, Any] | None:
    if tools is None:
        return None
    if isinstance(tools, Tool):
        return {ANY_TOOL: tools.model_dump(mode="json")}
    return {str(number): tool.model_dump(mode="json") for number, tool in sorted(tools.items())}


def _start(start: Start) -> dict[str, Any]:
    """Return the start state as JSON gives it back, numbers of tools and parameters as texts too: so keys are sorted.

    A position that is not known is null.
    """
    position = [None if math.isnan(value) else value for value in start.position_mm]
    return dict(json.loads(json.dumps(asdict(start) | {"position_mm": position})))


def _tolerance(proof: Proven) -> dict[str, Any]:
    """Return how far the program may leave the shapes wanted, and the cells of the volume that is removed."""
    allowed = [removal.tolerance_mm for removal in proof.given.removals]
    return {
        "shape_mm": min(allowed) if allowed else None,
        "cell_mm": None if proof.cell_mm is None else list(proof.cell_mm),
    }


def _times(operations: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [{"name": operation["name"], "time_s": operation["time_s"]} for operation in operations]


def _sent(job: SendJob) -> dict[str, Any]:
    content = job.to_content()
    return {name: content[name] for name in SENT}
