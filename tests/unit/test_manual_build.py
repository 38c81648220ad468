# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sphinx makes HTML of the manual's pages without a warning, as `make manual` does before it prints the PDF."""

from __future__ import annotations

from pathlib import Path

import pytest

from helpers.tools import load

manual = load("manual")


@pytest.fixture(scope="module")
def refusals() -> dict:
    return manual.refusal_codes.refusals()


@pytest.mark.slow
@pytest.mark.parametrize("language", manual.CATALOGUES)
def test_sphinx_builds_every_page_of_a_language_without_a_warning(
    language: str, refusals: dict, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert manual.ENVIRONMENT.is_dir(), "make setup installs Sphinx"
    monkeypatch.setattr(manual, "BUILD", tmp_path)
    pages = manual.pages(language, refusals)
    source = manual.write_sources(language, pages)
    manual.run_sphinx(language, source, "html", tmp_path / "html")
    assert [path for path in pages if not (tmp_path / "html" / path).with_suffix(".html").is_file()] == []
    assert len(list((tmp_path / "html" / "_images").iterdir())) == len(manual.pictures(pages)) > 60
