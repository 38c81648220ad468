# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt reads the compiled catalogue as its source says, and draws every icon so that it can be told from its ground."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide import QtCore, QtGui, QtSvg

import CNCStepper

RESOURCES = Path(CNCStepper.__file__).parents[1] / "resources"
PORTUGUESE = RESOURCES / "translations" / "CNCStepper_pt-BR.ts"
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
