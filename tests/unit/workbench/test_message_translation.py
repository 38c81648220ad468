# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core says is known to the catalogue, and said in Portuguese with the same values."""

from __future__ import annotations

import json
import re
import sys
import xml.etree.ElementTree as ET
from pathlib import Path
from types import SimpleNamespace

import pytest

from CNCStepper.control.session.status import error_from_json, error_to_json
from CNCStepper.control.stream.job_run import KEPT, LOST
from CNCStepper.controllers.lathe.board import ONE_WAY, SWITCH_ON_AGAIN
from CNCStepper.cycles.catalogue import CYCLES
from CNCStepper.cycles.turning.turning_operation import TURNING_OPERATIONS
from CNCStepper.drawing.selection import Selection
from CNCStepper.errors import JobError, Place, ProgramError, Text, joined
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.make import numbered
from CNCStepper.state import Start
from CNCStepper.workbench.restart.restart_places import title_of
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import CATALOGUE, FORMER, VALUE, translated

LIMIT = Text("at most {largest_tool}", largest_tool=3)
BAD = sorted((Path(__file__).parents[2] / "bad").glob("*.nc"))
PORTUGUESE = {
    (str(context.findtext("name")), str(message.findtext("source"))): str(message.findtext("translation"))
    for context in ET.parse(CATALOGUE.with_name("CNCStepper_pt-BR.ts")).getroot().iter("context")
    for message in context.iter("message")
}


@pytest.fixture(autouse=True)
def portuguese(monkeypatch: pytest.MonkeyPatch) -> None:
    """FreeCAD speaks Portuguese: what it answers is what the catalogue's source says."""
    speech = SimpleNamespace(translate=lambda context, text: PORTUGUESE.get((context, text), text))
    monkeypatch.setitem(sys.modules, "FreeCAD", SimpleNamespace(Qt=speech))


def refusal(path: Path) -> ProgramError:
    text = path.read_text("utf-8")
    body, expected = text[: text.rindex("; expect")], text.rpartition("; expect")[2].partition(" | ")[0].split()
    with pytest.raises(ProgramError) as caught:
        interpret(body, Start(), expected[2] if len(expected) > 2 else "grbl", path.name)
    return caught.value


@pytest.mark.parametrize("path", BAD, ids=lambda path: path.stem)
def test_every_refusal_is_said_in_portuguese(path: Path) -> None:
    error = refusal(path)
    assert translated(error.what) != error.what
    assert translated(error.sentence).startswith(translated(error.what))
    assert not error.value or error.value in translated(error.sentence)


def test_sentences_of_earlier_versions_have_a_present_one_with_the_same_values() -> None:
    former = json.loads(FORMER.read_text("utf-8"))
    known = {text for context, text in PORTUGUESE if context == "CNCStepper core"}
    assert set(former.values()) <= known and not former.keys() & known
    assert not [old for old, new in former.items() if sorted(VALUE.findall(old)) != sorted(VALUE.findall(new))]


def test_a_sentence_that_an_earlier_version_has_stored_is_translated() -> None:
    stored = "tool 7 does not stand in the tool table"
    assert translated(stored) == "a ferramenta 7 não está na tabela de ferramentas"
    template = Text("tool {tool} does not stand in the tool table", tool=7)
    assert translated(template) == translated(stored)


def test_the_limit_and_the_advice_are_translated_and_the_value_stays() -> None:
    error = ProgramError("x", "a scale must be above 0", value="at most 3", limit=LIMIT, advice="use X or Y")
    whole = "uma escala deve ser maior que 0 (valor at most 3, limite no máximo 3); use X ou Y"
    assert translated(error.sentence) == whole
    assert messages.sentence(error) == "uma escala deve ser maior que 0 (at most 3, limite no máximo 3)"


def test_a_value_that_is_a_text_is_translated() -> None:
    error = ProgramError("x", "a scale must be above 0", value=LIMIT)
    assert messages.sentence(error) == "uma escala deve ser maior que 0 (no máximo 3)"


def test_each_advice_is_translated() -> None:
    error = ProgramError(
        "x", "the comment is not closed", advice=joined("; ", ["close it with )", "take out R", "rs274 says no"])
    )
    assert translated(error.sentence) == "o comentário não está fechado; feche-o com ); retire R; rs274 says no"


def test_a_name_before_and_a_value_that_is_joined() -> None:
    english = "Part 1: the pattern cannot be read: a; b (value c)"
    assert translated(english) == "Part 1: o padrão de busca não pode ser lido: a; b (value c)"


def test_only_a_limit_is_said_too() -> None:
    error = ProgramError("x", "a scale must be above 0", limit=LIMIT)
    assert translated(error.sentence) == "uma escala deve ser maior que 0 (limite no máximo 3)"


def test_why_a_job_ended_and_how_its_machine_stands_are_both_translated() -> None:
    stopped = translated(
        Text("{why}. Now {state}", why=Text("stopped as asked after {acknowledged} lines", acknowledged=60), state=KEPT)
    )
    assert stopped.startswith("parado como pedido após 60 linhas. ") and stopped.endswith(translated(KEPT))
    assert translated(KEPT) != KEPT
    error = ProgramError("x", "a scale must be above 0", limit=LIMIT)
    failed = translated(Text("{why}. Now {state}", why=error.text, state=LOST))
    assert translated(error.sentence) in failed and failed.endswith(translated(LOST)) and translated(LOST) != LOST


def test_an_error_of_another_process_is_said_in_portuguese_with_its_values() -> None:
    error = JobError("x", Text("{key} is too long", key="slot"), limit=LIMIT, advice="take out R")
    again = error_from_json(json.loads(json.dumps(error_to_json(error))))
    assert translated(again.sentence) == "slot é longo demais (limite no máximo 3); retire R"
    assert translated(again.text) == f"{translated(again.sentence)} [x]"


def test_english_without_a_template_is_recognised() -> None:
    assert translated("slot is too long (limit at most 3); take out R") == (
        "slot é longo demais (limite no máximo 3); retire R"
    )


MESSAGES_OF_OUR_CONTROLLERS = (
    "the lathe cannot be stopped over its link: it runs on for 3.1 s, to X12.500 Z-40.000",
    f"the lathe is in automatic mode and cannot be jogged: {SWITCH_ON_AGAIN}",
    f"the zero of the lathe can be set in manual mode only: {SWITCH_ON_AGAIN}",
    "switch the lathe on in manual mode before it moves; its position is reckoned, nothing reports it",
    "the tool is not at the work zero, where a program begins: jog it there, or set the zero here",
    "nothing more is sent to the lathe: its program has ended with M02",
    "nothing more is sent to the lathe: a record was refused: reset first",
    "the lathe jogs at up to 118 mm/min, or at 450: it takes the slower one",
    "Trial 25000 pulses/s late mean 3.1 us worst 20.5 us",
    "there is no relay OXYGEN; there are FLOOD, MIST",
    "there are no relays",
    ONE_WAY,
)


@pytest.mark.parametrize("text", MESSAGES_OF_OUR_CONTROLLERS)
def test_the_messages_of_our_controllers_are_said_in_portuguese(text: str) -> None:
    """They come as lines of grbl's, [MSG:…], without their templates."""
    said = translated(text)
    english = [" the ", " is ", " it ", "there", "pulses", " late ", " none"]
    assert said != text and not [word for word in english if word in f" {said} "], said
    assert re.findall(r"\d+(?:\.\d+)?", text) == re.findall(r"\d+(?:\.\d+)?", said)


@pytest.mark.parametrize(
    ("place", "said"),
    [
        (Place(numbered(2, "elliptical_pocket")), "operação 2 (bolsão elíptico)"),
        (Place("operation 3 (turn face)"), "operação 3 (facear no torno)"),
        (Place(Text("row {number}", number=4)), "linha 4"),
        (Place(Text("profile '{name}'", name="pocket")), "perfil 'pocket'"),
        (Place("pocket.nc", 5), "pocket.nc:5"),
    ],
)
def test_the_place_of_an_error_is_said_in_portuguese(place: Place, said: str) -> None:
    assert messages.sentence(JobError("x", "it rests", place=place)) == f"{said}: it rests"


def test_the_place_before_a_sentence_that_a_document_has_stored_is_said_in_portuguese() -> None:
    assert translated("operation 1 (drill): take out R") == "operação 1 (furar): retire R"
    assert translated("drill: take out R") == "drill: retire R", "an object that somebody called so keeps its name"


@pytest.mark.parametrize("cycle", [*CYCLES, *TURNING_OPERATIONS])
def test_every_operation_has_a_name_in_portuguese(cycle: str) -> None:
    name = cycle.replace("_", " ")
    assert numbered(7, cycle) == f"operation 7 ({name})"
    assert translated(numbered(7, cycle)).startswith("operação 7 (") and f"({name})" not in translated(
        numbered(7, cycle)
    )
    assert title_of(name) not in (name, "")
    assert title_of("slot") == "slot", "an operation of another program"


def test_what_a_selection_of_a_drawing_takes_is_said_in_portuguese() -> None:
    words = Selection(layer=("yes", "cut*"), closed=True, filled=False).words
    assert words == "layer 'yes' or 'cut*', closed yes, filled no"
    assert translated(words) == "layer 'yes' ou 'cut*', closed sim, filled não"
    assert translated(Selection().words) != Selection().words == "all of it"
