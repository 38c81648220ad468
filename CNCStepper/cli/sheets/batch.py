# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper batch`: an order of many drawings, made, nested, proven and priced."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.language import look_up, show_text
from CNCStepper.cli.common.options import FilePath, NumberType
from CNCStepper.cli.common.path_types import OutputFolder
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.sheets.arrange import SizeType
from CNCStepper.errors import Text

if TYPE_CHECKING:
    from CNCStepper.job.batch.local_workers import Workers
    from CNCStepper.job.batch.run_batch import BatchResult

MOST_WORKERS = 256


def _names(params: Mapping[str, Any]) -> Mapping[str, str]:
    from CNCStepper.job.batch.batch_files import FILES

    return FILES


@click.command("batch", cls=Verb)
@click.argument("order", type=FilePath)
@click.option("-o", "--out", type=OutputFolder(_names), required=True, help="Folder for all files of the order.")
@click.option(
    "--workers",
    type=click.IntRange(1, MOST_WORKERS),
    default=max(os.cpu_count() or 1, 1),
    show_default="one a core",
    help="Processes on this computer.",
)
@click.option("--cluster", default="", help="A dask scheduler: tcp://127.0.0.1:8786 or tls://HOST:8786.")
@click.option("--tls-ca", type=FilePath, help="Certificate of the cluster's authority.")
@click.option("--tls-cert", type=FilePath, help="Our own certificate.")
@click.option("--tls-key", type=FilePath, help="Its key.")
@click.option("--sheet", type=SizeType, help="Of the sheets, mm. [default: the template's, or the machine's travel]")
@click.option(
    "--gap", "gap_mm", type=NumberType(above=-1e-9), help="Between the outlines of parts. [default: the margin]"
)
@click.option(
    "--turn",
    type=click.Choice(["none", "half", "quarter", "any"]),
    default="half",
    show_default=True,
    help="How parts may be turned.",
)
@click.option("--seeds", type=click.IntRange(1, 1000), default=2, show_default=True, help="Searches for each nest.")
@click.option("--attempts", type=click.IntRange(0, 100_000), default=4, show_default=True, help="Of each search.")
@click.option("--common-lines", is_flag=True, help="Cut facing edges of neighbours once; their gap is the kerf.")
@click.option("--title", default="", help="Of the offer. [default: the order's name]")
def command(
    order: Path,
    out: Path,
    workers: int,
    cluster: str,
    tls_ca: Path | None,
    tls_cert: Path | None,
    tls_key: Path | None,
    sheet: tuple[float, ...] | None,
    gap_mm: float | None,
    turn: str,
    seeds: int,
    attempts: int,
    common_lines: bool,
    title: str,
) -> None:
    """Make, nest, prove and price the drawings of ORDER, a CSV: drawing, template, material, thickness_mm, count.

    Parts of one template, material and thickness are nested on sheets. DIR gets each sheet's drawing, job file,
    program, report and certificate, remnants, the table of rows and sheets (rows.csv, sheets.csv, order.txt) and an
    offer (offer.pdf) by the rates of the machine's profile. A row that is refused costs no other one. Run it again
    after an interruption: what is done is not done again. Exit 1 when a row, a part or a sheet was not made.
    """
    from CNCStepper.job.batch.batch_files import write_tables
    from CNCStepper.job.batch.order_rows import read_rows
    from CNCStepper.job.batch.run_batch import NestOptions, run_batch

    if common_lines and gap_mm is not None:
        raise click.UsageError(Text("parts that share cuts lie the kerf apart: leave --gap or --common-lines out"))
    rows = read_rows(order)
    runs = _workers(workers, cluster, [key for key in (tls_ca, tls_cert, tls_key) if key])
    size_mm = (sheet[0], sheet[1]) if sheet else None
    out.mkdir(parents=True, exist_ok=True)
    with Progress(Text("reading {name}", name=order.name)) as progress, runs:

        def show(doing: str, share: float) -> None:
            progress.doing(doing)
            progress.share(share)

        result = run_batch(rows, out, runs, NestOptions(size_mm, gap_mm, turn, seeds, attempts, common_lines), show)
    for path in write_tables(result, out, title or order.stem, look_up):
        click.echo(f"{path}")
    _tell(result)
    sys.exit(0 if result.is_whole else 1)


def _workers(count: int, cluster: str, keys: list[Path]) -> Workers:
    if not cluster:
        from CNCStepper.job.batch.local_workers import LocalWorkers

        return LocalWorkers(count)
    from CNCStepper.job.batch.cluster_workers import ClusterWorkers

    return ClusterWorkers(cluster, keys)


def _tell(result: BatchResult) -> None:
    """Print what was refused, then the sums."""
    from CNCStepper.job.batch.order_costs import total_figures
    from CNCStepper.job.batch.order_tables import refusals

    for sentence in refusals(result):
        show_text("   {sentence}", err=True, sentence=sentence)
    total = total_figures(result)
    cost = "" if total.cost is None else f", {total.cost:.2f} {total.currency}".rstrip()
    show_text(
        "{parts} parts on {sheets:g} sheets, {metres:.1f} m, {pierces:.0f} pierces, {hours:.2f} h{cost}; "
        "{done} tasks done, {found} found done",
        parts=total.parts,
        sheets=total.sheets,
        metres=total.metres,
        pierces=total.pierces,
        hours=total.hours,
        cost=cost,
        done=result.done,
        found=result.found,
    )
