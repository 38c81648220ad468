# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files in the folder of an order.

job-G-N.toml, .nc, -report.json, -certificate.zip    sheet N of group G, from 1: job, program, report, certificate
sheet-G-N.dxf, remnant-G-N-M.dxf                     its drawing, and what is left of it
placements-G.json, nest-G.png                        where the parts of the group lie
rows.csv, sheets.csv, order.txt, offer.pdf           the tables, and the offer
journal.jsonl                                        what is done
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from CNCStepper.atomic_file import write_whole
from CNCStepper.job.batch.offer import save_offer
from CNCStepper.job.batch.order_tables import HEAD, SHEET_HEAD, csv_bytes, row_table, sheet_table, text_table
from CNCStepper.job.batch.run_batch import BatchResult

PROGRAM_NAME = r"job-\d+-\d+(-\d+-T\d+)?"
FILES = {  # names that are written, and what they are by output_files.py
    r"job-\d+-\d+\.toml": "job",
    rf"{PROGRAM_NAME}\.nc": "program",
    rf"{PROGRAM_NAME}-report\.json": "report",
    rf"{PROGRAM_NAME}-certificate\.zip": "certificate",
    r"sheet-\d+-\d+\.dxf": "drawing",
    r"remnant-\d+-\d+-\d+\.dxf": "drawing",
    r"placements-\d+\.json": "placements",
    r"nest-\d+\.png": "picture",
    r"(rows|sheets)\.csv": "order table",
    r"order\.txt": "order text",
    r"offer\.pdf": "sheet",
    r"journal\.jsonl": "batch journal",
}


def write_tables(result: BatchResult, folder: Path, title: str, look_up: Callable[[str], str] = str) -> list[Path]:
    """Write the tables and the offer of an order; return their paths. look_up: as of `save_offer`."""
    names = ("rows.csv", "sheets.csv", "order.txt", "offer.pdf")
    rows, sheets, text, offer = paths = [folder / name for name in names]
    write_whole(rows, csv_bytes(HEAD, row_table(result)))
    write_whole(sheets, csv_bytes(SHEET_HEAD, sheet_table(result)))
    write_whole(text, text_table(result, title).encode("utf-8"))
    save_offer(offer, result, title, look_up)
    return paths
