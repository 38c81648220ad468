# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `cncstepper`: one module a verb, imported only when that verb is called."""

from __future__ import annotations

import atexit
import gc
import importlib
import os
import sys
from typing import Any

import click

from CNCStepper import __version__, kernel_cache
from CNCStepper.cli.common.language import choose_language, in_language, look_up, show_text, translated
from CNCStepper.cli.common.option_hints import show_hints
from CNCStepper.errors import CNCStepperError

STOPPED = 130  # 128 + SIGINT
YOUNG_OBJECTS = 100_000  # between two looks for garbage: of the many that imports make none is
FAMILIES = {  # folder of the verbs' modules: title in the help, and its verbs
    "drawing": (
        "Read drawings",
        {
            "drawing": "Show what is in a drawing and what is wrong with it; mend it.",
            "job": "Make a job file of a drawing by the rules of a template.",
        },
    ),
    "program": (
        "Make and check programs",
        {
            "run": "Make program, report, certificate and picture from a job file.",
            "check": "Check a program against a machine; exit 0 clean, 1 refused.",
            "time": "Print the seconds that a program takes.",
            "steps": "Write every step of a program: letters, bytes, port writes, edges.",
            "simulate": "Draw the part that a program cuts.",
            "compare": "Compare the motion of two programs: figures and one picture.",
            "print": "Put a program and its work surface on paper: PDF or HTML.",
            "trace": "Print the canonical calls of a program.",
        },
    ),
    "editing": (
        "Change programs",
        {
            "edit": "Move, scale, turn, mirror, renumber, split ... a program.",
            "compact": "Rewrite tiny moves of a program as arcs and longer lines.",
            "convert": "Write a program in another dialect.",
        },
    ),
    "sheets": (
        "Many parts",
        {
            "nest": "Place the parts of an order on sheets, remnants or a strip.",
            "arrange": "Make one program of several, each placed, turned and counted.",
            "batch": "Make, nest, prove and price the drawings of an order.",
            "slice": "Cut a solid into sheets of a thickness: drawings, marks, nested pieces.",
        },
    ),
    "calculators": (
        "Calculate",
        {
            "tools": "List the tools of a FreeCAD library or a LinuxCNC table, and convert them.",
            "chart": "List, show and convert cut charts; write kerf and speed tests.",
            "feeds": "Print feed and speed of a tool in a material.",
            "axis": "Print steps per mm, pulse rate, motor speed and resolution of an axis.",
            "part-records": "Print mean, deviation and ratio to the nominal of measured parts.",
        },
    ),
    "machine": (
        "Set up a machine",
        {
            "machine": "List, make, show and change machine profiles; read and write FreeCAD's.",
            "settings": "Back up, compare and restore a controller's settings.",
            "machine-test": "Try a machine out and measure it: pulses, relays, inputs, travel.",
            "ports": "List the serial ports, or say what controller answers at one.",
            "home": "Let a machine find its own zero.",
            "zero": "Make the tool's place the work zero.",
            "jog": "Move a machine's axes by hand.",
            "console": "Type lines to a controller, with history.",
            "disconnect": "Close a connection that verbs have left open.",
            "virtual": "Be a controller without hardware.",
        },
    ),
    "job": (
        "Send a job and control it",
        {
            "send": "Send a program to a controller and wait until it is cut.",
            "hold": "Hold a job that runs, from any terminal.",
            "go": "Let a job go on that stands.",
            "stop": "End a job that runs.",
            "override": "Change feed, rapid, spindle or coolant of a job that runs.",
            "drive": "Another name of `send`.",
        },
    ),
    "recovery": (
        "Go on after an interruption",
        {
            "restart": "Go on with a program from a place in its middle: checked, written or sent.",
            "resume": "Say how far a job came that was killed, and how to restart it safely.",
            "back": "Go back along the cut of a held job, forward again, and go on.",
        },
    ),
}
OTHER_NAMES = {"drive": "send"}
FAMILY_OF = {verb: family for family, (_, verbs) in FAMILIES.items() for verb in verbs}


SHORT = {"check", "time", "convert", "edit", "compact", "trace"}  # mostly done before numba would be loaded


class _Verbs(click.Group):
    """Loads `CNCStepper.cli.FAMILY.VERB` when VERB is called, so that `--help` is quick."""

    def list_commands(self, context: click.Context) -> list[str]:
        return list(FAMILY_OF)

    def get_command(self, context: click.Context, name: str) -> click.Command | None:
        if name not in FAMILY_OF:
            return None
        os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # looking for them takes longer than a short verb
        if name in SHORT and "CNCStepper.kernels" not in sys.modules:
            kernel_cache.postponed = True
        module = OTHER_NAMES.get(name, name).replace("-", "_")
        return in_language(importlib.import_module(f"CNCStepper.cli.{FAMILY_OF[name]}.{module}").command)

    def invoke(self, context: click.Context) -> Any:
        """Run the verb; Ctrl+C ends it with the status that shells give a program which it has stopped."""
        try:
            return super().invoke(context)
        except click.ClickException as error:
            error.message = translated(error.message)  # type: ignore[misc]
            raise
        except KeyboardInterrupt:
            show_text("cncstepper: stopped by Ctrl+C before it was done", err=True)
            sys.exit(STOPPED)

    def format_commands(self, context: click.Context, formatter: click.HelpFormatter) -> None:
        for title, verbs in FAMILIES.values():
            with formatter.section(look_up(title)):
                formatter.write_dl([(verb, look_up(text)) for verb, text in verbs.items()])


@click.command(cls=_Verbs, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.version_option(__version__, prog_name="cncstepper")
def group() -> None:
    """From a drawing to a cut part on stepper-driven machines."""


def main() -> None:
    """Run the command line; a refusal is one sentence on standard error and exit status 1."""
    gc.set_threshold(YOUNG_OBJECTS)
    atexit.register(gc.freeze)  # Python looks for garbage once more when it ends: a sixth of the time of `run`
    choose_language()
    for stream in (sys.stdout, sys.stderr):  # a console that cannot show a character must not stop a cut
        stream.reconfigure(errors="replace")  # type: ignore[union-attr]
    try:
        in_language(group)(prog_name="cncstepper")
    except CNCStepperError as error:
        show_text("cncstepper: {error}", err=True, error=error)
        show_hints([error])
        sys.exit(1)
    except OSError as error:  # a folder that is not there, a disk that is full: the system's own words say it
        file = error.filename or look_up("a file")
        show_text("cncstepper: {file}: {error}", err=True, file=file, error=error.strerror or error)
        sys.exit(1)


if __name__ == "__main__":
    main()
