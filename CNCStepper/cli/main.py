# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `cncstepper`: one module a verb, imported only when that verb is called."""

from __future__ import annotations

import importlib
import sys

import click

from CNCStepper import __version__
from CNCStepper.errors import CNCStepperError

VERBS = {
    "run": "Make program, report, certificate and picture from a job file.",
    "check": "Check a program against a machine; exit 0 clean, 1 refused.",
    "time": "Print the seconds that a program takes.",
    "simulate": "Draw the part that a program cuts.",
    "trace": "Print the canonical calls of a program.",
    "send": "Send a program to a controller and wait until it is cut.",
    "virtual": "Be a controller without hardware.",
}


class _Verbs(click.Group):
    """Loads `CNCStepper.cli.VERB` when VERB is called, so that `--help` is quick."""

    def list_commands(self, context: click.Context) -> list[str]:
        return list(VERBS)

    def get_command(self, context: click.Context, name: str) -> click.Command | None:
        if name not in VERBS:
            return None
        module = importlib.import_module(f"CNCStepper.cli.{name}")
        return module.command

    def format_commands(self, context: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(VERBS.items()))


@click.command(cls=_Verbs, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.version_option(__version__, prog_name="cncstepper")
def group() -> None:
    """From a drawing to a cut part on stepper-driven machines."""


def main() -> None:
    """Run the command line; a refusal is one sentence on standard error and exit status 1."""
    for stream in (sys.stdout, sys.stderr):  # a console that cannot show a character must not stop a cut
        stream.reconfigure(errors="replace")  # type: ignore[union-attr]
    try:
        group(prog_name="cncstepper")
    except CNCStepperError as error:
        click.echo(f"cncstepper: {error}", err=True)
        sys.exit(1)
    except OSError as error:  # a folder that is not there, a disk that is full: the system's own words say it
        click.echo(f"cncstepper: {error.filename or 'a file'}: {error.strerror or error}", err=True)
        sys.exit(1)


if __name__ == "__main__":
    main()
