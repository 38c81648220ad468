# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program goes only to a controller that reads its lines as the proof has read them."""

from __future__ import annotations

import pytest

from CNCStepper.control.preflight.checks import check_sendable
from CNCStepper.control.program.certificate import FORMAT, VERSION, Certificate
from CNCStepper.control.program.send_job import read_job, write_job
from CNCStepper.control.protocol.grbl.firmware import BOARD_FIRMWARES, OWN_FIRMWARES
from CNCStepper.control.protocol.grbl.firmware import FIRMWARES as KNOWN
from CNCStepper.errors import MachineRefusal
from CNCStepper.gcode.dialects import dialect_names
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.job.make_certificate import send_job
from CNCStepper.virtual.grbl.firmware import FIRMWARES
from helpers.control.service_bench import Visit

READ = {"grbl": {"grbl"}, "grblhal": {"grbl", "grblhal"}, "fluidnc": {"grbl", "fluidnc"}}
THESIS = ("G90X40Y0F300", "G0X0Y0")  # cuts there; rapids to grbl


@pytest.mark.parametrize("allowed", [False, True])
def test_cut_of_another_language_is_no_rapid_of_this_one(tmp_path, allowed):
    visit = Visit(tmp_path)

    def person():
        visit.job(*THESIS, dialect="thesis-a", allow_differences=allowed)
        yield visit.ended()

    visit.receive(person)
    error = visit.outcomes[0].error
    assert error.code == "dialect-differs" and visit.table.x_mm() == 0.0
    assert "cncstepper convert PROGRAM --dialect thesis-a --to grbl" in error.advice


@pytest.mark.parametrize("dialect", [*dialect_names(), ""])
@pytest.mark.parametrize("firmware", FIRMWARES.values(), ids=lambda firmware: firmware.name)
def test_each_firmware_takes_its_own_language_and_that_of_grbl(tmp_path, firmware, dialect):
    visit = Visit(tmp_path, firmware=firmware)

    def person():
        visit.job("G21G90G94", "G1X-1F1500", dialect=dialect)
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].done is (dialect in READ[firmware.name] | {""})


@pytest.mark.parametrize("dialect", dialect_names())
@pytest.mark.parametrize("controller", [*READ, "linuxcnc", ""])
def test_what_cannot_be_sent_is_refused_before_a_port_is_opened(dialect, controller):
    def refused() -> bool:
        try:
            check_sendable(dialect, controller)
        except MachineRefusal as error:
            assert error.code == "dialect-differs" and error.value == dialect
            return True
        return False

    assert refused() is not (dialect in READ.get(controller, set.union(*READ.values())))


def test_languages_of_the_firmwares_are_known_ones():
    assert {name for firmware in KNOWN for name in firmware.dialects} <= set(dialect_names())
    assert all(firmware.dialects[0] == firmware.key for firmware in BOARD_FIRMWARES)
    assert {firmware.key: firmware.dialects for firmware in OWN_FIRMWARES} == {
        "parport": ("grbl",),
        "board": ("grbl",),
        "lathe": ("mini-lathe",),
    }


@pytest.mark.parametrize(
    ("controller", "dialect"), [("thesis-a", "grbl"), ("usb-board", "grbl"), ("mini-lathe", "mini-lathe")]
)
def test_controllers_of_this_computer_take_the_language_of_their_wire_only(controller, dialect):
    check_sendable(dialect, controller)
    for other in {"grbl", "mini-lathe", "thesis-a", "iso"} - {dialect}:
        with pytest.raises(MachineRefusal, match="dialect"):
            check_sendable(other, controller)


def test_job_of_no_known_machine_names_its_language(tmp_path):
    job = send_job(prepare("G90 X40 Y0 F300\n", "thesis-a"), None, "part.nc", None, "thesis-a")
    write_job(tmp_path / "job.zip", job)
    assert read_job(tmp_path / "job.zip").dialect == "thesis-a"


def test_certificate_names_the_language_of_its_lines():
    content = {"format": FORMAT, "version": VERSION, "wire": {"dialect": "grblhal"}, "send": {}}
    assert Certificate(content, ["G0X1"]).send_job().dialect == "grblhal"
