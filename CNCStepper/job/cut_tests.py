# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs that measure values of a cut chart: a kerf test and speed tests, as text of job files.

kerf test      a square of side S with a square hole of S / 2:   kerf = kerf used + (S - part + hole - S / 2) / 2
(a wire)       a square of side S, entered from the edge:        kerf = kerf used + S - part
speed test     a small square at each feed, side by side; run them in their order and look at the edges
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import process_named

SLOWEST, FASTEST = 0.7, 1.3  # of the chart's feed, in a speed test
SQUARE_MM = 25.0  # of a speed test
ROOM_MM = 15.0  # around the parts, for leads and pierces, besides the chart's own lengths


def kerf_test(row: CutData, machine: str, side_mm: float = 80.0) -> str:
    """Return the job file of a kerf test; raises JobError where the process takes nothing away, or no part is left."""
    is_wire = _power(row) == "always"
    least_mm = 4 * (row.kerf_mm + row.lead_in_mm)
    if side_mm < least_mm:
        raise JobError(
            "test-small",
            "the kerf test is too small for its kerf and leads",
            value=f"{side_mm:g} mm",
            limit=Text("at least {least:g} mm", least=least_mm),
            advice="make its side longer",
        )
    room_mm = ROOM_MM + row.lead_in_mm
    far_mm, quarter_mm = room_mm + side_mm, side_mm / 4
    shapes = [_square("outside", room_mm, room_mm, side_mm)]
    if not is_wire:
        shapes.append(_square("inside", room_mm + quarter_mm, room_mm + quarter_mm, side_mm / 2))
    measure = "kerf = kerf used + S - part" if is_wire else "kerf = kerf used + (S - part + hole - S / 2) / 2"
    title = f"Kerf test: S = {side_mm:g} mm, kerf used {row.kerf_mm:g} mm. {measure}"
    return _job(title, row, machine, (far_mm + room_mm, far_mm + room_mm), shapes)


def speed_test(row: CutData, machine: str, count: int, path: Path) -> Iterator[tuple[Path, str, float]]:
    """Yield path, text and feed of each job of a speed test, the feeds rising from 70 to 130 % of the chart's."""
    _power(row)
    room_mm = ROOM_MM + row.lead_in_mm
    pitch_mm = SQUARE_MM + room_mm
    for number in range(count):
        feed = row.feed_mm_min * (SLOWEST + (FASTEST - SLOWEST) * number / (count - 1))
        feed_mm_min = round(feed, 1)
        square = _square(f"square {number + 1}", room_mm + number * pitch_mm, room_mm, SQUARE_MM)
        size_mm = (room_mm + count * pitch_mm, 2 * room_mm + SQUARE_MM)
        title = f"Speed test {number + 1} of {count}: {feed_mm_min:g} mm/min, {100 * feed / row.feed_mm_min:.0f} %"
        text = _job(title, row, machine, size_mm, [square], f"\n[[tool]]\nnumber = 1\nfeed_mm_min = {feed_mm_min}\n")
        yield path.with_name(f"{path.stem}-{number + 1}{path.suffix}"), text, feed_mm_min


def _power(row: CutData) -> str:
    """Return when the process has power; raises JobError for one that takes nothing away."""
    power = process_named(row.process).power
    if power == "none":
        raise JobError(
            "test-process",
            Text("{process} has no kerf and no power to test", process=row.process),
            advice="test a torch, a laser, a jet or a wire",
        )
    return power


def _square(name: str, x_mm: float, y_mm: float, side_mm: float) -> tuple[str, str]:
    corners = f"corner_a = [{x_mm:g}, {y_mm:g}], corner_b = [{x_mm + side_mm:g}, {y_mm + side_mm:g}]"
    return name, f'[[shape]]\nname = "{name}"\nrectangle_mm = {{ {corners} }}\n'


def _job(
    title: str,
    row: CutData,
    machine: str,
    size_mm: tuple[float, float],
    shapes: list[tuple[str, str]],
    tools: str = "",
) -> str:
    cycle = "wire_cut" if _power(row) == "always" else "sheet_cut"
    names = ", ".join(f'"{name}"' for name, _ in shapes)
    consumable = f'consumable = "{row.consumable}"\n' if row.consumable else ""
    head = f'machine = "{machine}"\nprocess = "{row.process}"\nmaterial = "{row.material}"\n{consumable}'
    stock = (
        f'form = "sheet"\nsize_mm = [{size_mm[0]:g}, {size_mm[1]:g}, {row.thickness_mm:g}]\norigin = "top-left-front"'
    )
    return (
        f"# {title}\n{head}clearance_mm = 10\nretract_mm = 2\n\n[stock]\n{stock}\n{tools}\n"
        + "\n".join(text for _, text in shapes)
        + f'\n[[operation]]\ncycle = "{cycle}"\ncurves = [{names}]\n'
    )
