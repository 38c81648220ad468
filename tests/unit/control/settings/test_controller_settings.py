# SPDX-License-Identifier: LGPL-2.1-or-later
"""A controller's settings as a whole: backup, comparison, restoring on a virtual grbl with faults, the profile."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.control.protocol.grbl.firmware import FLUIDNC, GRBL, GRBLHAL, PARPORT
from CNCStepper.control.settings.controller_identity import identity_of
from CNCStepper.control.settings.setting_names import setting_name
from CNCStepper.control.settings.settings_comparison import compare_settings
from CNCStepper.control.settings.settings_file import read_settings, settings_text, write_settings
from CNCStepper.control.settings.settings_profile import profile_from_settings, settings_of_profile
from CNCStepper.control.settings.settings_restore import (
    ASK_SETTINGS,
    check_answer,
    check_restored,
    check_takes_settings,
    restore_lines,
)
from CNCStepper.errors import JobError, MachineRefusal
from CNCStepper.machine.own_profiles import profile_content
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.grbl.settings import defaults
from helpers.control.service_bench import Person, Visit

TABLE = {number: round(value, 3) for number, value in defaults(load_machine("table-a"), homing=False).items()}


class Restoring(Visit):
    """A person who restores settings line by line over the connection service, and stops at the first refusal."""

    def __init__(self, tmp_path: Path, wanted: dict[int, float], **table):
        super().__init__(tmp_path, **table)
        self.wanted, self.lines = wanted, []
        self.answers: list[str] = []
        self.read: list[dict[int, float]] = []

    def person(self) -> Person:
        yield from self._read_back()
        self.lines = restore_lines(self.read[0], self.wanted)
        for line in self.lines:
            yield from self._type(line)
            if self.answers[-1] != "ok":
                break
        yield from self._read_back()

    def _type(self, line: str) -> Person:
        count = len(self._answers())
        self.ask("line", text=line)
        yield lambda: len(self._answers()) > count
        self.answers.append(self._answers()[-1])

    def _read_back(self) -> Person:
        first = len(self.told)
        yield from self._type(ASK_SETTINGS)
        self.answers.pop()
        self.read.append(dict(identity_of(text for kind, text in self.told[first:] if kind == "console").settings))

    def _answers(self) -> list[str]:
        return [text for kind, text in self.told if kind == "answer"]


def test_a_backup_is_read_back_as_it_was_and_so_is_what_other_senders_write(tmp_path: Path) -> None:
    path = tmp_path / "machine ç.txt"
    write_settings(path, TABLE | {102: 2267.717}, "grbl 1.1h")
    assert read_settings(path) == TABLE | {102: 2267.717}
    assert "$102=2267.717 ; Z: steps per mm, 1/mm" in path.read_text("utf-8")
    path.write_text("$0=10 (step pulse, usec)\n$100=80.000\n# a remark\n\n$74=MyWifi\n$22=1 ;homing", "utf-8")
    assert read_settings(path) == {0: 10, 100: 80, 22: 1}
    for text, code in (("$100=80\nG0 X1\n", "settings-line"), ("; nothing\n", "settings-none")):
        path.write_text(text, "utf-8")
        with pytest.raises(JobError) as refused:
            read_settings(path)
        assert refused.value.code == code
    assert settings_text({9000: 1.0}, "x").splitlines()[1] == "$9000=1"


def test_two_sides_are_compared_by_number_with_names_and_units() -> None:
    rows = {row.number: row for row in compare_settings({100: 80.0, 1: 25, 32: 0}, {100: 80.0004, 32: 1, 9: 3})}
    assert not rows[100].differs and rows[32].differs and rows[1].is_one_sided and rows[9].is_one_sided
    assert tuple(rows[100].name) == ("X: steps per mm", "1/mm")
    assert setting_name(121).name == "Y: acceleration" and setting_name(9999).name == ""


def test_restoring_writes_what_differs_and_reads_it_back(tmp_path: Path) -> None:
    visit = Restoring(tmp_path, TABLE | {100: 157.575, 20: 1, 22: 1, 110: 3000, 400: 1})
    visit.receive(visit.person)
    assert visit.lines == ["$22=1", "$20=1", "$100=157.575", "$110=3000"], "homing before the soft limits"
    assert visit.answers == ["ok"] * 4
    check_restored(visit.read[-1], visit.lines, visit.wanted)
    assert visit.service.status().position_known is False, "with other steps the position means something else"
    assert restore_lines(visit.read[-1], visit.wanted) == []
    back = restore_lines(visit.read[-1], TABLE)
    assert back[-1] == "$22=0"


def test_a_refused_setting_stops_the_rest_and_is_told_with_what_was_written(tmp_path: Path) -> None:
    visit = Restoring(tmp_path, TABLE | {0: 5, 100: 0.0, 110: 3000})
    visit.receive(visit.person)
    assert visit.answers[0] == "ok" and visit.answers[1].startswith("error:4") and len(visit.answers) == 2
    with pytest.raises(MachineRefusal) as refused:
        check_answer(visit.lines, 1, visit.answers[1])
    assert "$100=0" in refused.value.what and refused.value.value == "1 of 3 settings written"
    assert visit.read[-1][0] == 5 and visit.read[-1][110] == TABLE[110]
    with pytest.raises(MachineRefusal, match="restore-differs"):
        check_restored(visit.read[-1], visit.lines, visit.wanted)


def test_a_cable_that_is_pulled_in_the_middle_leaves_the_rest_unwritten(tmp_path: Path) -> None:
    visit = Restoring(tmp_path, TABLE | {100: 90.0, 101: 91.0, 110: 3000})

    def pull(data: bytes) -> None:
        visit.table.cut = data.startswith(b"$101")

    visit.table.on_write = pull
    with pytest.raises(Exception, match="the cable is out"):
        visit.receive(visit.person)
    board = visit.table.board.memory.settings
    assert board[100] == 90.0 and board[110] == TABLE[110]
    assert restore_lines(board.values, visit.wanted)[-1] == "$110=3000", "compared again, it names what is left"


def test_firmwares_that_keep_no_numbered_settings_are_refused() -> None:
    for firmware, code in ((FLUIDNC, "settings-fluidnc"), (PARPORT, "settings-own")):
        with pytest.raises(MachineRefusal) as refused:
            check_takes_settings(firmware)
        assert refused.value.code == code
    for firmware in (GRBL, GRBLHAL):
        check_takes_settings(firmware)


def test_what_answers_is_known_from_its_own_lines() -> None:
    grbl = identity_of(["[VER:1.1h.20190830:]", "[OPT:V,15,128]", "$100=80", "$101=80", "$102=400"])
    assert (grbl.controller, grbl.axes, str(grbl.text)) == ("grbl", "XYZ", "grbl 1.1, version 1.1h.20190830")
    hal = identity_of(["[VER:1.1f.20240101:]", "[FIRMWARE:grblHAL]", "[DRIVER:STM32F4xx]", "[BOARD:SuperLongBoard]"])
    assert (hal.controller, hal.board) == ("grblhal", "SuperLongBoard")
    assert identity_of(["[VER:3.7 FluidNC v3.7.8:]"]).controller == "fluidnc"
    own = identity_of(["[FIRMWARE:CNCStepper parport]"])
    assert own.is_own and own.controller == ""


def test_a_profile_takes_a_controllers_settings_and_gives_them_back() -> None:
    settings = TABLE | {100: 157.575, 111: 6000, 122: 30, 130: 300, 30: 9000, 11: 0.02, 22: 1, 23: 3}
    content = profile_from_settings(profile_content("table-a"), settings)
    machine = Machine.model_validate(content)
    assert (machine.axis["x"].steps_per_mm, machine.axis["x"].travel_min_mm) == (157.575, -300)
    assert [machine.axis[name].homing for name in "xyz"] == ["min", "min", "max"]
    assert settings_of_profile(machine).items() <= settings.items()
    assert profile_from_settings(content, {})["axis"] == content["axis"]
    laser = profile_from_settings(profile_content("laser-table"), settings)
    assert "z" not in laser["axis"], "a board has a Z that the machine has not"
    lathe = profile_from_settings(profile_content("mini-lathe"), {100: 79.0})
    assert Machine.model_validate(lathe).axis["x"].steps_per_mm == 79.0
