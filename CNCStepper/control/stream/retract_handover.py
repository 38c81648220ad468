# SPDX-License-Identifier: LGPL-2.1-or-later
"""Retract along the cut, the run's part: where the run began, the last reports, and the legs that it received.

    held ---retrace---> reset, compare, position ---> running a leg ---> retreated ---retrace---> ...
                                                                            `--- a leg that is the rest ---> done

The run itself knows no geometry. Its client reads `told`, finds the place, proves a leg
(`recovery/retract/path_retract.py`) and gives it back as a bundle: a certificate, with what the next client must know
to find the place again.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import count
from math import dist
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from CNCStepper.control.program.bundle import (
    LINE_MAP,
    WIRE,
    array_bytes,
    copy_private,
    head_bytes,
    line_bytes,
    read_bundle,
    write_private,
)
from CNCStepper.control.program.certificate import Certificate
from CNCStepper.control.program.program_columns import message_members, messages_of
from CNCStepper.control.program.send_job import SendJob, program_members
from CNCStepper.control.protocol.grbl import connect
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.settings import MAX_RATE, STEPS_PER_MM
from CNCStepper.control.protocol.grbl.status_reports import Vector
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.session.job_phase import LEG_BEGINS, Phase
from CNCStepper.control.stream import stop_sequence
from CNCStepper.control.stream.feeder import Feeder
from CNCStepper.errors import CNCStepperError, JobError, LinkError, MachineRefusal, Text
from CNCStepper.state import WORK_SYSTEMS
from CNCStepper.tolerances import REPORTED_MM

LAST, REST = "retracted along the cut: go further back, forward, or resume from here", "rest"
HELD, LEG = "held.json", "leg.json"  # the headings of a report and of a leg
LEG_WIRE, OWN_MAP = "leg.txt", "own_map.npy"  # columns: the leg's lines; the lines of a leg's own text
KEPT_REPORTS = 1000  # some minutes at the rate of a run
ARC_TOLERANCE = 12  # the setting
PLANNER_BLOCKS = 15  # of grbl as delivered


@dataclass(frozen=True)
class Leg:
    """A way that a client has proven; wire: its file.

    content: the part of `recovery.retract.path_retract`' plain data that the next client needs.
    """

    job: SendJob
    content: Mapping[str, Any]
    wire: Path

    @property
    def is_rest(self) -> bool:
        """Whether the program ends with it."""
        return self.content["kind"] == REST

    @property
    def begin_mm(self) -> Vector:
        """The position at which the leg begins."""
        return tuple(self.content["certificate"]["start"]["state"]["position_mm"])

    @property
    def ahead_mm(self) -> Vector:
        """How far the motors are ahead of the tool there; more than the backlash after a jog."""
        return tuple(self.content["ahead_mm"])


class PathRetract:
    """Remembers for one run; used by its thread alone."""

    def __init__(self, program: SendJob):
        self.program = program
        self.leg: Leg | None = None  # the last begun
        self._is_over = False  # that leg
        self._origin: dict[str, Any] = {}
        self._reports: deque[tuple] = deque(maxlen=KEPT_REPORTS)
        self._blocks = PLANNER_BLOCKS
        self._numbers = count(1)  # of the legs

    @property
    def lines_before(self) -> int:
        """How many of the program's lines lie before those of the leg that is its rest."""
        return len(self.program.lines) - len(self.leg.job.lines) if self.leg and self.leg.is_rest else 0

    def begin(self, driver: Grbl, found: connect.ControllerInfo) -> None:
        """Note the machine's position before the first line, and its offsets."""
        offsets_mm = {name: driver.mm(offset) for name, offset in found.offsets.items()}
        self._origin = {
            "position_mm": driver.mpos_mm,
            "work_system": next((word for word in found.modes.split() if word in WORK_SYSTEMS), "G54"),
            "work_offsets_mm": {name: offsets_mm[name] for name in WORK_SYSTEMS if name in offsets_mm},
            "g92_mm": offsets_mm.get("G92"),
        }
        if driver.status and driver.status.buffer:
            self._blocks = driver.status.buffer[0]

    def note(self, driver: Grbl, feeder: Feeder, phase: str) -> None:
        """Keep the status just received when its position differs from the last one."""
        status, position_mm = driver.status, driver.mpos_mm
        if status is None or position_mm is None or phase == Phase.RETREATED:
            return
        blocks = self._blocks - status.buffer[0] if status.buffer else -1
        percent = driver.overrides[0] if driver.overrides else 100
        seen = (feeder.sent, feeder.acknowledged, position_mm, blocks, percent)
        if not self._reports or self._reports[-1][2:] != seen:
            self._reports.append((driver.status_asked_s, driver.clock(), *seen))

    def tell(self, driver: Grbl, phase: str, file: Path, jogged: bool) -> None:
        """Write for a client what it needs to find the place; raises MachineRefusal in motion, JobError.

        jogged: since the machine is at rest.
        """
        _check_phase(phase)
        settings = driver.settings
        content = {
            "program": self.program.to_content(),
            "origin": self._origin,
            "leg": self.leg.content if self.leg else None,
            "stands": self._is_over,
            "reports": list(self._reports),
            "position_mm": driver.mpos_mm,
            "jogged": jogged,
            "blocks": self._blocks,
            "steps_per_mm": [settings.get(STEPS_PER_MM + axis) for axis in range(3)],
            "max_rate_mm_min": [settings.get(MAX_RATE + axis) for axis in range(3)],
            "arc_tolerance_mm": settings.get(ARC_TOLERANCE),
        }
        members: dict[str, Iterable[bytes]] = {
            HELD: head_bytes(content),
            **program_members(self.program),
            LEG_WIRE: line_bytes(self.leg.job.lines if self.leg else ()),
        }
        try:
            write_private(file, members)
        except OSError as error:
            what = Text("the place cannot be written: {error}", error=error.strerror)
            raise JobError("retreat-file", what, advice="ask for it again") from error

    def read(self, file: Path, phase: str) -> Leg:
        """Return the leg of a file; raises JobError where it is none, or was not proven, MachineRefusal in motion."""
        _check_phase(phase)
        try:
            return self._leg(file)
        except CNCStepperError:
            raise
        except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
            what = Text("the retract cannot be read back: {error}", error=error)
            raise JobError("retreat-file", what, advice="ask for it again") from error

    def start(self, leg: Leg) -> None:
        """Note that a leg begins: what was reported before belongs to another text."""
        self.leg, self._is_over = leg, False
        self._reports.clear()

    @property
    def leads_to_pause(self) -> bool:
        """Whether the lines are those of a leg after which the machine waits."""
        return self.leg is not None and not self.leg.is_rest

    def ends_leg(self) -> bool:
        """Note that all lines are cut; return whether they were a leg after which the machine waits."""
        self._is_over = self.leads_to_pause
        return self._is_over

    # --- inside --------------------------------------------------------------------------------

    def _leg(self, file: Path) -> Leg:
        """Return the leg of a copy of its file."""
        wire = self._new_wire()
        copy_private(file, wire)
        bundle = read_bundle(wire, private=True)
        content = bundle.head
        own = {WIRE: bundle.columns[WIRE], LINE_MAP: bundle.columns[OWN_MAP]}
        proven = replace(bundle, head=content["certificate"], columns=own)
        certificate = Certificate.of_bundle(proven)
        certificate.check_clean()
        job = certificate.send_job(port=self.program.port, baud=self.program.baud, zero_confirmed=True)
        state = content["certificate"]["start"]["state"]
        job = replace(
            job,
            file=self.program.file,
            file_lines=bundle.file_lines,
            messages=messages_of(bundle.columns),
            expected={},  # settings were compared before the first line
            work_offsets_mm=state["work_offsets_mm"] | {"G92": state["g92_mm"]},
            work_system=state["work_system"],
        )
        return Leg(job, _kept(content), wire)

    def _new_wire(self) -> Path:
        """Return the path for the lines of a new leg; of those before, the last begun is still sent from."""
        folder = Path(self._folder.name)
        for wire in folder.iterdir():
            if self.leg is None or wire != self.leg.wire:
                wire.unlink()
        return folder / f"{next(self._numbers)}.wire"

    @cached_property
    def _folder(self) -> TemporaryDirectory[str]:
        """The folder for the lines of legs; it goes with the run."""
        return TemporaryDirectory(prefix="cncstepper-", ignore_cleanup_errors=True)


def _kept(content: Mapping[str, Any]) -> dict[str, Any]:
    """Return the data of a leg, besides its lines, that the next client needs."""
    return {**content, "certificate": {"start": content["certificate"]["start"]}}


def write_leg(file: Path, leg: Mapping[str, Any]) -> None:
    """Write a leg that `recovery.retract.path_retract` makes to a file, as `PathRetract.read` takes it."""
    certificate: Certificate = leg["certificate"]
    content = {**leg, "certificate": certificate.head()}
    members: dict[str, Iterable[bytes]] = {
        LEG: head_bytes({name: value for name, value in content.items() if name not in ("file_lines", "messages")}),
        WIRE: line_bytes(certificate.lines),
        LINE_MAP: array_bytes(leg["file_lines"]),
        OWN_MAP: array_bytes(certificate.file_lines),
        **message_members(leg["messages"]),
    }
    write_private(file, members)


def read_held(file: Path) -> dict[str, Any]:
    """Return the content that `PathRetract.tell` wrote, with all lines of the program and of its leg."""
    bundle = read_bundle(file)
    lines = {"lines": list(bundle.lines), "file_lines": list(bundle.file_lines)}
    program = {**bundle.head["program"], **lines, "messages": messages_of(bundle.columns)}
    return {**bundle.head, "program": program, "leg_lines": list(bundle.columns[LEG_WIRE])}


def reset_at_rest(driver: Grbl, timing: Timing) -> connect.ControllerInfo:
    """Reset a machine at rest, and return its state then; raises LinkError when that loses its position."""
    if not stop_sequence.reset(driver, timing):
        what = "the controller has not kept its position through the reset at standstill"
        raise LinkError("position-lost", what, advice="home the machine or set its zero again")
    return connect.learn(driver, timing)


def check_place(driver: Grbl, leg: Leg) -> None:
    """Refuse a leg that does not begin at the machine's position; raises MachineRefusal."""
    position_mm = driver.mpos_mm
    far_mm = dist(position_mm, leg.begin_mm) if position_mm else float("inf")
    if far_mm > REPORTED_MM:
        raise MachineRefusal(
            "retreat-moved",
            "the machine is not at the begin of the retract",
            value=Text("{far_mm:.3f} mm away", far_mm=far_mm),
            limit=f"{REPORTED_MM:g} mm",
            advice="ask for the way back again",
        )


def _check_phase(phase: str) -> None:
    if phase not in LEG_BEGINS:
        raise MachineRefusal("not-held", "the machine is not at standstill", value=phase, advice="hold it first")
