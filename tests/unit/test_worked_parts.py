# SPDX-License-Identifier: LGPL-2.1-or-later
"""The manual's worked parts: each goes from its file to a proven program, and its section says what that comes to."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from CNCStepper.quantities import duration_text
from helpers.tools import load

ROOT = Path(__file__).parents[2]
manual = load("manual")
worked_parts = load("worked_parts")
LABEL = re.compile(r"(?<!\*)\*([^*\n]+(?:\n[^*\n]+)?)\*")
FILE = re.compile(r"`(examples/[^`]+)`")
STEP = re.compile(r"^\d+\. ", re.MULTILINE)
LEAST_STEPS = 4
LESSONS = {  # the warnings of which the sections speak
    "sign": {"not-exact"},
    "plate": {"not-exact", "below-stock"},
    "lathe-shaft": {"operation-3"},
    "lathe-thread": {"operation-2", "operation-4"},
}


def sections(language: str) -> dict[str, str]:
    """Return the sections of the page by the names of the parts."""
    page = ROOT / "docs" / "manual" / manual.localized_name("worked-parts.md", language)
    _, *found = re.split(r"^## \d+\. ", page.read_text("utf-8"), flags=re.MULTILINE)
    return dict(zip(manual.PARTS, found, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize("name", manual.PARTS)
def test_a_worked_part_is_made_checked_and_takes_the_time_that_its_section_says(name: str) -> None:
    part = worked_parts.work(name)
    assert [finding for finding in part.findings if finding.severity == "error"] == []
    assert {finding.code for finding in part.findings if finding.severity == "warning"} == LESSONS.get(name, set())
    said = duration_text(part.time_s) if part.time_s >= 60 else f"{part.time_s:.0f} s"
    for language in manual.CATALOGUES:
        assert f": {said}" in sections(language)[name], language


@pytest.mark.parametrize("name", manual.PARTS)
@pytest.mark.parametrize("language", manual.CATALOGUES)
def test_a_section_has_its_picture_its_files_and_the_steps(name: str, language: str) -> None:
    text = sections(language)[name]
    picture = f"pictures/parts/{manual.localized_name(f'{name}.png', language)}"
    assert f"](../{picture})" in text and (ROOT / "docs" / picture).is_file()
    files = FILE.findall(text)
    assert f"examples/jobs/{name}.toml" in files
    assert [file for file in files if not (ROOT / file).is_file()] == []
    assert len(STEP.findall(text)) >= LEAST_STEPS


@pytest.mark.parametrize("language", manual.CATALOGUES)
def test_what_a_person_is_to_click_has_that_name_in_the_window(language: str) -> None:
    known = manual.translations.read(manual.translations.catalogue("_pt-BR"))
    labels = {text.source for text in known} if language == "en" else set(known.values())
    for name, text in sections(language).items():
        named = [" ".join(label.split()) for label in LABEL.findall(text)]
        assert [label for label in named if label not in labels] == [], name
        assert len(named) >= LEAST_STEPS, name


def test_the_words_of_a_picture_are_all_translated() -> None:
    """All but those that are the same in both languages."""
    assert set(worked_parts.TEXTS) - set(worked_parts.PORTUGUESE) == {"axis"}
    assert set(worked_parts.PORTUGUESE) <= set(worked_parts.TEXTS)
    for key, said in worked_parts.PORTUGUESE.items():
        assert sorted(re.findall(r"\{.*?\}", said)) == sorted(re.findall(r"\{.*?\}", worked_parts.TEXTS[key])), key
