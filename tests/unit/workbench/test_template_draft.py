# SPDX-License-Identifier: LGPL-2.1-or-later
"""A template while it is changed: rules as texts and back, their order, and what is no value."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from CNCStepper.errors import JobError
from CNCStepper.job.templates.drawing_job import job_of_drawing
from CNCStepper.job.templates.template import read_template
from CNCStepper.job.templates.template_files import with_whole_paths, write_template
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.libraries.table_draft import TableDraft
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.templates.draft import Draft, RuleTexts, first_rules, rule_of, takes_words, texts_of
from CNCStepper.workbench.templates.tool_table import TemplateTools

EXAMPLES = sorted((Path(__file__).parents[3] / "examples" / "templates").glob("*.toml"))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_rule_of_the_examples_comes_back_from_its_texts(path: Path) -> None:
    rules = read_toml(path)["rule"]
    assert [rule_of(texts_of(rule), {}) | {} for rule in rules] == [
        {
            key: [one.strip() for one in value.split(";")]
            if key in ("layer", "colour", "name", "group") and isinstance(value, str)
            else value
            for key, value in rule.items()
        }
        for rule in rules
    ]
    assert [rule_of(texts_of(rule), rule) for rule in rules] == rules


def test_a_pattern_that_is_not_typed_anew_stays_even_with_the_divider_in_it() -> None:
    rule = {"layer": "a; b", "ignore": True}
    assert rule_of(replace(texts_of(rule), title="x"), rule) == {"title": "x", "layer": "a; b", "ignore": True}
    assert rule_of(replace(texts_of(rule), layer="a; c"), rule)["layer"] == ["a", "c"]


def test_what_is_typed_becomes_an_operation() -> None:
    texts = RuleTexts("cut", colour="#ff0000; #00ff00", closed="yes", does="contour", tool=2, depth="2,5",
                      values='side = "inside"\ntabs = { count = 2 }')  # fmt: skip
    operation = {"cycle": "contour", "tool": 2, "depth_mm": 2.5, "side": "inside", "tabs": {"count": 2}}
    rule = {"title": "cut", "colour": ["#ff0000", "#00ff00"], "closed": True, "operation": operation}
    assert rule_of(texts, {}) == rule and texts_of(rule) == replace(texts, depth="2.5")
    assert takes_words(rule) == "#ff0000; #00ff00"
    assert rule_of(replace(texts, depth="through"), {})["operation"]["depth_mm"] == "through"
    with pytest.raises(Refused):
        rule_of(replace(texts, depth="deep"), {})
    with pytest.raises(JobError, match="further values"):
        rule_of(replace(texts, values="side = inside"), {})


def test_rules_are_added_moved_and_deleted_and_the_file_is_the_same_template(tmp_path: Path) -> None:
    path = EXAMPLES[0]
    draft = Draft(read_toml(path), path)
    titles = [rule.get("title") for rule in draft.rules]
    assert draft.add(0) == 1 and draft.rules[1] == {"ignore": True}
    assert draft.move(1, -1) == 0 and draft.move(0, -1) == 0 and "ignore" in draft.rules[0]
    draft.delete(0)
    assert [rule.get("title") for rule in draft.rules] == titles
    write_template(with_whole_paths(draft.content, path.parent), tmp_path / "loja ç" / "own.toml")
    written, own = read_template(tmp_path / "loja ç" / "own.toml"), read_template(path)
    assert (written.rule, written.stock, written.drawing) == (own.rule, own.stock, own.drawing)
    draft.put_stock("thickness_mm", "3,5")
    draft.put_material("birch")
    assert (draft.content["stock"]["thickness_mm"], draft.content["material"]) == (3.5, "birch")


def typed(draft: Draft, row: int, **cells: str) -> TableDraft:
    table = TableDraft(TemplateTools(draft))
    if row == len(table.table):
        table.add(row - 1)
    table.table[row].texts.update(cells)
    return table


def test_tools_are_added_changed_and_deleted_and_the_job_has_them(tmp_path: Path) -> None:
    path = next(each for each in EXAMPLES if each.stem == "sign")
    draft = Draft(read_toml(path), path)
    keys, before = list(draft.content), draft.tools
    typed(draft, 1, diameter_mm="8,5", flutes="").save()
    typed(draft, 2, shape="v", diameter_mm="12", tip_angle_deg="60").save()
    changed = {"number": 2, "shape": "flat", "diameter_mm": 8.5}
    v_bit = {"number": 3, "shape": "v", "diameter_mm": 12, "tip_angle_deg": 60, "made_of": "carbide"}
    assert draft.tools == [before[0], changed, v_bit] and list(draft.content) == keys
    written = tmp_path / "own.toml"
    write_template(with_whole_paths(draft.content, path.parent), written)
    job = job_of_drawing(read_template(written), path.parents[1] / "drawings" / "sign.svg", tmp_path / "j.toml").job
    assert [(tool.number, tool.diameter_mm) for tool in job.tool] == [(1, 3), (2, 8.5), (3, 12)]
    table = typed(draft, 0)
    table.delete(range(3))
    table.save()
    assert "tool" not in draft.content and draft.tools == []


def test_a_bad_tool_is_told_at_its_cell_and_beside_a_tool_file_a_part_is_enough() -> None:
    content = {"tool": [{"number": 1, "feed_mm_min": 800, "word": "kept"}], "rule": [{"ignore": True}]}
    assert set(typed(Draft(content, Path("t.toml")), 0, feed_mm_min="fast").judged()[1]) == {
        (0, "shape"), (0, "diameter_mm"), (0, "feed_mm_min"),
    }  # fmt: skip
    draft = Draft({**content, "tools": "shop.fctl"}, Path("t.toml"))
    table = typed(draft, 0, feed_mm_min="900")
    assert not table.judged()[1]
    table.save()
    assert draft.tools == [{"number": 1, "feed_mm_min": 900, "word": "kept"}]
    doubled = typed(draft, 1, number="1")
    assert set(doubled.judged()[1]) == {(1, "number")}
    jet = typed(Draft({"tool": []}, Path("t.toml")), 0, shape="jet", diameter_mm="0.2")
    assert not jet.judged()[1]
    with pytest.raises(JobError, match="no tool bit"):
        jet.export_file(Path("jet.fctl"), [0])


def test_tools_come_from_another_file_with_free_numbers(tmp_path: Path) -> None:
    draft = Draft({"tool": [{"number": 1, "shape": "flat", "diameter_mm": 6}]}, Path("t.toml"))
    table = TableDraft(TemplateTools(draft))
    assert table.export_file(tmp_path / "tools.fctl", [0]) == []
    table.import_file(tmp_path / "tools.fctl")
    table.save()
    assert [(tool["number"], tool["diameter_mm"]) for tool in draft.tools] == [(1, 6), (2, 6)]


def test_a_template_that_is_none_is_not_written(tmp_path: Path) -> None:
    with pytest.raises(JobError, match="rule"):
        write_template({"stock": {"thickness_mm": 3}, "rule": []}, tmp_path / "none.toml")
    assert not (tmp_path / "none.toml").exists()


def test_a_new_template_leaves_each_layer_and_colour_out() -> None:
    assert first_rules([("a", "#ff0000"), ("a", ""), ("a", "#ff0000")]) == [
        {"title": "a #ff0000", "layer": "a", "colour": "#ff0000", "ignore": True},
        {"title": "a", "layer": "a", "ignore": True},
    ]
    assert first_rules([]) == [{"ignore": True}]
