# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences of the core in FreeCAD's language.

A sentence with values is a `Text`. The catalogue holds its template (see tools/translations.py), which is translated
and formatted with the same values.

English without its template is recognised: a sentence that a document has stored, or the comment of a program. The
sentences of earlier versions are in former_sentences.json, each with the one that replaced it.
"""

from __future__ import annotations

import functools
import json
import re
import xml.etree.ElementTree as ET

from CNCStepper.errors import Text
from CNCStepper.workbench import packages

CONTEXT = "CNCStepper core"
CATALOGUE = packages.ROOT / "resources" / "translations" / "CNCStepper.ts"
FORMER = CATALOGUE.with_name("former_sentences.json")
VALUE = re.compile(r"\{(\w+)[^{}]*\}")
NOW = ". Now "  # as `control/stream/job_run.py` says how the machine stands behind why the job has ended
# as CNCStepperError.sentence puts it together: what (value …, limit …); advice [code]
WHOLE = re.compile(
    r"(?P<what>.+?)(?: \((?P<numbers>(?:value|limit) .+?)\))?(?:; (?P<advice>.+?))?(?P<code> \[[\w-]+\])?"
)
JOINT = re.compile(r"; | \((?:value|limit) ")


def translated(text: str) -> str:
    """Return a sentence of the core, or a whole error as one text, in FreeCAD's language.

    Values that are texts are translated too. What the catalogue does not know stays English, and so do names.
    """
    if isinstance(text, Text):
        return text.translated(_look_up)
    return _outcome(text) or _said(text) or text


def template(english: str) -> str:
    """Return a template of the core in FreeCAD's language, its fields as they are."""
    return _look_up(english)


def make_ready() -> None:
    """Read the catalogue now, in whatever thread, so that the first sentence need not wait for it."""
    _catalogue()


def _said(english: str) -> str:
    return _known(english) or _put_together(english) or _after_a_name(english) or _known(english, strict=False)


def _outcome(english: str) -> str:
    """Return why a job has ended and how its machine stands, each translated; "" where not both are said."""
    from CNCStepper.workbench.services.translation import tr

    why, now, stands = english.partition(NOW)
    return tr("{0}. Now {1}").format(_said(why) or why, _known(stands) or stands) if now else ""


def _known(english: str, strict: bool = True) -> str:
    """Return the translation of a sentence that the catalogue holds, else ""; `strict`: its values are no sentences."""
    sentence, values = _recognised(english, strict)
    if not values:
        return _look_up(sentence) if sentence else ""
    translations = dict(zip(VALUE.findall(sentence), (_known(value) or value for value in values), strict=True))
    return VALUE.sub(lambda field: translations[field[1]], _look_up(sentence))


@functools.lru_cache(maxsize=1000)  # a list of refused operations says the same at each change
def _recognised(english: str, strict: bool) -> tuple[str, list[str]]:
    """Return the catalogue's sentence and the values in it, "" and none where it has no such sentence."""
    plain, with_values = _catalogue()
    if english in plain:
        return english, []
    for pieces, sentence in with_values:
        if (values := _values(pieces, english)) and not (strict and _joins(pieces, values)):
            return sentence, values
    return "", []


def _joins(pieces: list[str], values: list[str]) -> bool:
    """Whether values hold what stands before or behind a sentence, as a short one takes all: "{0} has no {1}"."""
    return any(map(JOINT.search, values)) or (not pieces[0] and ": " in values[0])


def _put_together(english: str) -> str:
    """Return an error's sentence, numbers and advice, each translated; "" where its sentence is not known."""
    parts = WHOLE.fullmatch(english)
    what = _known(parts["what"]) if parts and parts["what"] != english else ""
    if not parts or not what:
        return ""
    numbers = f" ({_numbers(parts['numbers'])})" if parts["numbers"] else ""
    advice = f"; {_advice(parts['advice'])}" if parts["advice"] else ""
    return f"{what}{numbers}{advice}{parts['code'] or ''}"


def _after_a_name(english: str) -> str:
    """Return the translation of "Pocket: the tool is wider than the pocket", where an object's name stands first.

    What stands first may be a place of the core, "operation 1 (pocket)"; a name without values is a person's own.
    """
    name, colon, rest = english.partition(": ")
    said = _said(rest) if colon else ""
    _, values = _recognised(name, strict=True) if said else ("", [])
    return f"{_known(name) if values else name}: {said}" if said else ""


def _advice(english: str) -> str:
    """Return the translation of one advice, or of several with "; " between them, as far as they are known."""
    return _known(english) or "; ".join(_known(part) or part for part in english.split("; "))


def _numbers(english: str) -> str:
    """Return "value X60, limit at most 50 mm", or one of the two, translated as far as they are known."""
    from CNCStepper.workbench.services.translation import tr

    value, _, limit = f", {english}".partition(", limit ")
    value = value.removeprefix(", value ")
    said = [tr("value {0}").format(_known(value) or value)] if value else []
    return ", ".join([*said, tr("limit {0}").format(_known(limit) or limit)] if limit else said)


def _look_up(sentence: str) -> str:
    import FreeCAD

    return str(FreeCAD.Qt.translate(CONTEXT, _former().get(sentence, sentence)))


@functools.cache
def _former() -> dict[str, str]:
    """Return the sentences of earlier versions, each with the present one, which has the same values."""
    return json.loads(FORMER.read_text("utf-8"))


def _values(pieces: list[str], english: str) -> list[str]:
    """Return what stands between the pieces of a sentence, [] where it is another one; no value is empty."""
    if not (english.startswith(pieces[0]) and english.endswith(pieces[-1])):
        return []
    at, values = len(pieces[0]), []
    for piece in pieces[1:-1]:
        end = english.find(piece, at + 1)
        values.append(english[at:end])
        at = end + len(piece)
        if end < 0:
            return []
    end = len(english) - len(pieces[-1])
    return [*values, english[at:end]] if at < end else []


def load_catalogue() -> None:
    """Read the catalogue's sentences, in any thread: the first message that is translated would wait for it."""
    _catalogue()


@functools.cache
def _catalogue() -> tuple[frozenset[str], list[tuple[list[str], str]]]:
    """Return the sentences without values, and those with values and their pieces, the most telling first."""
    contexts = ET.parse(CATALOGUE).getroot().iter("context")
    core = (context for context in contexts if context.findtext("name") == CONTEXT)
    sentences = [str(message.findtext("source")) for context in core for message in context.iter("message")]
    sentences += _former()
    with_values = sorted((sentence for sentence in sentences if VALUE.search(sentence)), key=lambda one: -len(one))
    return frozenset(sentences) - frozenset(with_values), [(VALUE.split(one)[::2], one) for one in with_values]
