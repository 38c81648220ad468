# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt reads the compiled catalogue as its source says, and draws every icon so that it can be told from its ground."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide import QtCore, QtGui, QtSvg

import CNCStepper
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.services.message_translation import CONTEXT, translated

RESOURCES = Path(CNCStepper.__file__).parents[1] / "resources"
PORTUGUESE = RESOURCES / "translations" / "CNCStepper_pt-BR.ts"
FIELD = re.compile(r"\{[^{}]*\}")
LIGHT, DARK = (240, 240, 240), (43, 43, 43)


def messages() -> Iterator[tuple[str, str, str]]:
    """Yield context, English and Portuguese of the catalogue's source."""
    for context in ET.parse(PORTUGUESE).getroot().iter("context"):
        for message in context.iter("message"):
            english, portuguese = message.findtext("source"), message.findtext("translation")
            yield str(context.findtext("name")), str(english), str(portuguese)


def test_qt_answers_what_the_catalogue_says() -> None:
    translator = QtCore.QTranslator()
    assert translator.load(str(PORTUGUESE.with_suffix(".qm")))
    wrong = [
        (context, english, translator.translate(context, english))
        for context, english, portuguese in messages()
        if translator.translate(context, english) != portuguese
    ]
    assert wrong == [], "run 'make translations', which compiles the catalogue"
    assert translator.translate("CNCStepper", "No such text") in ("", None)


@pytest.mark.parametrize("size", [16, 24])
@pytest.mark.parametrize("path", sorted((RESOURCES / "icons").glob("*.svg")), ids=lambda path: path.stem)
def test_an_icon_reads_on_light_and_on_dark(path: Path, size: int) -> None:
    picture = QtSvg.QSvgRenderer(str(path))
    assert picture.isValid()
    for ground in (LIGHT, DARK):
        image = QtGui.QImage(size, size, QtGui.QImage.Format.Format_RGB32)
        image.fill(QtGui.QColor(*ground))
        painter = QtGui.QPainter(image)
        picture.render(painter)
        painter.end()
        pixels = [QtGui.QColor(image.pixel(x, y)).getRgb()[:3] for x in range(size) for y in range(size)]
        far = sum(max(abs(a - b) for a, b in zip(pixel, ground, strict=True)) > 60 for pixel in pixels)
        assert far > 0.12 * size * size


@pytest.fixture
def portuguese() -> Iterator[None]:
    """Qt speaks Portuguese of Brazil as it does in FreeCAD's window."""
    application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
    translator = QtCore.QTranslator()
    assert translator.load(str(PORTUGUESE.with_suffix(".qm")))
    application.installTranslator(translator)
    yield
    application.removeTranslator(translator)


@pytest.mark.parametrize(
    ("english", "said"),
    [
        ("the tool is wider than the pocket", "a ferramenta é mais larga que o bolsão"),
        ("there is no port COM3", "não há porta COM3"),
        ("the tool goes into clamp 2", "a ferramenta bate no grampo 2"),
        (
            "the flat 6 mm tool cuts deeper than its flutes are long",
            "a ferramenta flat 6 mm corta mais fundo que o seu comprimento de corte",
        ),
        (
            "Bolsão 2: the tool is wider than the pocket (value 60 mm, limit below 50 mm); choose a smaller tool [x-y]",
            "Bolsão 2: a ferramenta é mais larga que o bolsão (valor 60 mm, limite abaixo de 50 mm);"
            " escolha uma ferramenta menor [x-y]",
        ),
        (
            "the controller refused 'G1X': a number is missing or cannot be read (error:2)",
            "o controlador recusou 'G1X': um número falta ou não pode ser lido (error:2)",
        ),
        (
            JobError("x-y", Text("{key} is too long", key="Passo"), place=Place("a.toml", 3), advice="take out R").text,
            "a.toml:3: Passo é longo demais; retire R [x-y]",
        ),
        ("what no catalogue knows: 12 mm", "what no catalogue knows: 12 mm"),
        ("", ""),
    ],
)
def test_what_the_core_says_is_said_in_portuguese(portuguese: None, english: str, said: str) -> None:
    assert translated(english) == said


def test_a_real_refusal_is_said_in_portuguese(portuguese: None, document: Any) -> None:
    job = api.new_job(document)
    cutter = api.add_tool(job, diameter_mm=60)
    pocket = api.add_elliptical_pocket(job, tool=cutter)
    document.recompute()
    assert "wider than the pocket" in problem_of(pocket)
    assert "mais larga que o bolsão" in translated(problem_of(pocket))
    assert "mais larga que o bolsão" in translated(problem_of(job))


def test_in_english_every_sentence_stays_as_it_was() -> None:
    for context, english, _ in messages():
        if context == CONTEXT:
            with_values = FIELD.sub("X1.5", english)
            assert translated(with_values) == with_values
