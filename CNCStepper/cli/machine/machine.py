# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper machine`: profiles listed, made, shown, changed key by key, read from and written for FreeCAD."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.common.language import show_text, translated
from CNCStepper.cli.common.path_types import InputPath, OutputPath
from CNCStepper.cli.common.verb import Verbs
from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.machine.files.fcm_files import read_fcm, write_fcm
from CNCStepper.machine.own_profiles import (
    Written,
    change,
    create,
    profile_content,
    profile_text,
    profiles,
    read_change,
    save,
    values_of,
)
from CNCStepper.machine.profile import load_machine


@click.group("machine", cls=Verbs)
def command() -> None:
    """Machine profiles: those that ship, and your own.

    Your own lie in your configuration folder and are named like the shipped ones wherever a command takes --machine.
    """


@command.command("list")
def list_() -> None:
    """List all profiles: name, whose it is, controller, processes, travel.

    One of yours that cannot be read is listed with the reason.
    """
    for profile in profiles():
        own = Text("yours, instead of the shipped one") if profile.is_shipped else Text("yours")
        whose = own if profile.is_own else Text("shipped")
        show_text("{name} ({whose}): {summary}", name=profile.name, whose=whose, summary=_summary(profile.name))


@command.command("new")
@click.argument("name")
@click.option("--from", "source", default="table-a", show_default=True, help="A profile, or the path of one.")
def new(name: str, source: str) -> None:
    """Make a profile of your own from another one; its comments come along.

    Change what differs with `cncstepper machine set`, or in the file itself.
    """
    show_text("{path}: made from {source}", path=create(name, source).path, source=source)


@command.command("show")
@click.argument("name")
@click.argument("keys", nargs=-1)
def show(name: str, keys: tuple[str, ...]) -> None:
    """Print a profile as it is written; with KEYS, such as axis.x or planner.ramp, what is in force there.

    What a profile leaves out has a value too: KEYS print it. `.` is all of them.
    """
    if not keys:
        click.echo(profile_text(name), nl=False)
        return
    machine = load_machine(name)
    for key in keys:
        for line in values_of(machine, [part for part in key.split(".") if part]):
            click.echo(line)


@command.command("set")
@click.argument("name")
@click.argument("changes", nargs=-1, required=True, metavar="KEY=VALUE...")
def set_(name: str, changes: tuple[str, ...]) -> None:
    """Change keys of a profile: axis.x.steps_per_mm=80, planner.ramp=s_curve, outputs.coolant="['mist']".

    KEY= without a value takes a key or table out. The whole profile is checked before anything is written. A shipped
    profile is never changed: its first change makes one of yours with its name.
    """
    written = change(name, dict(map(read_change, changes)))
    say_written(written)


@command.command("import")
@click.argument("file", type=InputPath())
@click.argument("name")
@click.option("--from", "source", default="table-a", show_default=True, help="The profile that has all other values.")
def import_(file: Path, name: str, source: str) -> None:
    """Make your profile NAME from FILE, a machine file of FreeCAD's (.fcm).

    It has names, travel, speeds and the tool head; steps per mm, accelerations and homing come from --from.
    """
    content = read_fcm(file, profile_content(source))
    create(name, source)
    say_written(save(name, content))


@command.command("export")
@click.argument("name")
@click.option("-o", "--out", required=True, type=OutputPath(""), help="The file that is written.")
def export(name: str, out: Path) -> None:
    """Write a profile to the file --out, a machine file for FreeCAD (.fcm)."""
    write_fcm(out, load_machine(name))
    show_text("{out}: {name} for FreeCAD", out=out, name=name)


def say_written(written: Written) -> None:
    """Print the result of a change."""
    if written.copied_from:
        show_text(
            "{copied_from} ships with the program and stays as it is; your copy takes its place",
            copied_from=written.copied_from,
        )
    if not written.comments_kept:
        show_text("the file is written anew, in our own layout: its comments are not in it")
    show_text("{path}: written", path=written.path)


def _summary(name: str) -> str:
    try:
        machine = load_machine(name)
    except CNCStepperError as error:
        return translated(error.text)
    travel = " x ".join(f"{axis.travel_max_mm - axis.travel_min_mm:g}" for axis in machine.own_axes.values())
    return f"{machine.name}, {machine.controller}, {', '.join(machine.processes)}, {travel} mm"
