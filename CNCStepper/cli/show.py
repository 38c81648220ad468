# SPDX-License-Identifier: LGPL-2.1-or-later
"""How findings and reports leave the command line."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import click

from CNCStepper.simulation.finding import Finding


def show_findings(findings: Iterable[Finding]) -> None:
    """Print each finding as file:line:column: text."""
    for finding in findings:
        click.echo(str(finding))


def write_json(path: Path, report: dict[str, Any]) -> None:
    """Write a report as strict JSON."""
    path.write_text(json.dumps(report, indent=2, allow_nan=False) + "\n", encoding="utf-8")
