# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper nest`: parts of an order on sheets, remnants or a strip."""

from __future__ import annotations

import signal
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import FilePath, NumberType
from CNCStepper.cli.common.path_types import OutputFolder
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text

if TYPE_CHECKING:
    from CNCStepper.job.nesting.order_file import Order
    from CNCStepper.job.nesting.shared_cuts import Saving
    from CNCStepper.nesting.nesting_model import Budget, Layout


def _names(params: Mapping[str, Any]) -> Mapping[str, str]:
    from CNCStepper.job.nesting.nest_files import FILES

    return FILES


@click.command("nest", cls=Verb)
@click.argument("order", type=FilePath)
@click.option(
    "--time", "time_s", type=NumberType(kind="time"), default=60.0, show_default=True, help="Seconds to search."
)
@click.option("-o", "--out", type=OutputFolder(_names), required=True, help="Folder for drawings, placements, picture.")
@click.option("--seed", type=click.IntRange(0, 2**31 - 1), default=1, show_default=True, help="Of the random search.")
@click.option("--common-lines", is_flag=True, help="Cut facing edges of neighbours once; the order's gap must be 0.")
@click.option("--no-spyrrow", is_flag=True, help="Search by our own layer alone.")
def command(order: Path, time_s: float, out: Path, seed: int, common_lines: bool, no_spyrrow: bool) -> None:
    """Place the parts of ORDER on its sheets: a TOML order, or the JSON of a strip packing instance.

    DIR/sheet-N.dxf, DIR/remnant-N-M.dxf, DIR/placements.json and DIR/nest.png are written. Ctrl+C ends the search with
    the best layout so far. The last line is the density: the parts' area by that of the sheets used. Exit 1 when parts
    have no place; each is told with the reason.
    """
    from CNCStepper.job.nesting.nest_files import density_of, write_nest
    from CNCStepper.job.nesting.order_file import read_order, with_common_lines
    from CNCStepper.job.nesting.shared_cuts import saving_of, shared_cuts
    from CNCStepper.job.nesting.strip_process import strip_packer
    from CNCStepper.nesting.nest import nest
    from CNCStepper.nesting.nesting_model import Budget

    read = with_common_lines(read_order(order)) if common_lines else read_order(order)
    parts = sum(item.count + len(item.locked) for item in read.items)
    with Progress(Text("nesting")) as progress:
        budget = Budget(time_s, progress=progress.share)
        packer = None if no_spyrrow else strip_packer()
        if packer is None and not no_spyrrow:
            show_text(
                "   note: spyrrow is not installed; our own search alone is slower: pip install spyrrow", err=True
            )
        with _stopped_by_ctrl_c(budget):
            show_text(
                "nesting {parts} parts for {time_s:g} s; Ctrl+C ends it with the best so far",
                err=True,
                parts=parts,
                time_s=time_s,
            )
            layout = nest(read.items, read.sheets, read.spacing, budget, packer, seed, read.common_lines)
    shared = shared_cuts(read, layout)
    for path in write_nest(read, layout, out, shared):
        click.echo(f"{path}")
    _tell(read, layout)
    if shared:
        _tell_saving(saving_of(shared))
    show_text("density {density:.3f}", density=density_of(read, layout))
    sys.exit(1 if layout.unplaced else 0)


@contextmanager
def _stopped_by_ctrl_c(budget: Budget) -> Iterator[None]:
    """Let Ctrl+C end the search, and a second one the command."""
    before = signal.getsignal(signal.SIGINT)

    def stop(number: int, frame: object) -> None:
        budget.stop()
        signal.signal(signal.SIGINT, before)

    signal.signal(signal.SIGINT, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _tell_saving(saving: Saving) -> None:
    for note in saving.notes:
        show_text("   note: {note}", err=True, note=note)
    show_text(saving.sentence)


def _tell(order: Order, layout: Layout) -> None:
    for unplaced in layout.unplaced:
        name = order.items[unplaced.item].name
        show_text(
            "   not placed: {count} of {name}: {why}", err=True, count=unplaced.count, name=name, why=unplaced.why
        )
    used = Text("{used} sheets of {given}", used=len(layout.sheets), given=len(order.sheets))
    kind = Text("a strip") if order.strip_height_mm else used
    show_text("{placements} parts on {kind}", placements=len(layout.placements), kind=kind)
