# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper simulate`: the part that a program cuts, as a picture and as figures."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.options import (
    dialect_name,
    dialect_option,
    machine_option,
    program_argument,
    read_program,
    stock_of,
    stock_options,
)
from CNCStepper.cli.show import show_findings, write_json
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.tool import Tool


@click.command("simulate")
@program_argument
@stock_options(required=True)
@click.option("--out", type=click.Path(dir_okay=False, path_type=Path), required=True, help="The picture, PNG.")
@click.option("--json", "json_path", type=click.Path(path_type=Path), help="Also write the report there.")
@machine_option(required=False)
@dialect_option
def command(
    program: Path,
    stock: tuple[float, float, float],
    origin: str,
    tool: Tool,
    out: Path,
    json_path: Path | None,
    machine: Machine | None,
    dialect: str | None,
) -> None:
    """Draw what PROGRAM leaves of a block of stock, from above and in space; times are table-a's unless told."""
    from CNCStepper.job.prove import prove

    proof = prove(
        read_program(program),
        machine or load_machine("table-a"),
        file=str(program),
        dialect=dialect_name(dialect, machine),
        stock=stock_of(stock, origin),
        tools=tool,
    )
    out.parent.mkdir(parents=True, exist_ok=True)
    proof.draw(out, program.stem, tool.words)
    if json_path:
        write_json(json_path, proof.report)
    show_findings(proof.findings)
    click.echo(f"{out}: {proof.report['removed_volume_mm3'] / 1000:.1f} cm³ removed in {proof.report['time_s']:.1f} s")
