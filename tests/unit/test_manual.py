# SPDX-License-Identifier: LGPL-2.1-or-later
"""The manual has what the code has in both languages: fields, keys, commands, options, refusals; links are whole."""

from __future__ import annotations

import ast
import os
import re
import textwrap
from pathlib import Path

import click
import pytest

from CNCStepper.cli.main import FAMILY_OF, OTHER_NAMES, group
from CNCStepper.control.protocol.grbl.firmware import FIRMWARES
from CNCStepper.cycles.catalogue import CYCLES, cycle_class
from CNCStepper.workbench.features.base import Feature
from CNCStepper.workbench.help.feature_classes import CLASSES
from CNCStepper.workbench.help.object_tables import properties_of_type
from CNCStepper.workbench.help.topics import (
    CODES,
    GUIDE_PAGES,
    OBJECT_TOPICS,
    REFUSALS,
    TOPIC_OF,
    cycle_picture,
    refusals_page,
    slug,
)
from CNCStepper.workbench.machines.declaration import key_of_row, rows, tables
from helpers.tools import TOOLS, load

ROOT = Path(__file__).parents[2]
manual = load("manual")
RAISED = re.compile(r'\b(?:[A-Z]\w*Error|MachineRefusal)\(\s*"([a-z0-9]+(?:-[a-z0-9]+)*)"')
OF_CONTROLLERS = re.compile(r"(grbl|grblhal|fluidnc|parport|board|lathe)-(error|alarm)-\d+|machine-\w+")
WITHOUT_PANEL = {"CNCStepper_Preview"}  # the program's picture in the tree


@pytest.fixture(scope="module")
def refusals() -> dict:
    """What the source refuses; to read it takes some seconds."""
    return manual.refusal_codes.refusals()


@pytest.fixture(scope="module")
def pages(refusals: dict) -> dict[str, dict[str, str]]:
    return {language: manual.pages(language, refusals) for language in manual.CATALOGUES}


@pytest.mark.slow
def test_both_languages_have_the_same_pages(pages: dict) -> None:
    assert set(pages["en"]) == set(pages["pt_BR"])
    assert len(pages["en"]) > 60
    assert pages["en"]["objects/CNCStepper_Pocket.md"] != pages["pt_BR"]["objects/CNCStepper_Pocket.md"]
    assert "# Bolsão" in pages["pt_BR"]["objects/CNCStepper_Pocket.md"]


@pytest.mark.slow
@pytest.mark.parametrize("language", manual.CATALOGUES)
def test_every_field_of_every_panel_occurs(pages: dict, language: str) -> None:
    kinds = {kind.Type for kind in _below(Feature) if kind.Type.startswith("CNCStepper_")} - WITHOUT_PANEL
    assert kinds == {kind.Type for kind in CLASSES} == set(TOPIC_OF)
    for topic in OBJECT_TOPICS:
        text = pages[language][f"objects/{topic.type}.md"]
        missing = [each.key for each in properties_of_type(topic.type) if each.group and f"`{each.key}`" not in text]
        assert not missing, topic.type
    profile = pages[language]["machine-profile.md"]
    keys = [key_of_row(row.path) for row in rows()]
    keys += [f"{table.key}.{'.'.join(row.path)}" for table in tables() for row in table.columns]
    assert [key for key in keys if f"`{key}`" not in profile] == []


@pytest.mark.slow
@pytest.mark.parametrize("language", manual.CATALOGUES)
def test_every_command_option_and_key_occurs(pages: dict, language: str) -> None:
    text = pages[language]["reference/cli.md"]
    context = click.Context(group, info_name="cncstepper")
    for verb in FAMILY_OF:
        assert f"`cncstepper {verb}`" in text
        command = group.get_command(context, verb)
        assert command is not None
        options = [
            name for each in command.params if isinstance(each, click.Option) and not each.hidden for name in each.opts
        ]
        assert verb in OTHER_NAMES or [name for name in options if f"`{name}`" not in text] == []
    keys = pages[language]["reference/job-file.md"]
    for name in CYCLES:
        assert f"`{name}`" in keys
        fields = cycle_class(name).model_fields
        assert [key for key in fields if f"`{key}" not in keys] == ["cycle"], name  # the heading names it
    names = {name for name, _, _ in manual.commands()}
    assert len(names) > 40
    assert [name for name in names if f"`{name}`" not in pages[language]["commands.md"]] == []


@pytest.mark.slow
@pytest.mark.parametrize("language", manual.CATALOGUES)
def test_every_refusal_occurs_with_what_to_do(pages: dict, language: str) -> None:
    """The codes of the source are found here by their pattern, and those that tests expect by theirs."""
    headings = set(re.findall(r"^### ([\w-]+)$", pages[language]["manual/refusals.md"], re.MULTILINE))
    raised = {code for path in (ROOT / "CNCStepper").rglob("*.py") for code in RAISED.findall(path.read_text("utf-8"))}
    assert len(raised) > 500
    assert raised - headings == set()
    codes = pages[language]["controller-codes.md"]
    for firmware in FIRMWARES:
        assert all(f"| ALARM:{number} |" in codes for number in firmware.alarms)
        assert all(f"| error:{number} |" in codes for number in firmware.errors)


@pytest.mark.slow
def test_codes_that_tests_expect_occur(refusals: dict) -> None:
    expected = {
        code
        for path in (ROOT / "tests" / "unit").rglob("*.py")
        for code in re.findall(r'\.code == "([\w-]+)"', path.read_text("utf-8"))
    }
    assert len(expected) > 50
    assert [code for code in expected - set(refusals) if not OF_CONTROLLERS.fullmatch(code)] == []


@pytest.mark.slow
@pytest.mark.parametrize("language", manual.CATALOGUES)
def test_links_and_pictures_are_whole(pages: dict, language: str) -> None:
    found = pages[language]
    broken = []
    for path, text in found.items():
        for words, target in manual.LINK.findall(manual.CODE_BLOCK.sub("", text)):
            file, _, heading = target.partition("#")
            page = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
            if "://" not in target and (page not in found or (heading and heading not in manual.headings(found[page]))):
                broken.append((path, words, target))
    assert broken == []
    pictures = manual.pictures(found)
    assert len(pictures) > 40
    assert [name for name in pictures if not (ROOT / "docs" / name).is_file()] == []


@pytest.mark.slow
def test_pages_in_portuguese_show_portuguese_windows_and_parts(pages: dict) -> None:
    """Every picture with words of its own: those of the window, of the worked parts and of the cycles."""
    with_words = re.compile(r"pictures/((?:road-|parts/|cycles/)[\w-]+)\.png")
    shown = {path: with_words.findall(text) for path, text in pages["en"].items()}
    assert sum(map(len, shown.values())) > 6
    for path, names in shown.items():
        there = [f"pictures/{name}.pt-BR.png" for name in names]
        assert [name for name in there if not (ROOT / "docs" / name).is_file()] == []
        localized = {manual.localized(picture, "pt_BR") for picture in manual.pictures({path: pages["pt_BR"][path]})}
        assert set(there) <= localized, path


@pytest.mark.slow
def test_the_reference_is_portuguese_and_has_the_same_parts(pages: dict) -> None:
    """Headings, rows of tables and blocks of code are as many, so that neither language lacks one."""
    for name in manual.REFERENCES:
        english, portuguese = (pages[language][f"reference/{name}.md"] for language in ("en", "pt_BR"))
        assert manual.NOT_TRANSLATED not in portuguese, name
        for part in (r"^#+ ", r"^\s*\|", r"^```", r"^\s*(?:-|\d+\.) "):
            counts = [len(re.findall(part, text, re.MULTILINE)) for text in (english, portuguese)]
            assert counts[0] == counts[1], (name, part)
        sentences = [line for line in english.split("\n") if re.match(r"[A-Z][a-z]+ \w+ ", line)]
        same = set(sentences) & set(portuguese.split("\n"))
        assert same == set(), name
    assert "[padrão: 0.5]" in pages["pt_BR"]["reference/cli.md"]
    assert "0.001 a 10000 mm, ou 0" in pages["pt_BR"]["reference/job-file.md"]


def test_a_link_out_of_the_manual_becomes_words_and_code_stays() -> None:
    pages = {"a.md": "# One\n", "b/c.md": "# Two `x`\n"}
    text = "[one](../a.md#one) [none](../a.md#none) [gone](../x.py) [web](https://x.y)\n```\n[code](nowhere)\n```\n"
    whole = manual.whole_links("b/c.md", text, pages)
    assert whole == "[one](../a.md#one) [none](../a.md) gone [web](https://x.y)\n```\n[code](nowhere)\n```\n"
    assert manual.headings(pages["b/c.md"]) == {slug("Two x")}


@pytest.mark.parametrize(("language", "begin"), [("en", "# What to do when"), ("pt_BR", "# O que fazer quando")])
def test_the_help_of_the_window_leads_to_the_refusals(language: str, begin: str) -> None:
    assert f"]({REFUSALS})" in manual.object_pages.contents_page(str)
    page = refusals_page(language)
    assert page.startswith(begin) and re.findall(r"\]\(([^)]*)\)", page) == [CODES]


@pytest.mark.parametrize(
    ("language", "file"), [("en", "pocket.png"), ("pt_BR", "pocket.pt-BR.png"), ("de", "pocket.png")]
)
def test_the_help_of_the_window_shows_the_picture_of_its_language(language: str, file: str) -> None:
    assert cycle_picture("pocket", language) == file
    assert cycle_picture("none-of-that-name", language) == "none-of-that-name.png"


def test_every_guide_is_in_the_contents() -> None:
    folder = ROOT / "docs" / "user-guide"
    there = {
        path.relative_to(folder).as_posix() for path in folder.rglob("*.md") if not path.name.endswith(".pt-BR.md")
    }
    assert there == {guide.file for guide in GUIDE_PAGES}


def test_a_code_that_a_function_hands_on_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source = """
WHERE = "correct the line"
def refuse(code, what):
    raise JobError(code, what, advice=WHERE)
def check(name):
    what = Text("{name} is wrong", name=name)
    refuse("a-code", what)
    raise JobError(f"{name}-fault", "it broke")
"""
    (tmp_path / "module.py").write_text(source, "utf-8")
    codes = manual.refusal_codes
    monkeypatch.setattr(codes, "ROOT", tmp_path)
    reader = codes.Reader([codes.source_of(tmp_path / "module.py")], {"JobError"})
    (found,) = reader.read().values()
    assert (found.code, list(found.sayings)) == ("a-code", [("{name} is wrong", "correct the line")])
    assert reader.put_together == {"…-fault"}


@pytest.mark.parametrize(
    ("source", "sayings"),
    [
        ('what = "one"\nif a:\n raise E(what)\nwhat = "two"\nraise E(what, "do")', [["one"], ["two"]]),
        ('if a:\n what = "one"\n raise E(what)\nif b:\n what = "two"\n raise E(what, "do")', [["one"], ["two"]]),
        ('what = "one"\nif a:\n what = "two"\nraise E(what)', [["two", "one"]]),
        ('what = "one"\nwhat = what\nraise E(what)', [["what", "one"]]),
        ('try:\n what = "one"\nexcept E:\n raise E(what)', [["one"]]),
    ],
)
def test_a_refusal_says_what_its_name_is_given_last(source: str, sayings: list[list[str]]) -> None:
    function = ast.parse("def check():\n" + textwrap.indent(source, " ")).body[0]
    calls = [node for node in ast.walk(function) if isinstance(node, ast.Call)]
    calls.sort(key=lambda call: call.lineno)
    found = [manual.refusal_codes.assigned(function, "what", call) for call in calls]
    assert [[ast.unparse(value).strip("'") for value in values] for values in found] == sayings


def test_the_set_up_installs_pinned_versions() -> None:
    pins = (ROOT / "docs" / "manual" / "requirements.txt").read_text("utf-8").splitlines()
    named = dict(line.split("==") for line in pins if line and not line.startswith("#"))
    assert {"sphinx", "myst-parser", "weasyprint"} <= set(named)
    assert "docs/manual/requirements.txt" in (TOOLS / "setup.sh").read_text("utf-8")


def _below(kind: type) -> set[type]:
    return {each for below in kind.__subclasses__() for each in {below, *_below(below)}}
