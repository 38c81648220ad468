# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line in the language of the locale: help, refusals, headings, and the words of click.

Python's gettext chooses the language by LANGUAGE, LC_ALL, LC_MESSAGES and LANG; on Windows the language of its user
interface counts where none of these is set. CNCSTEPPER_LANGUAGE (pt, en) comes before all. `make translations` derives
the catalogue in CNCStepper/locale from the window's. What a program reads is English in every locale: JSON, programs,
codes, the options themselves.
"""

from __future__ import annotations

import copy
import gettext
import inspect
import os
import sys
from pathlib import Path

import click

from CNCStepper.errors import Text

DOMAIN = "cncstepper"
FOLDER = Path(__file__).parents[2] / "locale"
OVERRIDE = "CNCSTEPPER_LANGUAGE"
OF_LOCALE = ("LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG")  # in the order in which gettext reads them
LINES_KEPT = "\b\n"  # begins a paragraph that click does not wrap


def choose_language() -> None:
    """Give click's own words the language of this process, before it prints any."""
    if chosen := _chosen():
        os.environ["LANGUAGE"] = chosen
    gettext.bindtextdomain(DOMAIN, str(FOLDER))
    gettext.textdomain(DOMAIN)


def _chosen() -> str:
    """Return the language that comes before those of the locale, "" for none."""
    return os.environ.get(OVERRIDE) or _language_of_windows()


def _language_of_windows() -> str:
    """Return the language of Windows' user interface, "" elsewhere and where a variable names one."""
    if sys.platform != "win32" or any(map(os.environ.get, OF_LOCALE)):
        return ""
    import ctypes
    import locale

    return locale.windows_locale.get(ctypes.windll.kernel32.GetUserDefaultUILanguage(), "")


def is_english() -> bool:
    """Return whether the catalogues have nothing for the language of this process."""
    return gettext.find(DOMAIN, str(FOLDER), _languages()) is None


def look_up(text: str) -> str:
    """Return a text in the language of this process, as it is where the catalogue does not hold it."""
    return gettext.translation(DOMAIN, str(FOLDER), _languages(), fallback=True).gettext(text) if text else text


def _languages() -> list[str] | None:
    """Return the chosen language, None where the locale's count."""
    return [chosen] if (chosen := _chosen()) else None


def translated(text: str) -> str:
    """Return a sentence of ours, with its values where it is a `Text`, in the language of this process."""
    return text.translated(look_up) if isinstance(text, Text) else look_up(text)


def show_text(template: str, /, err: bool = False, **values: object) -> None:
    """Print a sentence of ours, a `Text` or its template and values, in the language of this process."""
    click.echo(translated(Text(template, **values) if values else template), err=err)


def catalogued(text: str) -> list[str]:
    """Return the paragraphs of a help text as the catalogue holds them: on one line, unless click keeps the lines."""
    return [part.removeprefix(LINES_KEPT) for part in _paragraphs(text)]


def _paragraphs(text: str) -> list[str]:
    parts = inspect.cleandoc(text).split("\n\n")
    return [part if part.startswith(LINES_KEPT) else " ".join(part.split()) for part in parts]


def in_language(command: click.Command) -> click.Command:
    """Return a command whose help is in the language of this process; the command itself stays as it is."""
    if is_english():
        return command
    shown = copy.copy(command)
    shown.help, shown.short_help = _translated_help(command.help), _translated_help(command.short_help)
    shown.params = [_parameter(param) for param in command.params]
    if isinstance(shown, click.Group):
        shown.commands = {name: in_language(each) for name, each in shown.commands.items()}
    return shown


def _parameter(param: click.Parameter) -> click.Parameter:
    text = getattr(param, "help", None)
    if text is None:
        return param
    shown = copy.copy(param)
    shown.help = _translated_help(text)  # type: ignore[attr-defined]
    return shown


def _translated_help(text: str | None) -> str | None:
    return text and "\n\n".join(map(_translated_paragraph, _paragraphs(text)))


def _translated_paragraph(part: str) -> str:
    if part.startswith(LINES_KEPT):
        return LINES_KEPT + look_up(part.removeprefix(LINES_KEPT))
    return look_up(part)
