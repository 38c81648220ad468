# SPDX-License-Identifier: LGPL-2.1-or-later
"""The status of a session (`SenderStatus`) and its result (`Outcome`), both as JSON too."""

from __future__ import annotations

from dataclasses import asdict, dataclass, fields
from typing import Any

from CNCStepper import errors
from CNCStepper.control.protocol.grbl.status_reports import Vector
from CNCStepper.control.session.job_phase import Phase
from CNCStepper.errors import CNCStepperError, LinkError, Place, Text
from CNCStepper.text_json import restored, with_texts

TUPLES = ("mpos_mm", "wpos_mm", "overrides", "buffer")
PORT_INPUTS, PORT_OUTPUTS = "port_inputs", "port_outputs"
DONE, STOPPED, REFUSED, FAILED = "done", "stopped", "refused", "failed"
ENDS = (DONE, STOPPED, REFUSED, FAILED)
WORDS = ("code", "what", "advice", "value", "limit")  # of an error


@dataclass(frozen=True)
class SenderStatus:
    """One moment of a session.

    phase: "connecting", "running", "holding", "held", "paused" (M0; `message` is the program's), "door", "finishing",
    "retreated" (led back along its cut), "stopping", then the kind of the outcome; of a service without a job "idle",
    "alarm" (`message` says which), "jogging", "homing", "held", "door" or "busy". machine_state: as grbl writes it.
    file_line, file_line_sent: the last line of the file that is surely cut, and that was sent; `acknowledged` counts
    those that the controller has taken. Positions are None until reported. buffer: free blocks of the planner and free
    bytes, where the controller tells them. remaining_s, done: the time still to go, None while nothing can be said, and
    the part that lies behind, 0 to 1.
    overrides: feed, rapid, spindle in percent. outputs: what is on: S or C for the spindle's sense, F flood, M mist.
    pins: the inputs that are on, as "XYZ" for limit switches, P for the
    probe, D for the door. homing: whether the machine can home itself. position_known: whether machine positions
    can be trusted. homed: whether they count from the machine's own zero, which it has found since it was met.
    stand: the number of the last stand: what lets the job go on from there answers to it.
    wanted_back_mm: how far a button of the machine wants the tool led back on its cut, None for nowhere; wanted_rest:
    whether the job is to go on from where that led. Both are for a client that can lead it.
    work_system, work_offsets_mm: the work system in force and what `$#` last said by name ("G54", "G92", "TLO").
    None stands for: not reported yet.
    cannot: what the machine cannot do, as words of `control.protocol.grbl.capabilities`.
    port_inputs, port_outputs: of a parallel port the status pins that are high and the devices that are on; None of
    another machine.
    """

    phase: str = Phase.CONNECTING
    sent: int = 0
    acknowledged: int = 0
    total: int = 0
    machine_state: str = ""
    mpos_mm: Vector | None = None
    wpos_mm: Vector | None = None
    feed_mm_min: float | None = None
    spindle_rpm: float | None = None
    file: str = ""
    file_line: int = 0
    file_line_sent: int = 0
    message: str = ""
    elapsed_s: float = 0.0
    remaining_s: float | None = None
    done: float = 0.0
    buffer: tuple[int, int] | None = None
    outputs: str | None = None
    overrides: tuple[int, ...] | None = None
    pins: str = ""
    homing: bool | None = None
    position_known: bool | None = None
    homed: bool = False
    stand: int = 0
    wanted_back_mm: float | None = None
    wanted_rest: bool = False
    work_system: str = ""
    work_offsets_mm: dict[str, Vector] | None = None
    cannot: tuple[str, ...] = ()
    port_inputs: tuple[int, ...] | None = None
    port_outputs: tuple[str, ...] | None = None

    def to_json(self) -> dict[str, Any]:
        """Return it as plain values."""
        return asdict(self)

    @classmethod
    def from_json(cls, content: dict[str, Any]) -> SenderStatus:
        """Return the status from `to_json`'s JSON; raises ValueError for another value."""
        try:
            vectors = {key: _vector(content[key]) if content[key] else None for key in TUPLES}
            offsets = content["work_offsets_mm"]
            named = {str(name): _vector(offset) for name, offset in offsets.items()} if offsets else None
            cannot = tuple(str(word) for word in content["cannot"])
            outputs = content[PORT_OUTPUTS]
            port = {
                PORT_INPUTS: None if content[PORT_INPUTS] is None else _vector(content[PORT_INPUTS]),
                PORT_OUTPUTS: None if outputs is None else tuple(str(name) for name in outputs),
            }
            status = cls(**(content | vectors | port | {"work_offsets_mm": named, "cannot": cannot}))
        except (TypeError, KeyError, AttributeError) as error:
            raise ValueError(Text("not a status: {error}", error=error)) from error
        for name, kinds in _KINDS.items():
            if type(getattr(status, name)) not in kinds:
                raise ValueError(
                    Text("not a status: its {name} is no {kind_name}", name=name, kind_name=kinds[0].__name__)
                )
        return status


_TYPES: dict[str, tuple[type, ...]] = {  # of the annotations above, what JSON makes of them
    "str": (str, Text),
    "int": (int,),
    "bool": (bool,),
    "float": (float, int),
    "float | None": (float, int, type(None)),
    "bool | None": (bool, type(None)),
    "str | None": (str, type(None)),
}
_KINDS = {field.name: _TYPES[str(field.type)] for field in fields(SenderStatus) if field.type in _TYPES}


def _vector(values: Any) -> Any:
    """Return numbers as a tuple; raises ValueError for anything else."""
    if not isinstance(values, (list, tuple)) or not all(type(value) in (float, int) for value in values):
        raise ValueError("not a status: a vector has other things in it than numbers")
    return tuple(values)


@dataclass(frozen=True)
class Outcome:
    """How a session ended.

    kind: "done" (all lines acknowledged and the machine idle), "stopped" (as asked), "refused"
    (nothing was sent) or "failed". text: one or two sentences for people. position_known: whether
    the controller's position may still be trusted. error: why, unless done or stopped.
    """

    kind: str
    text: str
    position_known: bool
    status: SenderStatus
    error: CNCStepperError | None = None

    @property
    def done(self) -> bool:
        """Whether the job was cut to its end."""
        return self.kind == DONE

    def raise_for_error(self) -> None:
        """Raise the error that ended the session, if one did."""
        if self.error is not None:
            raise self.error

    def to_json(self) -> dict[str, Any]:
        """Return it as plain values."""
        content = {
            "kind": self.kind,
            "text": self.text,
            "position_known": self.position_known,
            "status": self.status.to_json(),
            "error": error_to_json(self.error) if self.error else None,
        }
        return with_texts(content)

    @classmethod
    def from_json(cls, content: dict[str, Any]) -> Outcome:
        """Return the outcome from `to_json`'s JSON; raises ValueError for another value."""
        content = restored(content)
        try:
            kind, text, known = content["kind"], content["text"], content["position_known"]
            status, error = content["status"], content["error"]
        except (TypeError, KeyError) as fault:
            raise ValueError(Text("not an outcome: {fault}", fault=fault)) from fault
        if kind not in ENDS or not isinstance(text, str) or not isinstance(known, bool):
            raise ValueError("not an outcome: it has no end state")
        return cls(kind, text, known, SenderStatus.from_json(status), error_from_json(error) if error else None)


def error_to_json(error: CNCStepperError) -> dict[str, Any]:
    """Return a CNCStepper error as plain values, with the templates of its texts."""
    place = asdict(error.place) if error.place else None
    words = {name: getattr(error, name) for name in WORDS}
    return with_texts({"type": type(error).__name__, "place": place, **words})


def error_from_json(content: dict[str, Any]) -> CNCStepperError:
    """Return the error from `error_to_json`'s values, of the same class; raises ValueError for other values."""
    try:
        content = restored(content)
        kind = getattr(errors, content["type"], None)
        place = Place(**content["place"]) if content["place"] else None
        words = [content[name] for name in WORDS]
    except (TypeError, KeyError) as error:
        raise ValueError(Text("not an error: {error}", error=error)) from error
    if not all(isinstance(word, str) for word in words):
        raise ValueError("not an error: its words are none")
    if not (isinstance(kind, type) and issubclass(kind, CNCStepperError)):
        kind = LinkError
    code, what, advice, value, limit = words
    return kind(code, what, place=place, advice=advice, value=value, limit=limit)


def take_refusal(event: dict[str, Any]) -> None:
    """Return the CNCStepper error of an event "refused"; None where it has none."""
    event["error"] = error_from_json(event["error"]) if event.get("error") else None
