# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws how processor time grows with the work, both on logarithmic scales, beside a straight line of the same work."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import matplotlib

PICTURES = Path(__file__).parents[1] / "docs" / "pictures" / "growth"


def draw_growth(name: str, work: str, sizes: Sequence[int], series_s: Mapping[str, Sequence[float]]) -> None:
    """Write docs/pictures/growth/NAME.png: seconds of processor over the amount of work, a line for each series.

    The dashed line of each goes through its last point and grows as the work does.
    """
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(5.0, 3.4), dpi=100, layout="constrained")
    for label, spent_s in series_s.items():
        (line,) = axes.loglog(sizes, spent_s, "o-", label=label)
        straight_s = [spent_s[-1] * size / sizes[-1] for size in sizes]
        axes.loglog(sizes, straight_s, "--", color=line.get_color(), linewidth=0.8)
    axes.set_ylim(bottom=min(min(spent_s) for spent_s in series_s.values()) / 2)
    axes.set(xlabel=work, ylabel="processor time, s")
    axes.grid(visible=True, which="major", linewidth=0.3)
    axes.legend()
    PICTURES.mkdir(parents=True, exist_ok=True)
    figure.savefig(PICTURES / f"{name}.png")
    pyplot.close(figure)
