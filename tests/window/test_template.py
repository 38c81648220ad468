# SPDX-License-Identifier: LGPL-2.1-or-later
"""A template of the shop by real clicks, in both languages: rules changed, saved, and made into a job."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import Part
import pytest
from PySide import QtGui

from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of, proxy_type, values
from window_helpers import screen_places as places
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand
from window_helpers.tables import put, rows_by_buttons
from window_helpers.task_panels import PANEL as FIELD
from window_helpers.task_panels import accept, begin
from window_helpers.x_input import RIGHT

ROOT = Path(__file__).parents[2]
SIGN = ROOT / "examples" / "drawings" / "sign.svg"
LANGUAGES = {"en": "English", "pt": "pt-BR"}
WORDS = {
    "en": ("sign (example)", "Pocket", "no rule", "flat end mill"),
    "pt": ("sign (exemplo)", "Bolsão", "nenhuma regra", "fresa de topo reto"),
}
TOOLS = "CNCStepper_Template_tools"
RULES, PANEL = "CNCStepper_Panel_rules", "CNCStepper_Panel_rule_"
VALUES = "stepdown_mm = 1.5\nstepover_mm = 1.2"


@pytest.fixture(params=LANGUAGES)
def language(hand: Hand, request: pytest.FixtureRequest) -> Iterator[str]:
    hand.main(FreeCADGui.setLocale, LANGUAGES[request.param])
    hand.settle()
    yield request.param
    hand.main(FreeCADGui.setLocale, "English")
    hand.settle()


def imported(path: Path) -> Any:
    document = FreeCAD.newDocument("Shop")
    document.UndoMode = 1
    api.import_drawing(document, path)
    document.recompute()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return document


def rows() -> list[list[str]]:
    """Return the texts of the list of rules."""
    tree = FreeCADGui.getMainWindow().findChild(QtGui.QTreeWidget, RULES)
    items = [tree.topLevelItem(number) for number in range(tree.topLevelItemCount())]
    return [[item.text(column) for column in range(4)] for item in items]


def put_values(text: str) -> None:
    """Put lines into the box: a test's keyboard types no line breaks there."""
    boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QPlainTextEdit)
    next(box for box in boxes if box.objectName() == f"{PANEL}values").setPlainText(text)


def tools_become(hand: Hand, language: str, folder: Path) -> None:
    """Add a tool 3 of 2.5 mm to the template by its dialog; a diameter that is none is refused there."""
    hand.click("CNCStepper_Panel_template_tools")
    dialog = hand.find(TOOLS)
    page = dialog.page
    if language == "en":
        rows_by_buttons(hand, page, folder)
        hand.click(f"{TOOLS}_cancel")
        hand.wait(lambda: not hand.exists(TOOLS), 10, "the tools to be left as they were")
        hand.click("CNCStepper_Panel_template_tools")
        dialog = hand.find(TOOLS)
        page = dialog.page
        assert len(page.draft.table) == 2
    hand.click(f"{TOOLS}_add")
    put(hand, page, 2, "diameter_mm", "2,5 mm")
    hand.click(f"{TOOLS}_ok")
    hand.settle()
    assert hand.exists(TOOLS) and hand.text(f"{TOOLS}_error")
    hand.shot(f"template-tools-{language}")
    assert hand.main(places.narrower_than_their_text, dialog) == []
    put(hand, page, 2, "diameter_mm", "2,5")
    hand.click(f"{TOOLS}_ok")
    hand.wait(lambda: not hand.exists(TOOLS), 10, "the tools to be taken")


def cut_by_px() -> int:
    """Return by how much the panel is wider than what FreeCAD shows of it."""
    form = FreeCADGui.getMainWindow().findChild(QtGui.QWidget, "CNCStepper_Panel_Template")
    return int(form.width() - form.visibleRegion().boundingRect().width())


def job_of(document: Any) -> Any:
    return next((obj for obj in document.Objects if proxy_type(obj) == "CNCStepper_Job"), None)


def program_of_command_line(drawing: Path, template: Path, title: str) -> str:
    from CNCStepper.job.cut_transfer import program_texts
    from CNCStepper.job.templates.drawing_job import job_of_drawing
    from CNCStepper.job.templates.template import read_template
    from CNCStepper.machine.profile import load_machine

    job = job_of_drawing(read_template(template), drawing, drawing.with_suffix(".toml")).job
    machine = load_machine(job.machine)
    ((_, text),) = program_texts(job.on(machine), machine, title)
    return text


def test_rules_are_changed_saved_and_make_the_job(hand: Hand, language: str, tmp_path: Path) -> None:
    example, pocket, no_rule, flat = WORDS[language]
    path = Path(shutil.copy(SIGN, tmp_path / "placa.svg"))
    document = hand.main(imported, path)
    hand.command("CNCStepper_Template")
    hand.wait(lambda: hand.exists(RULES), 10)
    hand.choose("CNCStepper_Panel_template", example)
    hand.wait(lambda: rows()[-1][:2] == [no_rule, "0"], 40, "the contours of each rule")
    hand.shot(f"template-{language}")
    before = hand.main(rows)
    hand.item(RULES, "pocket")
    hand.click("CNCStepper_Panel_rule_delete")
    hand.wait(lambda: rows()[-1][1] == "0" and len(rows()) == len(before) - 1, 20, "its contours to be taken by lines")
    hand.item(RULES, "lines")
    hand.click("CNCStepper_Panel_rule_delete")
    hand.wait(lambda: rows()[-1][1] not in ("0", "…") and len(rows()) == 3, 20, "the contours that no rule takes")
    hand.item(RULES, no_rule)
    hand.shot(f"template-untaken-{language}")
    hand.item(RULES, "letters")
    hand.click("CNCStepper_Panel_rule_add")
    hand.fill(f"{PANEL}title", "bolsa")
    hand.fill(f"{PANEL}colour", "#000000")
    hand.choose(f"{PANEL}does", pocket)
    hand.wait(lambda: hand.exists(f"{PANEL}tool"), 10)
    hand.choose(f"{PANEL}tool", f"T1  3 mm  {flat}")
    tools_become(hand, language, tmp_path)
    hand.choose(f"{PANEL}tool", f"T3  2.5 mm  {flat}")
    hand.fill(f"{PANEL}depth", "5")
    hand.main(put_values, VALUES)
    hand.click("CNCStepper_Panel_rule_up")
    hand.wait(lambda: rows()[0][0] == "bolsa" and rows()[-1][1] == "0", 20, "all contours to be taken")
    hand.shot(f"template-changed-{language}")
    assert hand.main(cut_by_px) == 0
    hand.fill("CNCStepper_Panel_template_thickness", "10")
    hand.click("CNCStepper_Panel_template_save")
    saved = tmp_path / "oficina ç.toml"
    choose_file(hand, "CNCStepper_Template_file", saved)
    hand.wait(saved.exists, 10, "the template's file")
    with hand.watchdog() as watch:
        hand.button("OK")
        hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 40, "the job to be made")
    print(f"template: at most {watch.max_ms:.0f} ms")
    job = job_of(document)
    hand.wait(lambda: not problem_of(job) and "Touched" not in job.State, 60, "the program")
    assert hand.main(api.program_text, job) == program_of_command_line(path, saved, job.Label)
    hand.shot(f"template-job-{language}")
    hand.undo()
    hand.wait(lambda: job_of(document) is None, 10, "the job to be undone")


def every_other_field(hand: Hand) -> None:
    """Give a rule and the stock what they can take, and begin anew from the file."""
    panel, row = hand.main(the_panel), hand.main(lambda: the_panel().rules.row)
    rule = lambda: panel.draft.rules[row]  # noqa: E731
    for key in ("layer", "name", "group"):
        hand.fill(f"{PANEL}{key}", "cut*")
        hand.wait(lambda key=key: rule()[key] == ["cut*"], 5, key)
    for key, choice, value in (("closed", "no", False), ("filled", "yes", True)):
        hand.choose(f"{PANEL}{key}", choice)
        hand.wait(lambda key=key, value=value: rule()[key] is value, 5, key)
    hand.click(f"{PANEL}through")
    hand.wait(lambda: rule()["operation"]["depth_mm"] == "through", 5, "a cut through the stock")
    stock = lambda: (panel.draft.content["stock"]["margin_mm"], panel.draft.content["material"])  # noqa: E731
    hand.fill("CNCStepper_Panel_template_margin", "13")
    hand.fill("CNCStepper_Panel_template_material", "mdf")
    hand.wait(lambda: stock() == (13, "mdf"), 5, "the stock")
    hand.click("CNCStepper_Panel_rule_down")
    hand.wait(lambda: panel.rules.row == row + 1, 5, "the rule one lower")
    hand.choose("CNCStepper_Panel_template_job", "Job: its operations are replaced")
    assert hand.main(lambda: panel.job.itemData(panel.job.currentIndex()))
    hand.click("CNCStepper_Panel_template_open")
    choose_file(hand, "CNCStepper_Template_file", ROOT / "examples" / "templates" / "sign.toml")
    hand.wait(lambda: stock() == (12, "plywood"), 5, "the stock of the file")


def the_panel() -> Any:
    """Return the panel that is open."""
    import gc

    from CNCStepper.workbench.templates.panel import TemplatePanel

    return next(each for each in gc.get_objects() if isinstance(each, TemplatePanel) and places.isValid(each._timer))


def test_what_is_wrong_is_told_and_nothing_is_made(hand: Hand, tmp_path: Path) -> None:
    document = hand.main(imported, Path(shutil.copy(SIGN, tmp_path / "placa.svg")))
    job = hand.main(api.new_job, document)
    hand.main(lambda: (api.add_tool(job), api.add_operation(job, "face", depth_mm=1), document.recompute()))
    names = hand.main(lambda: [each.Name for each in document.Objects])
    hand.tree("placa")
    hand.command("CNCStepper_Template")
    hand.wait(lambda: hand.exists(RULES), 20, "the panel")
    hand.choose("CNCStepper_Panel_template", WORDS["en"][0])
    hand.wait(lambda: rows()[-1][1] == "0", 40, "the contours of each rule")
    hand.item(RULES, "pocket")
    hand.fill(f"{PANEL}depth", "deep")
    hand.wait(lambda: "no number" in hand.text("CNCStepper_Panel_template_problem"), 10, "the refusal")
    hand.button("OK")
    hand.settle()
    assert hand.exists(RULES)
    hand.fill(f"{PANEL}depth", "5")
    hand.click(f"{PANEL}values")
    hand.key("Ctrl+A")
    hand.type("stepdown_mm = 1.5")
    hand.wait(lambda: not hand.exists("CNCStepper_Panel_template_problem"), 10)
    hand.button("OK")
    hand.wait(lambda: "stepover" in hand.text("CNCStepper_Panel_template_problem"), 20, "the missing value")
    hand.shot("template-refused")
    every_other_field(hand)
    hand.button("Cancel")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10)
    assert hand.main(lambda: [each.Name for each in document.Objects]) == names
    close_while_it_reads(hand, document.Name)


def close_while_it_reads(hand: Hand, name: str) -> None:
    """Close the document under the panel's question: its answer finds no panel, and the report stays empty."""
    from CNCStepper.workbench.calculation.drawing_process import process

    hand.command("CNCStepper_Template")
    hand.wait(lambda: hand.exists(RULES), 20, "the panel")
    panel = hand.main(the_panel)
    hand.main(lambda: (panel._ask(), FreeCAD.closeDocument(name)))
    hand.wait(lambda: not process()._asked, 20, "the end of the question")
    hand.wait(lambda: not hand.exists(RULES), 10, "the panel's end")


SAVING = {"en": "Save as job template…", "pt": "Salvar como modelo de trabalho…"}
QUESTION, ANSWER = "CNCStepper_JobTemplate", "CNCStepper_Tell_"
TAKEN = ("machine", "material", "units", "stock_size_mm", "stock_form", "stock_origin", "work_origin_mm", "retract_mm")


def rectangle(name: str, x_mm: float, y_mm: float) -> Any:
    """Return a new document with a rectangle from its zero on."""
    document = FreeCAD.newDocument(name)
    document.UndoMode = 1
    plate = document.addObject("Part::Feature", "Plate")
    plate.Shape = Part.makePolygon([(0, 0, 0), (x_mm, 0, 0), (x_mm, y_mm, 0), (0, y_mm, 0), (0, 0, 0)])
    return document


def plywood_job() -> Any:
    """Return a job of a rectangle in stock that reaches 7 mm beyond it, with two tools."""
    document = rectangle("Shop", 40, 20)
    stock = {"stock_form": "sheet", "stock_size_mm": (54, 34, 9), "stock_origin": "top-left-front"}
    keys = {"machine": "table-b", "material": "plywood", "units": "inch", "work_origin_mm": (-7, -7, 0)}
    job = api.new_job(document, **stock, **keys)
    api.add_tool(job, number=4, shape="v", diameter_mm=6, tip_angle_deg=60, feed_mm_min=800)
    api.add_tool(job, number=7, diameter_mm=3, feed_mm_min=0, plunge_mm_min=0, spindle_rpm=0)
    api.add_operation(job, "contour", document.Plate, depth_mm=9, stepdown_mm=3)
    document.recompute()
    return job


def save_as(hand: Hand, name: str) -> None:
    """Give a name in the dialog that asks for it."""
    hand.wait(lambda: places.visible(QUESTION), 10, "the question for the name")
    hand.fill(f"{QUESTION}_name", name)
    hand.click(f"{QUESTION}_ok")
    hand.wait(lambda: not places.visible(QUESTION), 10, "the name to be taken")


def saved_by_clicks(hand: Hand, job: Any, language: str, folder: Path) -> None:
    """Save a job by its context menu; then by the menu, where its name is in use, and under one that cannot be."""
    file, words = folder / "chapa ç.toml", SAVING[language]
    hand.tree(job.Label)
    hand._click_place(hand.main(places.of_tree_item, job.Label), RIGHT)
    hand.wait(QtGui.QApplication.activePopupWidget, 5, "the context menu")
    hand._click_place(hand.main(places.popup_entry, words))
    hand.wait(lambda: places.visible(QUESTION), 10, "the question for the name")
    hand.shot(f"job-template-name-{language}")
    hand.click(f"{QUESTION}_cancel")
    hand.wait(lambda: not places.visible(QUESTION), 10, "the question to be left")
    assert not file.exists()
    hand.menu("CNCStepper", words)
    save_as(hand, "chapa ç")
    hand.wait(file.exists, 10, "the template's file")
    before = file.read_bytes()
    hand.main(lambda: (api.edit(job, retract_mm=3), job.Document.recompute()))
    for answer, changes in (("no", False), ("yes", True)):
        hand.menu("CNCStepper", words)
        save_as(hand, "chapa ç")
        hand.wait(lambda: places.visible(f"{ANSWER}ask"), 10, "the question whether to replace it")
        hand.shot(f"job-template-in-use-{language}")
        hand.click(f"{ANSWER}{answer}")
        hand.wait(lambda: not places.visible(f"{ANSWER}ask"), 10, "the answer")
        hand.wait(lambda changes=changes: (file.read_bytes() != before) is changes, 10, "the file")
    hand.menu("CNCStepper", words)
    save_as(hand, "a/b")
    hand.wait(lambda: places.visible(f"{ANSWER}error"), 10, "the refusal of the name")
    hand.click(f"{ANSWER}ok")
    hand.wait(lambda: not places.visible(f"{ANSWER}error"), 10, "the message to close")
    assert [path.name for path in folder.iterdir()] == [file.name]


def test_a_job_is_saved_and_the_next_one_begins_with_it(
    hand: Hand, language: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    folder = tmp_path / "cncstepper" / "templates"
    saved = hand.main(plywood_job)
    saved_by_clicks(hand, saved, language, folder)
    (folder / "quebrado.toml").write_text("machine = 'table-a", "utf-8")
    (folder / "torno.toml").write_text("process = 'turning'", "utf-8")
    wanted = hand.main(values, saved) | {"stock_size_mm": (114, 74, 9)}
    hand.main(FreeCAD.closeDocument, "Shop")
    document = hand.main(rectangle, "Next", 100, 60)
    begin(hand, "CNCStepper_NewJob", "Plate")
    job = hand.main(job_of, document)
    usual = hand.main(values, job)
    offered = hand.main(lambda: [entry for entry in entries_of(f"{FIELD}begin_with") if "(" not in entry])
    assert offered[1:] == ["chapa ç", "quebrado"]
    hand.fill(f"{FIELD}edge_mm", "4")
    hand.choose(f"{FIELD}begin_with", "chapa ç")
    hand.wait(lambda: len(job.Tools) == 2, 10, "the template's tools")
    hand.shot(f"begin-with-{language}")
    found = hand.main(values, job)
    assert {key: found[key] for key in TAKEN} == {key: wanted[key] for key in TAKEN}
    assert (float(job.EdgeMargin), [tool.Number for tool in job.Tools]) == (4, [4, 7])
    hand.choose(f"{FIELD}begin_with", "quebrado")
    hand.wait(lambda: hand.exists(f"{FIELD}begin_with_problem"), 10, "why it cannot be read")
    hand.shot(f"begin-with-refused-{language}")
    assert hand.text(f"{FIELD}begin_with") == "chapa ç" and hand.main(values, job) == found
    hand.choose(f"{FIELD}begin_with", offered[0])
    hand.wait(lambda: len(job.Tools) == 1, 10, "the tool of a new job")
    assert hand.main(values, job) == usual | {"edge_mm": 4, "tools": job.Tools}
    hand.choose(f"{FIELD}begin_with", "chapa ç")
    hand.wait(lambda: len(job.Tools) == 2, 10, "the template's tools")
    accept(hand)
    assert len(hand.main(lambda: document.UndoNames)) == 1
    hand.undo()
    hand.wait(lambda: job_of(document) is None, 10, "the job to be undone")
    assert [each.Name for each in document.Objects] == ["Plate"]


def lathe_job_of(document: Any) -> Any:
    return next((obj for obj in document.Objects if proxy_type(obj) == "CNCStepper_LatheJob"), None)


def shaft_job() -> Any:
    """Return a lathe's job of a thick bar, with two tools."""
    document = FreeCAD.newDocument("Shaft")
    job = api.new_lathe_job(document, stock_diameter_mm=55, stock_length_mm=130, material="pvc", chuck_diameter_mm=125)
    api.add_tool(job, number=3, insert="CNMG 120408")
    api.add_tool(job, number=5, kind="parting", width_mm=3, reach_mm=30)
    document.recompute()
    return job


def test_a_lathe_s_job_is_saved_and_the_next_one_begins_with_it(
    hand: Hand, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    folder = tmp_path / "cncstepper" / "templates"
    saved = hand.main(shaft_job)
    hand.menu("CNCStepper", SAVING["en"])
    save_as(hand, "eixo")
    hand.wait((folder / "eixo.toml").exists, 10, "the template's file")
    (folder / "chapa.toml").write_text("machine = 'table-a'", "utf-8")
    wanted = hand.main(values, saved)
    hand.main(FreeCAD.closeDocument, "Shaft")
    document = hand.main(FreeCAD.newDocument, "Next")
    document.UndoMode = 1
    begin(hand, "CNCStepper_NewLatheJob")
    job = hand.main(lathe_job_of, document)
    usual = hand.main(values, job)
    offered = hand.main(entries_of, f"{FIELD}begin_with")
    assert offered[1:] == ["eixo"]
    hand.fill(f"{FIELD}stock_length_mm", "97")
    hand.choose(f"{FIELD}begin_with", "eixo")
    hand.wait(lambda: len(job.Tools) == 2, 10, "the template's tools")
    hand.shot("begin-with-lathe")
    assert hand.main(values, job) == wanted | {"stock_length_mm": 97, "tools": job.Tools}
    assert [tool.Number for tool in job.Tools] == [3, 5]
    hand.choose(f"{FIELD}begin_with", offered[0])
    hand.wait(lambda: len(job.Tools) == 1, 10, "the tool of a new job")
    assert hand.main(values, job) == usual | {"stock_length_mm": 97, "tools": job.Tools}
    hand.choose(f"{FIELD}begin_with", "eixo")
    hand.wait(lambda: len(job.Tools) == 2, 10, "the template's tools")
    accept(hand)
    hand.undo()
    hand.wait(lambda: lathe_job_of(document) is None, 10, "the job to be undone")
    assert not document.Objects


def entries_of(box: str) -> list[str]:
    """Return the texts of a list to choose from."""
    found = places.find(box)
    return [found.itemText(row) for row in range(found.count())]
