# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper machine-test`: pulses, relays, inputs, motion in air, measurements and corrections."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import click

from CNCStepper.cli.common.language import look_up, show_text, translated
from CNCStepper.cli.common.options import NumberType
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.verb import Verbs
from CNCStepper.cli.machine.machine import say_written
from CNCStepper.cli.machine.service_client import ServiceClient, ServicePort, port_options
from CNCStepper.errors import CNCStepperError, MachineRefusal, Text
from CNCStepper.machine.axis_tests import (
    USUAL_REPEATS,
    Readings,
    axis_of,
    backlash_mm,
    check_reading,
    corrected_steps_per_mm,
    is_within_noise,
    length_of_pulses_mm,
    skew_mm_m,
    squareness_of_diagonals,
    squareness_of_triangle,
)
from CNCStepper.machine.own_profiles import change
from CNCStepper.machine.profile import AXIS_NAMES, Machine, load_machine
from CNCStepper.machine.relays import relay_named, relays_of

FEED_MM_MIN = 600.0
LOOK_S = 60.0
FIRST_SETTING = 100  # of grbl: the steps per mm of X
AxisType = click.Choice(AXIS_NAMES, case_sensitive=False)
LengthType = NumberType(kind="length")
axis_argument = click.argument("axis", type=AxisType)
feed_option = click.option("--feed", type=NumberType(kind="feed"), default=FEED_MM_MIN, show_default=True,
                           help="Speed in mm/min.")  # fmt: skip
repeats_option = click.option("--repeats", type=click.IntRange(1, 100), default=USUAL_REPEATS, show_default=True)
yes_option = click.option("--yes", is_flag=True, help="Write the corrected value without asking.")


machine_options = partial(port_options, needs_machine=True)


class Bench:
    """The machine at a port, with its profile, during a test."""

    def __init__(self, talk: ServiceClient, machine: Machine):
        self.talk, self.machine = talk, machine

    def send(self, lines: Sequence[str]) -> None:
        """Send lines one after the other, each when the machine stands; Ctrl-C brakes.

        Raises MachineRefusal with the controller's words where it refuses one.
        """
        for line in lines:
            try:
                answer = self.talk.type(line)
            except KeyboardInterrupt:
                self.talk.client.stop()
                raise
            if answer != "ok":
                raise MachineRefusal("test-line", answer, value=line, advice="nothing more of the test is sent")

    def check_room(self, axis: str, low_mm: float, high_mm: float) -> None:
        """Raise JobError where an axis would leave its travel; nothing is known of one that was not homed."""
        from CNCStepper.control.operator.machine_test_lines import check_room

        axis_of(self.machine, axis)
        status = self.talk.ask_status()
        check_room(self.machine, status.mpos_mm if status.homed else None, axis, low_mm, high_mm)


def on_bench(at: ServicePort, work: Callable[[Bench], None]) -> None:
    """Connect to the machine at a port and test it."""
    machine = load_machine(at.machine)
    with ServiceClient(at) as talk:
        work(Bench(talk, machine))


@click.group("machine-test", cls=Verbs)
def command() -> None:
    """Try a machine out and measure it: pulses, relays, inputs, a square, a circle, travel, backlash, squareness.

    Nothing is cut: take the tool out, or lift it, and keep a hand at the emergency stop. Ctrl-C brakes.
    """


@command.command("pulses")
@axis_argument
@click.argument("count", type=click.IntRange(1, 10_000_000))
@click.option("--back", is_flag=True, help="In the negative direction.")
@feed_option
@machine_options
def pulses(axis: str, count: int, back: bool, feed: float, at: ServicePort) -> None:
    """Send COUNT pulses to one axis, in one direction."""
    from CNCStepper.control.operator.machine_test_lines import way

    def work(bench: Bench) -> None:
        length_mm = length_of_pulses_mm(bench.machine, axis, -count if back else count)
        bench.check_room(axis, min(length_mm, 0.0), max(length_mm, 0.0))
        bench.send([way(axis, length_mm, feed)])
        show_text(
            "{axis}: {count} pulses {forward}, {length_mm:g} mm",
            axis=axis.upper(),
            count=count,
            forward="back" if back else "forward",
            length_mm=abs(length_mm),
        )

    on_bench(at, work)


@command.command("relays")
@click.argument("names", nargs=-1)
@click.option(
    "--seconds", type=click.FloatRange(0.1, 60.0), default=1.0, show_default=True, help="How long each is on."
)
@machine_options
def relays(names: tuple[str, ...], seconds: float, at: ServicePort) -> None:
    """Switch the relays of the profile on and off again, one by one; only those that are named where some are."""
    from CNCStepper.control.operator.machine_test_lines import ASK_MODES, outputs_of, switching

    def work(bench: Bench) -> None:
        chosen = [relay_named(bench.machine, name) for name in names] or relays_of(bench.machine)
        for relay in chosen:
            outputs = outputs_of(_asked(bench.talk, ASK_MODES))
            try:
                bench.send(switching(bench.machine, relay.device, True, outputs))
                show_text("{name}: switched on", name=relay.name)
                time.sleep(seconds)
            finally:
                bench.send(switching(bench.machine, relay.device, False, outputs))
            show_text("{name}: switched off", name=relay.name)
        if not chosen:
            show_text(
                "this machine has no relay: [[relay]] of the profile names those of a controller that switches some"
            )

    on_bench(at, work)


@command.command("inputs")
@click.option("--seconds", type=click.FloatRange(0.1, 3600.0), default=LOOK_S, show_default=True)
@machine_options
def inputs(seconds: float, at: ServicePort) -> None:
    """Print which inputs are on, at each change: XYZ limit switches, P probe, D door, H hold, R reset, S start.

    Those of a parallel port are printed by what they do and their pin.
    """
    from CNCStepper.control.operator.machine_test_lines import inputs_on

    def work(bench: Bench) -> None:
        end_s, last = time.monotonic() + seconds, None
        while time.monotonic() < end_s:
            status = bench.talk.ask_status()
            pins = ", ".join(f"{entry.act} ({entry.pin})" for entry in inputs_on(bench.machine, status)) or status.pins
            if pins != last:
                show_text("inputs that are on: {none}", none=pins or "none")
                last = pins

    on_bench(at, work)


@command.command("square")
@click.option("--side", type=LengthType, default=50.0, show_default=True, help="In mm.")
@click.option("--height", type=NumberType(kind="length"), default=None, help="Lift Z by so many mm for it.")
@feed_option
@machine_options
def square(side: float, height: float | None, feed: float, at: ServicePort) -> None:
    """Drive a square in air, from here along X and Y in their positive directions, and back to here."""
    from CNCStepper.control.operator.machine_test_lines import check_plane
    from CNCStepper.control.operator.machine_test_lines import square as lines

    def work(bench: Bench) -> None:
        check_plane(bench.machine)
        bench.check_room("x", 0.0, side)
        bench.check_room("y", 0.0, side)
        _in_air(bench, height, feed, lambda: bench.send(lines(side, feed)))
        show_text("square of {side:g} mm at {feed:g} mm/min: done", side=side, feed=feed)

    on_bench(at, work)


@command.command("circle")
@click.option("--diameter", type=LengthType, default=50.0, show_default=True, help="In mm.")
@click.option("--height", type=NumberType(kind="length"), default=None, help="Lift Z by so many mm for it.")
@feed_option
@machine_options
def circle(diameter: float, height: float | None, feed: float, at: ServicePort) -> None:
    """Drive a circle in air, clockwise, from here; its centre lies on X in the positive direction."""
    from CNCStepper.control.operator.machine_test_lines import ASK_MODES, check_no_power, check_plane, modes_back
    from CNCStepper.control.operator.machine_test_lines import circle as line

    def work(bench: Bench) -> None:
        check_plane(bench.machine)
        bench.check_room("x", 0.0, diameter)
        bench.check_room("y", -diameter / 2, diameter / 2)
        modes = _asked(bench.talk, ASK_MODES)
        check_no_power(modes)
        back = modes_back(modes)
        _in_air(bench, height, feed, lambda: _with_modes(bench, line(diameter, feed), back))
        show_text("circle of {diameter:g} mm at {feed:g} mm/min: done", diameter=diameter, feed=feed)

    on_bench(at, work)


@command.command("travel")
@axis_argument
@click.option("--length", type=LengthType, default=100.0, show_default=True, help="That is commanded, in mm.")
@click.option("--back", is_flag=True, help="In the negative direction.")
@repeats_option
@click.option("--plot", type=OutputPath(""), help="Draw the readings into this file: .png, .svg or .pdf.")
@feed_option
@yes_option
@machine_options
def travel(
    axis: str, length: float, back: bool, repeats: int, plot: Path | None, feed: float, yes: bool,
    at: ServicePort,
) -> None:  # fmt: skip
    """Command a length, ask for the measured one, repeat, and correct the axis' steps_per_mm.

    Each start is reached in the sense of the length, so that backlash does not count. Prints mean and standard
    deviation, and proposes the corrected value, which is written into the profile if you say so. A controller of grbl's
    family has steps per mm of its own ($100 to $102): it is offered the same value.
    """
    from CNCStepper.control.operator.machine_test_lines import arrivals

    def work(bench: Bench) -> None:
        signed = -length if back else length
        play_mm = axis_of(bench.machine, axis).backlash_mm
        start, along, home = arrivals(axis, signed, play_mm, feed)
        bench.check_room(axis, min(signed, 0.0) - play_mm - 2.0, max(signed, 0.0) + play_mm + 2.0)
        measured = []
        for number in range(1, repeats + 1):
            bench.send(start)
            turn = {"number": number, "repeats": repeats}
            click.pause(translated(Text("{number} of {repeats}: set the scale to zero, then press a key", **turn)))
            bench.send(along)
            measured.append(_asked_length(Text("{number} of {repeats}: measured length in mm", **turn), length))
            bench.send(home)
        readings = Readings(tuple(measured))
        _say_travel(axis, length, readings, plot)
        _correct_steps(bench, at.machine, axis, length, readings, yes)

    on_bench(at, work)


@command.command("backlash")
@axis_argument
@click.option("--distance", type=LengthType, default=5.0, show_default=True, help="From which it comes, in mm.")
@click.option("--repeats", type=click.IntRange(1, 100), default=3, show_default=True)
@feed_option
@yes_option
@machine_options
def backlash(axis: str, distance: float, repeats: int, feed: float, yes: bool, at: ServicePort) -> None:
    """Come to one place from both sides, ask what a dial shows there, and propose the axis' backlash_mm.

    Set the dial so that it counts up in the axis' positive direction.
    """
    from CNCStepper.control.operator.machine_test_lines import both_sides

    def work(bench: Bench) -> None:
        bench.check_room(axis, -distance, distance)
        below, above = both_sides(axis, distance, feed)
        shown: dict[str, list[float]] = {"below": [], "above": []}
        for number in range(1, repeats + 1):
            for side, lines in ((Text("below"), below), (Text("above"), above)):
                bench.send(lines)
                asked = Text(
                    "{number} of {repeats}: the dial, come from {side}, in mm",
                    number=number,
                    repeats=repeats,
                    side=side,
                )
                shown[side].append(click.prompt(translated(asked), type=NumberType()))
        from_below, from_above = Readings(tuple(shown["below"])), Readings(tuple(shown["above"]))
        play_mm = backlash_mm(from_below, from_above)
        was_mm = axis_of(bench.machine, axis).backlash_mm
        show_text(
            "{axis}: backlash {play_mm:.4f} mm (profile: {was_mm:g} mm), standard deviations {below_mm:.4f} and "
            "{above_mm:.4f} mm",
            axis=axis.upper(), play_mm=play_mm, was_mm=was_mm,
            below_mm=from_below.deviation_mm, above_mm=from_above.deviation_mm,
        )  # fmt: skip
        _offer(at.machine, ("axis", axis, "backlash_mm"), round(play_mm, 4), yes)

    on_bench(at, work)


@command.command("squareness")
@click.option("--x", "side_x", type=LengthType, default=300.0, show_default=True, help="Side along X, in mm.")
@click.option("--y", "side_y", type=LengthType, default=400.0, show_default=True, help="Side along Y, in mm.")
@click.option("--diagonals", is_flag=True, help="Measure both diagonals of the rectangle, not only one (3-4-5).")
@feed_option
@machine_options
def squareness(side_x: float, side_y: float, diagonals: bool, feed: float, at: ServicePort) -> None:
    """Drive to the corners of a rectangle, ask for its diagonals, and print the angle between X and Y.

    At each corner mark the tool's place on the table. With steps_per_mm right, one distance is enough: that of the ends
    of both sides (3-4-5); two diagonals need no right steps_per_mm.
    """
    from CNCStepper.control.operator.machine_test_lines import way

    def work(bench: Bench) -> None:
        bench.check_room("x", 0.0, side_x)
        bench.check_room("y", 0.0, side_y)
        corners: tuple[tuple[str, list[str]], ...] = (
            (Text("mark the lower left corner, then press a key"), []),
            (Text("mark the lower right corner, then press a key"), [way("x", side_x, feed)]),
            (Text("mark the upper right corner, then press a key"), [way("y", side_y, feed)]),
            (Text("mark the upper left corner, then press a key"), [way("x", -side_x, feed)]),
        )
        for question, lines in corners:
            bench.send(lines)
            click.pause(translated(question))
        bench.send([way("y", -side_y, feed)])
        _say_squareness(side_x, side_y, diagonals)

    on_bench(at, work)


# --- inside --------------------------------------------------------------------------------------


def _in_air(bench: Bench, height_mm: float | None, feed: float, drive: Callable[[], None]) -> None:
    """Lift the tool, drive, and bring it down again; where driving fails it stays up."""
    from CNCStepper.control.operator.machine_test_lines import way

    if height_mm:
        bench.check_room("z", 0.0, height_mm)
        bench.send([way("z", height_mm, feed)])
    drive()
    if height_mm:
        bench.send([way("z", -height_mm, feed)])


def _with_modes(bench: Bench, line: str, back: str) -> None:
    try:
        bench.send([line])
    finally:
        bench.send([back])


def _asked(talk: ServiceClient, line: str) -> str:
    """Return the controller's words to a question."""
    words: list[str] = []
    talk.client.type(line)

    def is_answer(event: dict[str, Any]) -> bool:
        if event["event"] == "console":
            words.append(event["text"])
        return event["event"] == "answer"

    talk.until(is_answer)
    return next((text for text in words if text.startswith("[")), "")


def _asked_length(question: str, commanded_mm: float) -> float:
    """Ask until a length is given that can be the commanded one."""
    while True:
        measured_mm = float(click.prompt(translated(question), type=LengthType))
        try:
            check_reading(measured_mm, commanded_mm)
        except CNCStepperError as error:
            show_text("{error}", err=True, error=error)
        else:
            return measured_mm


def _say_travel(axis: str, length_mm: float, readings: Readings, plot: Path | None) -> None:
    show_text(
        "{axis}: commanded {length_mm:g} mm, {values_mm} readings: mean {mean_mm:.4f} mm, standard "
        "deviation {deviation_mm:.4f} mm, of the mean {mean_deviation_mm:.4f} mm, range {range_mm:.4f} mm",
        axis=axis.upper(),
        length_mm=length_mm,
        values_mm=len(readings.values_mm),
        mean_mm=readings.mean_mm,
        deviation_mm=readings.deviation_mm,
        mean_deviation_mm=readings.mean_deviation_mm,
        range_mm=readings.range_mm,
    )
    if plot:
        from CNCStepper.simulation.views.readings_plot import save_readings

        title = f"{axis.upper()}, {len(readings.values_mm)} readings of {length_mm:g} mm"
        save_readings(plot, title, length_mm, readings.values_mm, readings.mean_mm, readings.deviation_mm)
        show_text("{plot}: the readings", plot=plot)


def _correct_steps(bench: Bench, profile: str, axis: str, length_mm: float, readings: Readings, yes: bool) -> None:
    steps = axis_of(bench.machine, axis).steps_per_mm
    if is_within_noise(length_mm, readings):
        show_text(
            "{axis}: the commanded length is the measured one within the readings' scatter: "
            "steps_per_mm {steps:g} stays",
            axis=axis.upper(), steps=steps,
        )  # fmt: skip
        return
    new = round(corrected_steps_per_mm(steps, length_mm, readings), 4)
    show_text("{axis}: steps_per_mm {steps:g} becomes {new:g}", axis=axis.upper(), steps=steps, new=new)
    if not _offer(profile, ("axis", axis, "steps_per_mm"), new, yes):
        return
    setting = f"${FIRST_SETTING + AXIS_NAMES.index(axis)}={new:.4f}"
    asked = Text("write {setting} to the controller too? its position is unknown afterwards", setting=setting)
    if yes or click.confirm(translated(asked)):
        bench.send([setting])
        show_text("{setting}: written; home the machine, or set its zero", setting=setting)


def _offer(profile: str, path: tuple[str, ...], value: float, yes: bool) -> bool:
    """Write a corrected value into the profile if that is wanted; return whether it was."""
    asked = Text("write {key}={value:g} into {profile}?", key=".".join(path), value=value, profile=profile)
    if not yes and not click.confirm(translated(asked)):
        return False
    say_written(change(profile, {path: value}))
    return True


def _say_squareness(side_x: float, side_y: float, diagonals: bool) -> None:
    if diagonals:
        rising = click.prompt(look_up("lower left to upper right in mm"), type=LengthType)
        falling = click.prompt(look_up("lower right to upper left in mm"), type=LengthType)
        deviation_deg = squareness_of_diagonals(side_x, side_y, rising, falling)
    else:
        deviation_deg = squareness_of_triangle(
            side_x, side_y, click.prompt(look_up("lower right to upper left in mm"), type=LengthType)
        )
    show_text(
        "the angle between X and Y is {angle_deg:.4f}°: {deviation_deg:+.4f}°, {skew_mm_m:.3f} mm over a metre",
        angle_deg=90.0 + deviation_deg, deviation_deg=deviation_deg, skew_mm_m=abs(skew_mm_m(deviation_deg)),
    )  # fmt: skip
    show_text("no value of the profile takes that up: turn the gantry until it is 90°")
