# SPDX-License-Identifier: LGPL-2.1-or-later
"""Modules, classes and functions have the field's words: no name was given up; the glossary has each word once."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[2]
GIVEN_UP_WORDS = """
    actions acts bare belief bench beside blame buttons desk desk_client desk_worker earlier found front gap grid
    hand held held_moves hold_and_resume idle items kept led leader letters lift loose made_with meanwhile measured
    memory moment one_way overheard page path_watch patience pieces plain play power_on prepare question_key reached
    read_runs readers reins relief retrace return_path rounds said_modes same_switches same_work saved_modes sides
    simple speech stand stored story subject surface suspension take_up tape tell telling told watch way_tree ways
    wire_and_ways wishes
"""
GIVEN_UP_NAMES = """
    Asker awaits_person awake back_over_gaps BackFlow Backing BackView bare_start begin_anew Belief BeliefFile
    beside beside_selected blamed blind Busiest Chart chart_of check_lift check_spoken contours_told CutOnce
    cuts_at_granted_speed cuts_into_loose dark_while_held Desk desk_at desk_near DeskClient DeskFile DeskSession
    dress earlier_parts earlier_proofs end_held_at Entering EnteringFields Entrance entrance_of FaultyWay
    FaultyWords file_beside Front g92_kept Gaps gaps_of goes_beyond_words goes_on_at granted_modes greet greeted
    greeted_by Ground HaltView Hand hear hear_and_turn hears_no_more heed Held held_by_job held_words
    hurt_warnings is_tape_mark keep_or_tell Keeping keeps_moves Kept KeptCuts KeptPath Laid lay_below lay_near
    lay_row Leader leads_to_stand leave_stand Led looks_at_others made_with MadeWith meanwhile Meanwhile met
    Moment Moments News nothing_met obey onward outlive over_gaps Overheard OwnFile Page patience PlainReader
    Play play_of poke ProgramWatch Questioner Reached read_story Recovery RecoveryView Reins Relief RestartTold
    Retrace Rooms rooms_of run_anew running_desks said_before_cut said_modes say_rotation say_work_offset
    seek_python Seen Sight small_letters spoil spoken Stand stand_message stand_reset StandCount stands_at
    stands_here started_desk stories Story stream_of_rounds Suspension take_lock_soon TakeUp Talk Tape
    tell_closed tell_once tell_outcome tell_words Telling told told_by told_of Typed unlink_soon want_back
    want_more want_rest wanting Warming WayBack Where why_not_onward wire_and_ways WireAndWays wish_of
    wish_of_machine Wishes with_take_up
"""
GIVEN_UP_STEMS = "belief desk desks farewell hear hears heed obey obeys overheard reins stranger wishes"
CORE = "control controllers cycles drawing gcode geometry job machine motion recovery simulation"
DEFINITION = re.compile(r"^ *(?:async def|def|class) (\w+)", re.MULTILINE)
WORD = re.compile(r"[A-Z]?[a-z0-9]+|[A-Z]+(?![a-z])")
COLUMNS = 4  # English, Portuguese, meaning, source


def rows(file: str = "glossary.md") -> list[list[str]]:
    """Return the cells of a glossary's rows."""
    lines = (ROOT / "docs" / file).read_text("utf-8").splitlines()
    table = [line for line in lines if line.startswith("| ")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in table[1:]]


def test_no_module_has_a_name_that_was_given_up() -> None:
    stems = Counter(path.stem for path in (ROOT / "CNCStepper").rglob("*.py"))
    assert len(stems) > 500
    assert not sorted(set(GIVEN_UP_WORDS.split()) & set(stems))


def test_no_two_modules_of_the_core_have_one_name() -> None:
    """Two modules of one name are two places to look; shells, workers and virtual machines may name what they serve."""
    core = [
        path
        for folder in CORE.split()
        for path in (ROOT / "CNCStepper" / folder).rglob("*.py")
        if path.stem != "__init__"
    ]
    assert len(core) > 400
    stems = Counter(path.stem for path in core)
    assert not [str(path.relative_to(ROOT)) for path in core if stems[path.stem] > 1]


def test_no_unit_test_imports_another_test() -> None:
    files = [path for folder in ("unit", "helpers") for path in (ROOT / "tests" / folder).rglob("*.py")]
    assert len(files) > 300
    found = [
        path.name for path in files if re.search(r"^\s*(from|import) test_", path.read_text("utf-8"), re.MULTILINE)
    ]
    assert not found, "what tests share is in tests/helpers"


def test_the_folders_of_freecads_tests_hold_tests_only() -> None:
    files = [path for folder in ("freecad", "window") for path in (ROOT / "tests" / folder).glob("*.py")]
    assert len(files) > 50
    others = {path.name for path in files if not path.name.startswith("test_")} - {"conftest.py", "run.py"}
    assert not others, "what they share is in tests/helpers/freecad and tests/window_helpers"


def test_the_glossary_gives_each_word_once_in_both_languages() -> None:
    words = rows()
    assert len(words) > 50
    assert all(len(row) == COLUMNS and row[0] and row[1] and row[2] for row in words)
    english = [row[0] for row in words]
    assert len(set(english)) == len(english) and english == sorted(english, key=str.casefold)
    theirs = {row[1]: row[0] for row in rows("glossary.pt-BR.md") if row[2]}
    assert theirs == {row[0]: row[1] for row in words} and len(set(theirs.values())) == len(theirs)
