# SPDX-License-Identifier: LGPL-2.1-or-later
"""The state sentence of the dock, and which controls are enabled in a state: no Qt, no FreeCAD, no memory.

Texts here are marked for the translators and shown through `tr`.
"""

from __future__ import annotations

from dataclasses import dataclass

from CNCStepper.control.protocol.grbl.capabilities import axis_word, missing, reason
from CNCStepper.control.session.job_phase import CONNECTED, JOB_RUNS, Phase
from CNCStepper.control.session.job_phase import WAITING as STANDING
from CNCStepper.workbench.services.translation import later

OFF, CALM, GOING, WAITING, DANGER = "off", "calm", "going", "waiting", "danger"


@dataclass(frozen=True)
class ControllerSnapshot:
    """The dock's view of the machine at one time.

    phase: "off" (no controller), "starting", "connecting", "unreached" (no connection came about), "gone" (it ended by
    itself), or the service's phase. machine_state: as grbl writes it. message: the program's words at a pause, the
    sentence of an alarm or of what ended the connection. job: whether a job is on its way; a machine may be
    held without one. homing, position_known: None while it is not known. cannot: what this machine cannot do at all.
    """

    phase: str = "off"
    machine_state: str = ""
    message: str = ""
    job: bool = False
    homing: bool | None = None
    position_known: bool | None = None
    cannot: tuple[str, ...] = ()

    @property
    def connected(self) -> bool:
        """Whether a controller answers."""
        return self.phase in CONNECTED

    @property
    def job_runs(self) -> bool:
        """Whether a job is being cut, also while it is held."""
        return self.job and self.connected

    @property
    def busy(self) -> bool:
        """Whether a connection is being made."""
        return self.phase in ("starting", "connecting")


@dataclass(frozen=True)
class Face:
    """The state in large letters, its colour by meaning, and one sentence below it."""

    headline: str
    tone: str
    sentence: str = ""


FACES = {
    "off": Face(later("Not connected"), OFF, later("Choose a port, then connect.")),
    "starting": Face(later("Connecting…"), OFF, later("The link to the controller is being started.")),
    "connecting": Face(later("Connecting…"), OFF, later("Waiting for the controller to answer.")),
    "unreached": Face(later("No connection"), DANGER, later("Look at the port, then connect again.")),
    "gone": Face(later("Connection lost"), DANGER, later("Look at the machine, then connect again.")),
    "idle": Face(later("Idle"), CALM, later("The machine is at rest and waits.")),
    "running": Face(later("Running"), GOING, later("The job is being cut.")),
    "finishing": Face(later("Finishing"), GOING, later("All lines are sent; the last moves are being cut.")),
    "holding": Face(later("Holding…"), WAITING, later("The machine slows down.")),
    "held": Face(later("Held"), WAITING, later("The machine is at rest; nothing is lost. Resume or stop.")),
    Phase.RETREATED: Face(later("On its cut"), WAITING, later("The job waits on its cut. Resume cuts on from there.")),
    "paused": Face(later("Paused"), WAITING, later("The program waits; Resume continues it.")),
    "door": Face(later("Door"), WAITING, later("Close the safety door, then resume.")),
    "stopping": Face(later("Stopping…"), WAITING, later("The machine slows down, then the job is ended.")),
    "alarm": Face(later("Alarm"), DANGER, later("Find the cause, then home the machine or unlock it.")),
    "jogging": Face(later("Jogging"), GOING, later("The machine is moved by hand.")),
    "homing": Face(later("Homing"), GOING, later("The machine looks for its switches.")),
    "busy": Face(later("Busy"), WAITING, later("The controller does something that was not asked for here.")),
}
LOST = later("The position of the table is unknown: home the machine, or set the work zero again.")
WITH_OWN_WORDS = ("paused", "alarm", "gone", "unreached", "held", "door")  # where a message says more than our sentence


def face(moment: ControllerSnapshot) -> Face:
    """Return what to show large; its sentence is still to be translated unless it is the moment's own message."""
    found = FACES.get(moment.phase, FACES["busy"])
    if moment.message and moment.phase in WITH_OWN_WORDS:
        return Face(found.headline, found.tone, sentences(moment.message))
    if moment.phase == "idle" and moment.position_known is False:
        return Face(found.headline, found.tone, LOST)
    return found


def sentences(*texts: str) -> str:
    """Return the texts that are not empty as sentences: with a capital and a full stop."""
    return " ".join(f"{text[0].upper()}{text[1:].rstrip('.')}." for text in texts if text)


@dataclass(frozen=True)
class Rule:
    """When a control works: in these phases; what it then does; why it does not in all others."""

    phases: frozenset[str]
    does: str
    why_not: str


NOT_CONNECTED = later("Connect to a controller first.")
RULES = {
    "hold": Rule(
        frozenset({"running", "finishing", "jogging", "busy"}),
        later("Hold: slow down and stop on the path; nothing is lost, the spindle keeps turning."),
        later("Nothing moves that could be held."),
    ),
    "resume": Rule(
        STANDING,
        later("Resume after a hold, a pause or the door."),
        later("The machine is not held: there is nothing to resume."),
    ),
    "back": Rule(
        frozenset({"running", "holding", "finishing", "held", "paused", Phase.RETREATED}),
        later("Go back along the cut by this length; a machine that moves is held first."),
        later("The tool goes back along its cut while a job is cut, or is held."),
    ),
    "aside": Rule(
        frozenset({"held"}),
        later("Allow jogging: spindle or beam off; Resume returns to the cut on a safe path."),
        later("The machine is made free to jog while a job is held."),
    ),
    "forward": Rule(
        frozenset({"held", Phase.RETREATED}),
        later("Go forward along the cut by this length, at most to where it was held."),
        later("The tool goes forward again only after it went back."),
    ),
    "stop": Rule(
        JOB_RUNS - {"stopping"} | {"jogging", "homing", "busy"},
        later(
            "Stop: slow down, stop, spindle off; the rest of the job is not cut. This is not an emergency stop: the"
            " emergency stop is on the machine."
        ),
        later("Nothing moves that could be stopped. The emergency stop is on the machine."),
    ),
    "jog": Rule(
        frozenset({"idle", "jogging"}),
        later("Move the machine in this direction."),
        later("Jogging works only while the machine is idle."),
    ),
    "zero": Rule(
        frozenset({"idle"}),
        later("Make this position the work zero of the axis."),
        later("The work zero can be set only while the machine is idle."),
    ),
    "outline": Rule(
        frozenset({"idle"}),
        later("Drive round the job in air, at its safe height and without power, before the first cut."),
        later("The outline is run only while the machine is idle."),
    ),
    "home": Rule(
        frozenset({"idle", "alarm"}),
        later("Home the machine: it finds its zero with its limit switches."),
        later("Homing works only while the machine is idle or in alarm."),
    ),
    "unlock": Rule(
        frozenset({"alarm"}),
        later("Unlock the alarm without homing: only if the position is certainly right."),
        later("The machine is not in alarm: there is nothing to unlock."),
    ),
    "override": Rule(
        CONNECTED - {"alarm", "homing", "stopping", "busy"},
        later("Change the programmed value while cutting, in percent."),
        later("Overrides work only while the machine is idle or cutting."),
    ),
    "relay": Rule(
        frozenset({"idle"}),
        later("Switch it on or off."),
        later("Relays are switched by hand only while the machine is idle."),
    ),
    "console": Rule(
        frozenset({"idle", "alarm"}),
        later("A line for the controller, sent with Return. The arrow keys bring back the lines before."),
        later("Lines can be typed only while the machine is idle or in alarm."),
    ),
}
AT_A_STAND = {  # the machine states in which these work between two lines, or two ways along the cut
    "paused": {"jog": ("Idle", "Jog", "Tool"), "zero": ("Idle", "Tool"), "hold": ("Jog",)},
    Phase.RETREATED: {"jog": ("Idle", "Jog"), "hold": ("Jog",)},  # what lies behind was cut from the zero that it has
}
HELD_AND_LOST = later(
    "The machine's position is unknown: stop the job, then home the machine or set the zero of all axes."
)
NO_HOMING = later("This machine has no homing switches set up ($22=0).")


COMMAND_OF = {"back": "retrace", "forward": "retrace"}  # by which a control is carried out, where it is another word
ALSO_NEEDS = {"aside": "jog-hold"}


def why_not(control: str, moment: ControllerSnapshot) -> str:
    """Return why a control of `RULES` cannot work now, "" when it can; what a machine never can is said first."""
    if not moment.connected:
        return NOT_CONNECTED
    word = missing(COMMAND_OF.get(control, control), moment.cannot)
    if word and control != "stop":  # which ends the sending at least, and stops a jog
        return reason(word)
    if ALSO_NEEDS.get(control) in moment.cannot:
        return reason(ALSO_NEEDS[control])
    if control == "home" and moment.homing is False:
        return NO_HOMING
    if control == "resume" and moment.position_known is False and moment.phase in STANDING and not moment.job:
        return HELD_AND_LOST
    rule = RULES[control]
    stands = moment.machine_state in AT_A_STAND.get(moment.phase, {}).get(control, ())
    return "" if stands or moment.phase in rule.phases else rule.why_not


def why_not_outline(moment: ControllerSnapshot) -> str:
    """Return why the outline of a job cannot be run now, "" when it can.

    It can wherever a job can be sent: without homing the flow of sending asks a person for the work zero.
    """
    return why_not("outline", moment) or (LOST if moment.position_known is False else "")


def why_not_axis(axis: str, moment: ControllerSnapshot) -> str:
    """Return why an axis cannot be jogged though others can, "" when it can."""
    word = axis_word(axis)
    return reason(word) if word in moment.cannot else ""


def does(control: str, moment: ControllerSnapshot) -> str:
    """Return what a control of `RULES` does, or what it cannot reach where it can be pressed all the same."""
    word = missing(control, moment.cannot) if control == "stop" else ""
    return reason(word) if word else RULES[control].does


def why_not_connect(moment: ControllerSnapshot, port: str) -> str:
    """Return why no connection to this port can be made now, "" when one can."""
    if not port:
        return later("Choose a port, or type an address.")
    if moment.connected:
        return later("A controller is connected already.")
    return later("The connection is being made.") if moment.busy else ""


def why_not_disconnect(moment: ControllerSnapshot) -> str:
    """Return why the connection cannot be left now, "" when it can."""
    if moment.job_runs:
        return later("A job is being cut: stop it first.")
    return "" if moment.connected or moment.busy else later("No controller is connected.")
