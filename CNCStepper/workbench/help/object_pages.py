# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages that follow from the code, as Markdown: the fields of an object, and the codes of the controllers.

FreeCAD's window shows them with its own translation, `make manual` writes them in every language. A field's paragraph
ends with its key in a job file: by that F1 finds it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator

from CNCStepper.control.protocol.grbl.firmware import FIRMWARES, Firmware
from CNCStepper.workbench.features.base import BOOL, POINTS, POSITION, TEXT, Property
from CNCStepper.workbench.help.topics import (
    CODES,
    GUIDE_PAGES,
    OBJECT_TOPICS,
    PROFILE,
    REFUSALS,
    ObjectTopic,
    object_address,
)
from CNCStepper.workbench.services.choice_labels import english_words_of
from CNCStepper.workbench.services.translation import later

Translate = Callable[[str], str]
UNITS = {
    "_mm_min": "mm/min",
    "_mm_rev": "mm/rev",
    "_m_min": "m/min",
    "_mm": "mm",
    "_deg": "°",
    "_rpm": "rpm",
    "_percent": "%",
    "_s": "s",
}
SIGNS = re.compile(r"([|<*_`\[\]])")  # in which Markdown reads more than a letter
KEY, NEW, UNIT = later("key"), later("value in a new object"), later("unit")
COUNTS = later("counts where {0} is {1}")
RESULT = later("result: shown, not typed")
CHOICES = later("Choices: {0}.")
GUIDE = later("At work: [{0}]({1}).")
YES, NO, EMPTY = later("yes"), later("no"), later("empty")
HELP, GUIDES_TITLE, FIELDS_TITLE = later("Help"), later("Guides"), later("Panels and their fields")
PROFILE_TITLE = later("Fields of a machine")
CODES_TITLE = later("Alarms and errors of controllers")
REFUSALS_TITLE = later("What to do when …")
CODES_ABOUT = later("What a number of a controller means, and what to do. F1 works in every panel: it opens its page.")
ALARMS_OF, ERRORS_OF = later("{0}: alarms"), later("{0}: errors")
NUMBER, MEANING, TO_DO = later("Number"), later("Meaning"), later("What to do")


def object_page(topic: ObjectTopic, entries: Iterable[Property], tr: Translate, picture: str, guide: str) -> str:
    """Return the page of an object: title, picture, link to its guide, then its fields by group.

    picture, guide: their addresses as a page has them; "" for no picture.
    """
    shown = [entry for entry in entries if entry.group]
    title = tr(topic.title)
    named = next(tr(page.title) for page in GUIDE_PAGES if page.file == topic.guide)
    lines = [f"# {title}", "", *([f"![{title}]({picture})", ""] if picture else []), tr(GUIDE).format(named, guide), ""]
    labels = {entry.key: entry for entry in shown}
    for group in dict.fromkeys(entry.group for entry in shown):
        lines += [f"## {tr(group)}", ""]
        for entry in shown:
            if entry.group == group:
                lines += field_lines(entry, labels, tr)
    return "\n".join(lines)


def field_lines(entry: Property, others: dict[str, Property], tr: Translate) -> Iterator[str]:
    """Yield the lines of a field: label, explanation, choices, and its key with unit and usual value."""
    explained = escaped(tr(entry.text))
    yield from (f"### {escaped(tr(entry.label))}", "", explained + "." * (not explained.endswith(".")), "")
    if entry.choices:
        words = (choice_words(each, english_words_of(each, entry.key), tr) for each in entry.choices)
        yield from (tr(CHOICES).format(", ".join(words)), "")
    facts = [f"{tr(KEY)}: `{entry.key}`"]
    unit = next((words for suffix, words in UNITS.items() if entry.key.endswith(suffix)), "")
    facts += [f"{tr(UNIT)}: {unit}"] if unit else []
    facts += [tr(RESULT)] if entry.output else [f"{tr(NEW)}: {default_words(entry, tr)}"]
    if entry.only and entry.only[0] in others:
        chooser = others[entry.only[0]]
        values = ", ".join(f"`{value}`" for value in entry.only[1])
        facts.append(tr(COUNTS).format(f"*{escaped(tr(chooser.label))}*", values))
    yield from ("; ".join(facts) + ".", "")


def choice_words(choice: str, known: str, tr: Translate) -> str:
    """Return a choice as a job file has it, with the words that the panel shows; known: these in English, or ""."""
    words = f" ({escaped(tr(known))})" if known else ""
    return f"`{choice}`{words}" if choice else f'`""`{words}'


def default_words(entry: Property, tr: Translate) -> str:
    """Return the value of a new object in words."""
    default = entry.default
    if entry.type == BOOL:
        return tr(YES if default else NO)
    if default in (None, "", ()) or (entry.type in (TEXT, POINTS) and not default):
        return tr(EMPTY)
    if entry.type in (POSITION, POINTS):
        return f"`{list(default)}`"
    return f"`{default:g}`" if isinstance(default, int | float) else f"`{default}`"


def contents_page(tr: Translate, above: str = "") -> str:
    """Return the contents of the help; above: Markdown below the title."""
    lines = [f"# {tr(HELP)}", "", *([above, ""] if above else []), f"## {tr(GUIDES_TITLE)}", ""]
    lines += [f"- [{tr(guide.title)}]({guide.file})" for guide in GUIDE_PAGES]
    lines.append(f"- [{tr(REFUSALS_TITLE)}]({REFUSALS})")
    lines += [f"- [{tr(CODES_TITLE)}]({CODES})", "", f"## {tr(FIELDS_TITLE)}", ""]
    lines += [f"- [{tr(topic.title)}]({object_address(topic.type)})" for topic in OBJECT_TOPICS]
    lines.append(f"- [{tr(PROFILE_TITLE)}]({PROFILE})")
    return "\n".join([*lines, ""])


def codes_page(tr: Translate, core: Translate) -> str:
    """Return the page of the alarms and errors of every firmware; core: translates a sentence of the core."""
    lines = [f"# {tr(CODES_TITLE)}", "", tr(CODES_ABOUT), ""]
    for firmware in FIRMWARES:
        lines += firmware_lines(firmware, tr, core)
    return "\n".join(lines)


def firmware_lines(firmware: Firmware, tr: Translate, core: Translate) -> Iterator[str]:
    """Yield the two tables of a firmware; a controller reports the numbers as ALARM:n and error:n."""
    for heading, word, codes in ((ALARMS_OF, "ALARM", firmware.alarms), (ERRORS_OF, "error", firmware.errors)):
        yield from (f"## {tr(heading).format(firmware.name)}", "")
        yield from (f"| {tr(NUMBER)} | {tr(MEANING)} | {tr(TO_DO)} |", "|---|---|---|")
        for number, code in sorted(codes.items()):
            yield f"| {word}:{number} | {escaped(core(code.meaning))} | {escaped(core(code.advice))} |"
        yield ""


def escaped(text: str) -> str:
    """Return a text in which Markdown reads nothing but letters."""
    return SIGNS.sub(r"\\\1", text)
