# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a machine's fields as Markdown, from the profile's model and the labels of its dialog."""

from __future__ import annotations

from collections.abc import Iterator

from CNCStepper.workbench.help.object_pages import CHOICES, KEY, PROFILE_TITLE, Translate, choice_words, escaped
from CNCStepper.workbench.machines.declaration import Row, key_of_row, rows, tables
from CNCStepper.workbench.machines.labels import GROUPS, HINTS, english_choice_label, english_label_of
from CNCStepper.workbench.services.translation import later

ABOUT = later(
    "Each field of the dialog *Machines…* is a key of the machine's profile; [the guide]({0}) shows them at work."
)
USUAL = later("usual value: {0}")
REQUIRED = later("must be given")
LISTED = later("Each entry of the list `{0}` has these values.")
GENERAL = later("General")
GROUP_TITLES = {
    "axis": later("Axes"),
    "planner": later("Ramps"),
    "spindle": later("Spindle and relays"),
    "outputs": later("Outputs"),
    "signals": later("Signals and pins"),
    "rates": later("Prices"),
    "retreat": later("Retract"),
    "input": later("Inputs"),
    "relay": later("Relays"),
}


def machine_page(tr: Translate, guide: str) -> str:
    """Return the page of all fields of a machine's profile; guide: the address of the guide to machines."""
    lines = [f"# {tr(PROFILE_TITLE)}", "", tr(ABOUT).format(guide), ""]
    shown, group = set[str](), ""
    for row in sorted(rows(), key=lambda row: len(row.path) > 1):  # what stands in no table first
        if key_of_row(row.path) in shown:
            continue
        shown.add(key_of_row(row.path))
        if group_of(row) != group:
            group = group_of(row)
            lines += [f"## {tr(group)}", ""]
        lines += row_lines(row, key_of_row(row.path), tr)
    for table in tables():
        lines += [f"## {tr(GROUP_TITLES[table.key])}", "", tr(LISTED).format(table.key), ""]
        for row in table.columns:
            lines += row_lines(row, f"{table.key}.{'.'.join(row.path)}", tr)
    return "\n".join(lines)


def group_of(row: Row) -> str:
    """Return the English title of the group of a row."""
    if len(row.path) == 1:
        return GENERAL
    return GROUPS.get(row.path[-2]) or GROUP_TITLES[row.path[0]]


def row_lines(row: Row, key: str, tr: Translate) -> Iterator[str]:
    """Yield the lines of a field: label, hint, choices, key with unit and usual value."""
    known = english_label_of(row.path)
    heading = tr(known) if known else row.path[-1].replace("_", " ")
    yield from (f"### {escaped(heading)}", "")
    if hint := HINTS.get(row.path[-1]):
        yield from (f"{escaped(tr(hint))}.", "")
    if row.choices:
        words = (choice_words(each, english_choice_label(row.path, each), tr) for each in row.choices)
        yield from (tr(CHOICES).format(", ".join(words)), "")
    facts = [f"{tr(KEY)}: `{key}`", *([row.unit] if row.unit else [])]
    if row.required:
        facts.append(tr(REQUIRED))
    elif row.default not in (None, "", ()):
        facts.append(tr(USUAL).format(f"`{row.default}`"))
    yield from ("; ".join(facts) + ".", "")
