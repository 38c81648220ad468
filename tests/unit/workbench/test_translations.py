# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text that a person sees is in the catalogues, translated, and goes through tr(); nothing else is in them."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from helpers.tools import load

ROOT = Path(__file__).parents[3]


tool = load("translations")
PUT_TOGETHER = re.compile(r"\{\d+\}")  # as refusal_codes writes the values of an f-string
PORTUGUESE = tool.read(tool.catalogue("_pt-BR"))


@pytest.fixture(scope="module")
def shown() -> dict:
    """The texts of the whole source, with their places; to find them takes some seconds."""
    return tool.texts()


@pytest.mark.slow
def test_every_shown_text_goes_through_tr() -> None:
    assert tool.faults() == []


@pytest.mark.slow
@pytest.mark.parametrize("suffix", tool.LANGUAGES)
def test_the_catalogues_hold_what_the_source_shows(suffix: str, shown: dict) -> None:
    held, wanted = set(tool.read(tool.catalogue(suffix))), shown
    missing = [f"{wanted[text]}: {text}" for text in sorted(set(wanted) - held)]
    assert missing == [], "run 'make translations', then translate what it brought in"
    assert sorted(held - set(wanted)) == [], "nothing shows these any more: run 'make translations'"


@pytest.mark.slow
def test_no_refusal_is_put_together_before_it_is_translated() -> None:
    """Its template is what the catalogues hold."""
    refusals = tool.beside("refusal_codes").refusals().values()
    sayings = {part for refusal in refusals for saying in refusal.sayings for part in saying}
    assert len(sayings) > 1500
    assert [saying for saying in sayings if PUT_TOGETHER.search(saying)] == []


def test_no_refusal_adds_texts_together() -> None:
    """Such a sum has no template: joined() and Text() keep one for each part."""
    tree = {path: ast.parse(path.read_text("utf-8")) for path in (ROOT / "CNCStepper").rglob("*.py")}
    sums = [
        f"{path.relative_to(ROOT)}:{part.lineno}"
        for path, module in tree.items()
        for call in ast.walk(module)
        if isinstance(call, ast.Call) and tool.called(call).endswith(("Error", "Refusal"))
        for part in [*call.args[1:2], *(word.value for word in call.keywords if word.arg == "advice")]
        if isinstance(part, ast.BinOp) and isinstance(part.op, ast.Add)
    ]
    assert sums == []


def test_every_text_is_translated() -> None:
    assert [text for text, translation in PORTUGUESE.items() if not translation] == []


def test_places_for_values_are_the_same() -> None:
    def places(text: str) -> list[str]:
        return sorted(re.findall(r"\{[^}]*\}", text))

    assert [(t.source, p) for t, p in PORTUGUESE.items() if places(t.source) != places(p)] == []


def test_ends_and_blanks_are_the_same() -> None:
    def end(text: str) -> str:
        return text[-1:] if text.endswith((".", "…", ":")) else ""

    def blanks(text: str) -> tuple[str, str]:
        return text[: len(text) - len(text.lstrip())], text[len(text.rstrip()) :]

    differ = [t.source for t, p in PORTUGUESE.items() if (end(t.source), blanks(t.source)) != (end(p), blanks(p))]
    assert differ == []


def test_the_compiled_catalogue_is_younger_than_its_texts() -> None:
    """Qt answers for its content inside FreeCAD; here only that somebody compiled it at all."""
    compiled = tool.catalogue("_pt-BR").with_suffix(".qm").read_bytes()
    assert compiled.startswith(bytes.fromhex("3cb86418caef9c95cd211cbf60a1bddd"))


@pytest.mark.parametrize(
    ("source", "fault"),
    [
        ('tr(f"{name} is wrong")', "give it the text itself"),
        ('tr("a" + b)', "give it the text itself"),
        ('tr("{0} mm".format(depth))', "give it the text itself"),
        ('later(f"{name}")', "marks only texts"),
        ('label.setText("Depth")', "'Depth' without tr()"),
        ('label.setText(f"Depth {depth}")', "'Depth' without tr()"),
        ('QtGui.QLabel("Depth", parent)', "'Depth' without tr()"),
        ('combo.addItems(["Climb", tr("Conventional")])', "'Climb' without tr()"),
        ('label.setText("Depth" if deep else tr("Height"))', "'Depth' without tr()"),
        ('button = QPushButton(text="Send")', "'Send' without tr()"),
    ],
)
def test_faults_are_found(source: str, fault: str) -> None:
    ((_, found),) = tool.faults_of(source)
    assert fault in found


@pytest.mark.parametrize(
    "source",
    [
        'tr("{0} mm").format(depth)',
        "tr(entry.label)",
        "tr(why_not or does)",
        'label.setText(tr("Depth"))',
        'label.setText(f"{x:.3f} mm")',
        'label.setObjectName("CNCStepper_Dock_state")',
        'box.setWindowTitle("CNCStepper")',
        'label.setText("<b>–</b>")',
    ],
)
def test_what_is_right_is_no_fault(source: str) -> None:
    assert list(tool.faults_of(source)) == []


def test_texts_are_found_with_their_context() -> None:
    source = """
later("Work zero"); tr("To " "the end"); QT_TRANSLATE_NOOP("CNCStepper_Send", "Send")
Property("stock_size_mm", "StockSize", POSITION, STOCK, later("Size"), later("Length"))
"""
    found = {(text.context, text.source) for text, _ in tool.texts_of(source, in_features=True)}
    assert found == {
        ("CNCStepper", "Work zero"),
        ("App::Property", "Work zero"),
        ("CNCStepper", "To the end"),
        ("CNCStepper_Send", "Send"),
        ("App::Property", "Stock Size"),
        *((context, text) for context in ("CNCStepper", "App::Property") for text in ("Size", "Length")),
    }


def test_an_update_keeps_translations_and_takes_over_those_of_other_contexts(tmp_path: Path) -> None:
    known = {tool.Text("CNCStepper", "Depth"): "Profundidade", tool.Text("CNCStepper", "Old"): "Velho"}
    wanted = {tool.Text("CNCStepper", "Depth"): "", tool.Text("App::Property", "Depth"): "", tool.Text("X", "New"): ""}
    merged = tool.merged(wanted, known)
    assert merged == {
        tool.Text("App::Property", "Depth"): "Profundidade",
        tool.Text("CNCStepper", "Depth"): "Profundidade",
        tool.Text("X", "New"): "",
    }
    tool.write(tmp_path / "x.ts", "pt_BR", merged)
    assert tool.read(tmp_path / "x.ts") == merged
    assert 'type="unfinished"' in (tmp_path / "x.ts").read_text("utf-8")
