# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate: what it names, that it gives the sender all it needs, and that nothing in it can be changed."""

from __future__ import annotations

import functools
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from CNCStepper.control.program.bundle import LINE_MAP, WIRE, Bundle
from CNCStepper.control.program.certificate import Certificate, digest_of, digest_of_lines, digest_of_text, sendable
from CNCStepper.control.program.send_job import write_job
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.errors import JobError, Place
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.job.make_certificate import (
    certificate_of,
    check_cut,
    cut_content,
    keep_out_digest,
    machine_digest,
    proven_wire,
    send_job,
    stock_digest,
    tools_digest,
)
from CNCStepper.job.prove import Proof, prove
from CNCStepper.machine.cut_charts import cut_data_for
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.output_files import is_ours
from CNCStepper.simulation.checks.clamps import Clamp
from CNCStepper.simulation.stock import Cylinder, HeightField, Stock
from CNCStepper.state import Start

TEXT = (
    "%\n(peça)\nG21 G90\nT1\nM3 S10000\nG4 P3\nG0 Z5\nG0 X10 Y0\nG1 Z-1 F300\n(MSG, look)\nM0\n"
    "G3 X10 Y0 I-10 J0 F2000\nG0 Z5\nM5\nM2\n"
)
MACHINE = load_machine("table-a")
START = Start.with_work_zero((-200.0, -150.0, -40.0))
STOCK = Stock((40, 40, 5))
CLAMP = Clamp(((30.0, 30.0), (35.0, 35.0)), 8.0)
TOOLS = {1: Tool(number=1, shape="flat", diameter_mm=6.0)}


def proof_of(text: str = TEXT, **instead: Any) -> Proof:
    words = {"file": "p.nc", "start": START, "stock": STOCK, "tools": TOOLS, "keep_out": [CLAMP]} | instead
    return prove(text, words.pop("machine", MACHINE), **words)


@functools.cache  # made when the first test asks: collecting the tests compiles nothing
def proof() -> Proof:
    return proof_of()


@functools.cache
def certificate() -> Certificate:
    return certificate_of(proof())


def written(made: Certificate, folder: Path) -> Path:
    made.write(folder / "ç certificate.zip")
    return folder / "ç certificate.zip"


def read_back(made: Certificate, folder: Path) -> Certificate:
    return Certificate.read(written(made, folder))


def test_it_names_what_was_proven_and_what_was_found() -> None:
    content = json.loads(json.dumps(certificate().head()))
    assert content["wire"]["sha256"] == prepare(TEXT).sha256 == digest_of_lines(prepare(TEXT).lines)
    assert content["start"]["sha256"] == START.sha256()
    assert content["start"]["state"]["work_offsets_mm"] == {"G54": [-200.0, -150.0, -40.0]}
    assert content["machine"]["name"] == MACHINE.name
    assert content["keep_out"]["clamps"] == [{"corners_mm": [[30.0, 30.0], [35.0, 35.0]], "top_mm": 8.0}]
    assert content["keep_out"]["edge_mm"] is None
    assert content["stock"]["stock"] == {"form": "stock", "size_mm": [40.0, 40.0, 5.0], "origin": "top-centre"}
    assert content["tools"]["tools"]["1"]["diameter_mm"] == 6.0
    assert content["findings"] == proof().report["findings"]
    assert content["times"]["program_s"] == proof().report["time_s"] > 0
    assert content["figures"]["pierces"] == 1 and content["figures"]["removed_volume_mm3"] > 300
    assert content["tolerance"]["cell_mm"] == pytest.approx(proof().part.cell_mm)


def test_a_program_that_starts_nowhere_has_a_certificate_in_strict_json(tmp_path: Path) -> None:
    content = read_back(certificate_of(proof_of(start=None, stock=None, tools=None)), tmp_path).content
    assert content["start"]["state"]["position_mm"] == [None] * 3
    assert content["stock"]["stock"] is None and content["tools"]["tools"] is None
    assert content["send"]["work_offsets_mm"] == {}


def test_the_sender_finds_all_it_needs(tmp_path: Path) -> None:
    job = sendable(written(certificate(), tmp_path), port="COM3", zero_confirmed=True)
    wire = prepare(TEXT)
    assert (job.port, job.zero_confirmed, tuple(job.lines)) == ("COM3", True, wire.lines)
    assert list(job.file_lines) == wire.file_lines.tolist() and job.messages == wire.messages
    assert job.expected == expected_settings(MACHINE)
    assert job.work_offsets_mm == {"G54": [-200.0, -150.0, -40.0], "G92": [0.0, 0.0, 0.0]}
    assert job.work_system == "G54"


def test_places_that_the_program_goes_to_are_compared_on_the_machine() -> None:
    places = {5161 + axis: float(axis - 9) for axis in range(3)} | {5181 + axis: 1.0 for axis in range(3)}
    job = send_job(prepare("G91\nG28 Z0\nG30.1\nM2\n"), MACHINE, "p.nc", Start(parameters=places))
    assert dict(job.work_offsets_mm) == {"G28": (-9.0, -8.0, -7.0)}


def test_a_bare_job_stays_sendable(tmp_path: Path) -> None:
    job = send_job(prepare(TEXT), MACHINE, "p.nc")
    write_job(tmp_path / "job.zip", job)
    found = sendable(tmp_path / "job.zip")
    assert list(found.lines) == list(job.lines) and list(found.file_lines) == list(job.file_lines)
    assert replace(found, lines=(), file_lines=()) == replace(job, lines=(), file_lines=())


def test_errors_are_not_sendable(tmp_path: Path) -> None:
    refused = certificate_of(proof_of(start=Start.with_work_zero((-5.0, -150.0, -40.0))))
    with pytest.raises(JobError, match=r"1 error\(s\)") as refusal:
        sendable(written(refused, tmp_path))
    assert refusal.value.code == "certificate-errors" and refusal.value.place.line == 8
    certificate().check_clean()


@given(st.data())
def test_any_changed_character_of_the_wire_text_is_refused(data: st.DataObject) -> None:
    wire = prepare(TEXT).text
    at = data.draw(st.integers(0, len(wire) - 1))
    other = data.draw(st.characters(min_codepoint=10, max_codepoint=126).filter(lambda c: c != wire[at]))
    lines = (wire[:at] + other + wire[at + 1 :]).split("\n")[:-1]
    with pytest.raises(JobError, match="not those that were proven"):
        certificate().compare("wire", digest_of_lines(lines))
    with TemporaryDirectory() as folder, pytest.raises(JobError):  # also with a fingerprint that was made anew
        read_back(replace(certificate(), lines=lines), Path(folder))


@given(st.data())
def test_any_changed_character_of_the_program_is_refused(data: st.DataObject) -> None:
    at = data.draw(st.integers(0, len(TEXT) - 1))
    other = data.draw(st.characters(exclude_categories=["Cs"]).filter(lambda c: c != TEXT[at]))
    with pytest.raises(JobError, match="its text differs"):
        certificate().compare("program", digest_of_text(TEXT[:at] + other + TEXT[at + 1 :]))


def leaves(content: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Return the way to every value of plain data."""
    if isinstance(content, dict):
        return [leaf for key, value in content.items() for leaf in leaves(value, (*path, key))]
    if isinstance(content, list):
        return [leaf for key, value in enumerate(content) for leaf in leaves(value, (*path, key))]
    return [path]


def test_parameters_and_tools_of_any_number_are_read_back_unchanged(tmp_path: Path) -> None:
    start = replace(START, parameters={9: 1.0, 10: 2.0, 5221: 3.0}, tool_lengths_mm={2: 10.0, 10: 20.0})
    read = read_back(certificate_of(proof_of(start=start)), tmp_path)  # refuses what was changed
    assert read.content["start"]["state"]["parameters"] == {"9": 1.0, "10": 2.0, "5221": 3.0}


@given(st.data())
def test_any_changed_value_of_a_certificate_is_refused(data: st.DataObject) -> None:
    content = json.loads(json.dumps(certificate().head()))
    *way, last = data.draw(st.sampled_from(leaves(content)))
    inner = content
    for key in way:
        inner = inner[key]
    inner[last] = data.draw(st.sampled_from([None, 0, 17.5, "x", [], {}]).filter(lambda value: value != inner[last]))
    with pytest.raises(JobError) as refusal:
        Certificate.of_bundle(bundle_of(content))
    assert refusal.value.advice


def bundle_of(head: dict[str, Any]) -> Bundle:
    return Bundle(head, {WIRE: certificate().lines, LINE_MAP: certificate().file_lines})


def test_a_changed_line_map_is_refused() -> None:
    changed = replace(bundle_of(certificate().head()), columns={WIRE: certificate().lines, LINE_MAP: [1] * 10})
    with pytest.raises(JobError) as refusal:
        Certificate.of_bundle(changed)
    assert refusal.value.code == "certificate-changed"


def old_content() -> dict[str, Any]:
    """Return what the last release wrote: one JSON with the lines in it."""
    sent: dict[str, Any] = {"lines": list(certificate().lines), "file_lines": list(certificate().file_lines)}
    sent["messages"] = {str(index): text for index, text in certificate().messages.items()}
    content = dict(certificate().content) | {"version": 1, "send": {**certificate().content["send"], **sent}}
    return content | {"sha256": digest_of(content)}


def test_an_old_certificate_is_read(tmp_path: Path) -> None:
    file = tmp_path / "certificate.json"
    file.write_text(json.dumps(old_content(), indent=1), "utf-8")
    job = sendable(file, port="COM3")
    assert is_ours(file, "certificate") and is_ours(written(certificate(), tmp_path), "certificate")
    assert (tuple(job.lines), job.port) == (prepare(TEXT).lines, "COM3") and job.messages == prepare(TEXT).messages
    file.write_text(file.read_text("utf-8").replace("look", "talk"), "utf-8")
    with pytest.raises(JobError) as refusal:
        Certificate.read(file)
    assert refusal.value.code == "certificate-changed" and refusal.value.place.file == str(file)


def test_the_same_proof_gives_the_same_bytes(tmp_path: Path) -> None:
    first = written(certificate(), tmp_path).read_bytes()
    assert written(certificate(), tmp_path).read_bytes() == first
    assert certificate_of(proof_of()).sha256 == certificate().sha256


CHANGES: dict[str, Callable[[], str]] = {
    "start": lambda: Start.with_work_zero((-200.0, -150.0, -39.99)).sha256(),
    "machine": lambda: machine_digest(MACHINE.model_copy(update={"tool_change": "split"})),
    "stock": lambda: stock_digest(Stock((40, 40, 6))),
    "tools": lambda: tools_digest({1: TOOLS[1].model_copy(update={"diameter_mm": 5.99})}),
    "keep_out": lambda: keep_out_digest([Clamp(((30.0, 30.0), (35.0, 35.0)), 8.5)], None),
}


@pytest.mark.parametrize("what", CHANGES)
def test_another_start_machine_stock_tool_or_clamp_is_refused(what: str) -> None:
    with pytest.raises(JobError) as refusal:
        certificate().compare(what, CHANGES[what]())
    assert refusal.value.code == f"certificate-{what}" and "check the program again" in str(refusal.value)
    same = {
        "start": Start.with_work_zero((-200.0, -150.0, -40.0)).sha256(),
        "machine": machine_digest(load_machine("table-a")),
        "stock": stock_digest(Stock((40.0, 40.0, 5.0))),
        "tools": tools_digest({1: Tool(number=1, shape="flat", diameter_mm=6)}),
        "keep_out": keep_out_digest([CLAMP], None),
    }
    certificate().compare(what, same[what])


STEEL = cut_data_for("plasma", "mild-steel", 3.0)
TORCH = load_machine("torch-table")


def torch_certificate() -> Certificate:
    text = "G21 G90\nG0 X10 Y10\nM3 S1000\nG4 P0.3\nG1 X110 F3000\nM5\nM2\n"
    return certificate_of(prove(text, TORCH, file="t.nc", process=PROCESSES["plasma"], cut_data=STEEL))


def test_process_and_chart_row_are_named_and_compared(tmp_path: Path) -> None:
    made = read_back(torch_certificate(), tmp_path)
    assert made.content["cut"]["process"] == "plasma"
    told = {"material": "mild-steel", "thickness_mm": 3.0, "consumable": STEEL.consumable, "kerf_mm": STEEL.kerf_mm}
    assert told.items() <= made.content["cut"]["row"].items()
    check_cut(made, TORCH, cut_content(TORCH, PROCESSES["plasma"], STEEL.model_copy(update={"source": "by hand"})))
    check_cut(made, None, None)
    thick = cut_data_for("plasma", "mild-steel", 6.0)
    with pytest.raises(JobError, match=r"thickness_mm = 6\.0.*thickness_mm = 3\.0") as refusal:
        check_cut(made, TORCH, cut_content(TORCH, PROCESSES["plasma"], thick))
    assert refusal.value.code == "certificate-cut"


def test_a_machine_without_the_proven_process_is_refused() -> None:
    with pytest.raises(JobError, match="does not cut by plasma"):
        check_cut(torch_certificate(), MACHINE, None)


def test_a_certificate_of_before_names_no_process() -> None:
    content = {key: value for key, value in torch_certificate().content.items() if key != "cut"}
    check_cut(Certificate(content), TORCH, None)
    with pytest.raises(JobError, match="process = plasma"):
        check_cut(Certificate(content), TORCH, cut_content(TORCH, PROCESSES["plasma"], STEEL))
    bare = certificate_of(prove("G21 G90\nG0 X10 Y10\nM2\n", TORCH, file="t.nc"))
    assert bare.content["cut"] == {"process": None, "row": None}  # nobody has said how it cuts
    with pytest.raises(JobError, match="that no proof has"):
        check_cut(Certificate(content | {"cut": 3}), TORCH, None)


def test_stocks_of_other_forms_have_other_fingerprints() -> None:
    field = np.full((2, 3), 5.0)
    lower = field.copy()
    lower[0, 0] = 4.999
    stocks = [None, STOCK, Cylinder((40, 40, 5)), *(HeightField((40, 40, 5), heights_mm=one) for one in (field, lower))]
    assert len({stock_digest(stock) for stock in stocks}) == len(stocks)


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"{",
        b"[]",
        b"{}",
        b'{"format": "CNCStepper certificate"}',
        b'{"format": "CNCStepper certificate", "version": 1}',
        b'{"format": "CNCStepper certificate", "version": 1, "send": 3}',
        b"\xff\xfe",
        b"[" * 100_000,
        b"PK\3\4",
        b"PK\3\4" + b"\0" * 100,
    ],
)
def test_what_is_no_certificate_is_refused_with_a_sentence(data: bytes, tmp_path: Path) -> None:
    (tmp_path / "c").write_bytes(data)
    with pytest.raises(JobError, match="check the program again") as refusal:
        Certificate.read(tmp_path / "c")
    assert refusal.value.place == Place(str(tmp_path / "c"))


def test_another_version_is_refused() -> None:
    with pytest.raises(JobError, match="another version"):
        Certificate.of_bundle(bundle_of(dict(certificate().content) | {"version": 3}))


PLAY = {"backlash_mm": [0.1] * 3, "true_sense": [1] * 3, "steps_per_mm": [80.0] * 3}


def loose(backlash_mm: float) -> Machine:
    axes = {name: axis.model_copy(update={"backlash_mm": backlash_mm}) for name, axis in MACHINE.axis.items()}
    return MACHINE.model_copy(update={"axis": axes})


def test_play_that_is_taken_up_is_proven_with_the_text(tmp_path: Path) -> None:
    """The same part, findings and tool's way as without play, later, and a wire text of its own."""
    clean, loosened = proof(), proof_of(machine=loose(0.1))
    assert [finding.code for finding in loosened.findings] == [finding.code for finding in clean.findings]
    assert loosened.part is not None and clean.part is not None
    assert loosened.report["removed_volume_mm3"] == pytest.approx(clean.report["removed_volume_mm3"], rel=1e-3)
    assert clean.times_s[-1] + 0.1 < loosened.times_s[-1] < clean.times_s[-1] + 2.0
    assert loosened.wire.sha256 != clean.wire.sha256
    assert len(loosened.motors) == len(loosened.toolpath) > len(clean.toolpath)
    made = read_back(certificate_of(loosened), tmp_path)
    assert made.content["wire"]["play"]["backlash_mm"] == [0.1, 0.1, 0.1]
    assert tuple(made.send_job().lines) == tuple(loosened.wire.lines)
    for start in (None, START):
        assert proven_wire(made, TEXT, "grbl", "p.nc", start).sha256 == loosened.wire.sha256
    assert proven_wire(certificate(), TEXT, "grbl", "p.nc", None).sha256 == clean.wire.sha256


@pytest.mark.parametrize(
    "change",
    [
        lambda wire: {"wire": wire | {"play": {"backlash_mm": 3}}},
        lambda wire: {"wire": wire | {"play": [0.1]}},
        lambda _: {"wire": {"play": PLAY | {"true_sense": [1]}}},
        lambda _: {"wire": 3},
        lambda _: {"wire": {"play": PLAY}, "start": {}},
        lambda _: {"wire": {"play": PLAY}, "start": {"state": {"position_mm": "home"}}},
    ],
)
def test_a_certificate_that_somebody_made_is_refused_by_its_code(change: Callable[[Any], dict[str, Any]]) -> None:
    content = certificate().content
    made = Certificate(content | change(content["wire"]))
    with pytest.raises(JobError) as caught:
        proven_wire(made, TEXT, "grbl", "p.nc", None)
    assert caught.value.code == "certificate-bad"


def test_travel_is_that_of_the_motors() -> None:
    """At the end of the axis the motor has to stand beyond it, which the controller's soft limits refuse."""
    text, start = "G21 G90\nG0 X-10\nX0\nM2\n", Start.at_zero()
    assert "travel" not in [finding.code for finding in prove(text, MACHINE, start=start).findings]
    assert "travel" in [finding.code for finding in prove(text, loose(0.1), start=start).findings]
