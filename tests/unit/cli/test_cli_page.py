# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reference of the command line is what the commands declare."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import click
import pytest

from CNCStepper.cli.main import FAMILY_OF
from CNCStepper.cli.program.check import command as check
from helpers.tools import load

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "reference" / "cli.md"


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    return load("reference")


def test_the_page_is_what_the_commands_declare(tool: ModuleType) -> None:
    assert tool.cli_page() == PAGE.read_text("utf-8"), "run 'python tools/reference.py'"


def test_every_command_has_its_section() -> None:
    text = PAGE.read_text("utf-8")
    assert len(FAMILY_OF) > 20
    assert not [verb for verb in FAMILY_OF if f"### `cncstepper {verb}`\n" not in text]


def test_a_new_option_changes_the_page(tool: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    new = click.Option(["--planted"], type=click.IntRange(2, 5), default=3, show_default=True, help="Planted | so.")
    monkeypatch.setattr(check, "params", [*check.params, new])
    page = tool.cli_page()
    assert "| `--planted` | integer from 2 to 5 | Planted \\| so. [default: 3] |\n" in page
    assert page != PAGE.read_text("utf-8")


def test_signs_of_markdown_are_escaped(tool: ModuleType) -> None:
    assert tool.escaped("a|b <c> *d*") == "a\\|b \\<c> \\*d\\*"
    assert tool.paragraph("\b\n  one\n  two") == "```\n  one\n  two\n```\n"
