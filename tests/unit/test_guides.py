# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guides have the same parts in both languages, and call buttons, set in italics, by the labels of the window."""

from __future__ import annotations

import re
from collections import defaultdict
from pathlib import Path

import pytest

from helpers.tools import load

ROOT = Path(__file__).parents[2]
translations, manual = load("translations"), load("manual")
ITALICS = re.compile(r"(?<![*\w])\*(?![*\s])([^*\n]+(?:\n[^*\n]+)?)(?<!\s)\*(?![*\w])")
PARTS = (r"^#+ ", r"^\s*\|", r"^```", r"^\s*(?:-|\d+\.) ", r"^!\[", r"\n\s*\n")  # the last: paragraphs
CODE = re.compile(r"`[^`\n]*`")
PAGES = [
    page.relative_to(ROOT / "docs").as_posix()
    for folder in ("user-guide", "reference", "manual")
    for page in sorted((ROOT / "docs" / folder).rglob("*.md"))
    if page.with_name(f"{page.stem}.pt-BR.md").is_file()
]
NO_LABELS = {  # labels of FreeCAD, keys, names, words that are only stressed
    *("preferences", "cncstepper", "machinability", "part compound", "macro recording", "test", "cncstepper → lathe"),
    *("page up", "page down", "tab", "space", "…, outline"),
    *("spyrrow", "dask.distributed", "ae", "t2 v-bit 6 mm 60°", "before", "do", "and", "zero"),
    *("on the path at line 44", "off the path of these lines"),
    *("exact", "stopped, known", "unknown", "excursion declared", "damaged unnoticed", "complete"),
    *("refused", "nothing twice beyond the overlap", "no move outside the allowed region"),
}


def plain(label: str) -> str:
    """Return a label without its shortcut, its dots, its line break and its capitals."""
    return " ".join(label.replace("&", "").split()).rstrip("….: ").lower()


def labels(text: str) -> set[str]:
    """Return what a page sets in italics, links aside."""
    words = CODE.sub("", manual.CODE_BLOCK.sub("", text))
    return {plain(label) for label in ITALICS.findall(words) if "](" not in label}


@pytest.fixture(scope="module")
def portuguese() -> dict[str, set[str]]:
    """The labels of the window by their English."""
    found: dict[str, set[str]] = defaultdict(set)
    for text, translation in translations.read(translations.catalogue("_pt-BR")).items():
        found[plain(text.source)].add(plain(translation))
    return found


def without_twin(english: str, other: str, portuguese: dict[str, set[str]]) -> list[str]:
    """Return the labels of a page of which the other page lacks the Portuguese, and the other way round."""
    here, there = labels(english) - NO_LABELS, labels(other)
    lacks = [label for label in here if label in portuguese and not portuguese[label] & there]
    known = {word for label in here for word in portuguese.get(label, ())}
    shown = {word for words in portuguese.values() for word in words}
    stressed = {word for label in NO_LABELS for word in portuguese.get(label, ())} | {"antes"}
    return sorted([*lacks, *((there & shown) - known - stressed)])


@pytest.mark.parametrize("page", [page for page in PAGES if page != "reference/job-file.md"])
def test_both_languages_have_the_same_parts(page: str) -> None:
    """Half of the job file's page is written from the code when the manual is made."""
    english = ROOT / "docs" / page
    texts = [path.read_text("utf-8") for path in (english, english.with_name(f"{english.stem}.pt-BR.md"))]
    for part in PARTS:
        assert len({len(re.findall(part, text.strip(), re.MULTILINE)) for text in texts}) == 1, part


@pytest.mark.parametrize("page", PAGES)
def test_labels_are_those_of_the_window(page: str, portuguese: dict[str, set[str]]) -> None:
    english = (ROOT / "docs" / page).read_text("utf-8")
    assert sorted(labels(english) - set(portuguese) - NO_LABELS) == []


@pytest.mark.parametrize("page", PAGES)
def test_both_languages_name_the_same_labels(page: str, portuguese: dict[str, set[str]]) -> None:
    path = ROOT / "docs" / page
    other = path.with_name(f"{path.stem}.pt-BR.md")
    assert without_twin(path.read_text("utf-8"), other.read_text("utf-8"), portuguese) == []


@pytest.mark.parametrize(
    ("english", "other", "found"),
    [
        ("*Add selected*, *Tab*", "*Usar\nseleção*", []),
        ("*Add selected*", "*Adicionar seleção*", ["add selected"]),
        ("*Add selected*", "*Usar seleção*, *Recarregar*", ["recarregar"]),
        ("*Add selected*", "`*Usar seleção*`", ["add selected"]),
    ],
)
def test_a_wrong_label_is_found(english: str, other: str, found: list[str], portuguese: dict[str, set[str]]) -> None:
    assert without_twin(english, other, portuguese) == found
