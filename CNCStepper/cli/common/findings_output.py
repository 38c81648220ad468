# SPDX-License-Identifier: LGPL-2.1-or-later
"""How findings and reports leave the command line."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.errors import Text
from CNCStepper.simulation.finding import Finding

REPORT = "CNCStepper report"  # by which `output_files` knows it


def show_findings(findings: Iterable[Finding]) -> None:
    """Print each finding as file:line:column: text."""
    for finding in findings:
        show_text(finding.line)


def show_figures(report: dict[str, Any]) -> None:
    """Print a program's figures: lengths, pierces, removed volume, and each operation's time."""
    volume_mm3 = report["removed_volume_mm3"]
    removed = "" if volume_mm3 is None else Text(", {volume:.3g} cm³ removed", volume=volume_mm3 / 1000)
    show_text(
        "cut {cut:.1f} mm, in air {air:.1f} mm, rapid {rapid:.1f} mm, pierces {pierces}{removed}",
        cut=report["cut_length_mm"], air=report["air_length_mm"], rapid=report["rapid_length_mm"],
        pierces=report["pierces"], removed=removed,
    )  # fmt: skip
    for operation in report["operations"]:
        told = ", ".join(f"{name} {value:.4g}" for name, value in operation.get("figures", {}).items())
        click.echo(f"{operation['name']}: {operation['time_s']:.1f} s" + (f", {told}" if told else ""))


def write_report(path: Path, report: dict[str, Any]) -> None:
    """Write a report as strict JSON."""
    text = json.dumps({"format": REPORT} | report, indent=2, allow_nan=False) + "\n"
    save(path, text.encode("utf-8"))


def save(path: Path, data: bytes) -> None:
    """Write a file whole or not at all, its folder too where there is none."""
    from CNCStepper.atomic_file import write_whole

    path.parent.mkdir(parents=True, exist_ok=True)
    write_whole(path, data)
