# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper settings`: a controller's `$$` settings backed up, compared, restored, and made a machine profile."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.common.language import show_text, translated
from CNCStepper.cli.common.path_types import InputPath, OutputPath
from CNCStepper.cli.common.verb import Verbs
from CNCStepper.cli.machine.machine import say_written
from CNCStepper.cli.machine.service_client import Event, ServiceClient, ServicePort, port_options
from CNCStepper.control.settings.controller_identity import ControllerIdentity, identity_of
from CNCStepper.control.settings.settings_comparison import ComparedSetting, compare_settings
from CNCStepper.control.settings.settings_file import read_settings, write_settings
from CNCStepper.control.settings.settings_profile import profile_from_settings, settings_of_profile
from CNCStepper.control.settings.settings_restore import (
    ASK_IDENTITY,
    ASK_SETTINGS,
    check_answer,
    check_restored,
    check_takes_settings,
    restore_lines,
)
from CNCStepper.errors import Text
from CNCStepper.machine.own_profiles import create, profile_content, save
from CNCStepper.machine.profile import load_machine, profile_names

MISSING = "-"
yes_option = click.option("--yes", is_flag=True, help="Write without asking.")


@click.group("settings", cls=Verbs)
def command() -> None:
    """Back up, compare and restore the settings ($$) of a controller, or make a machine profile of them.

    A backup is a text of lines $100=80, as $$ prints it and other senders save it.
    """


@command.command("backup")
@click.option("-o", "--out", required=True, type=OutputPath(""), help="The file that is written.")
@port_options
def backup(out: Path, at: ServicePort) -> None:
    """Write the settings of the controller at --port to the file --out."""
    with ServiceClient(at) as talk:
        found = _asked(talk)
    write_settings(out, found.settings, f"{found.text} at {at.name}")
    show_text("{out}: {settings} settings of {text}", out=out, settings=len(found.settings), text=found.text)


@command.command("compare")
@click.argument("other")
@click.option("--all", "is_all", is_flag=True, help="List the settings that are equal too.")
@port_options
def compare(other: str, is_all: bool, at: ServicePort) -> None:
    """Compare the controller at --port with OTHER: a backup's file, or a machine profile by its name."""
    with ServiceClient(at) as talk:
        found = _asked(talk)
    rows = list(compare_settings(found.settings, _wanted(other)))
    for row in rows:
        if is_all or row.differs:
            click.echo(_row(row))
    show_text("{rows} of {all_rows} settings differ", rows=sum(row.differs for row in rows), all_rows=len(rows))


@command.command("restore")
@click.argument("other")
@yes_option
@port_options
def restore(other: str, yes: bool, at: ServicePort) -> None:
    """Make the settings of the controller at --port those of OTHER: a backup's file, or a machine profile by its name.

    Only what differs is written, line by line, each answered; then all are read back. What the controller does not
    have is left out. Where steps per mm change, the position is unknown afterwards: home it, or set its zero.
    """
    wanted = _wanted(other)
    with ServiceClient(at) as talk:
        found = _asked(talk)
        check_takes_settings(found.firmware)
        lines = restore_lines(found.settings, wanted)
        for row in compare_settings(found.settings, wanted):
            if row.differs:
                click.echo(_row(row))
        if not lines or not (yes or _confirmed(lines, at)):
            show_text("nothing was written")
            return
        for done, line in enumerate(lines):
            check_answer(lines, done, talk.type(line))
        check_restored(_asked(talk).settings, lines, wanted)
    show_text("{lines} settings written and read back", lines=len(lines))


def _confirmed(lines: list[str], at: ServicePort) -> bool:
    """Ask whether these settings are to be written."""
    return click.confirm(translated(Text("write these {count} settings to {port}?", count=len(lines), port=at.name)))


@command.command("profile")
@click.argument("name")
@click.option("--from", "source", default="table-a", show_default=True, help="The profile that has all other values.")
@port_options
def profile(name: str, source: str, at: ServicePort) -> None:
    """Make or change your profile NAME by the settings of the controller at --port.

    Steps per mm, speeds, accelerations, travel, homing, spindle and planner are read; the rest comes from --from.
    """
    with ServiceClient(at) as talk:
        found = _asked(talk)
    if name not in profile_names():
        create(name, source)
    content = profile_from_settings(profile_content(name), found.settings)
    say_written(save(name, content | ({"controller": found.controller} if found.controller else {})))


def _asked(talk: ServiceClient) -> ControllerIdentity:
    """Return what the controller says of itself and its settings."""
    words: list[str] = []

    def is_answer(event: Event) -> bool:
        if event["event"] == "console":
            words.append(event["text"])
        return bool(event["event"] == "answer")

    for question in (ASK_IDENTITY, ASK_SETTINGS):
        talk.client.type(question)
        answer = str(talk.until(is_answer)["text"])
        if answer != "ok":
            raise click.ClickException(answer)
    return identity_of(words)


def _wanted(other: str) -> dict[int, float]:
    """Return the settings of a backup, or those that a profile gives."""
    if other in profile_names():
        return settings_of_profile(load_machine(other))
    return read_settings(InputPath().convert(other, None, None))


def _row(row: ComparedSetting) -> str:
    name, unit = row.name
    sides = " -> ".join(MISSING if value is None else f"{value:.10g}" for value in (row.left, row.right))
    words = f"{name}, {unit}" if name and unit else name
    return f"${row.number}: {sides}" + (f"  ({words})" if words else "")
