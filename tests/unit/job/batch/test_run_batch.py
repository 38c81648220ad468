# SPDX-License-Identifier: LGPL-2.1-or-later
"""An order gives the same bytes on any workers, whoever is killed; what is done is not done again."""

from __future__ import annotations

import json
import os
import random
import signal
import socket
import threading
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from matplotlib.figure import Figure

from CNCStepper.errors import JobError, LinkError
from CNCStepper.job.batch import cluster_workers
from CNCStepper.job.batch.batch_files import write_tables
from CNCStepper.job.batch.cluster_workers import ClusterWorkers, require_safe
from CNCStepper.job.batch.local_workers import LocalWorkers, Workers
from CNCStepper.job.batch.offer import save_offer
from CNCStepper.job.batch.order_costs import Figures, row_figures, total_figures
from CNCStepper.job.batch.order_rows import read_rows
from CNCStepper.job.batch.run_batch import BatchResult, NestOptions, run_batch
from CNCStepper.job.batch.task_journal import TaskJournal
from CNCStepper.machine.profile import load_machine
from helpers.batch.small_orders import WorkersHere, bytes_in, jobs_apart, write_order

JOBS = int(os.environ.get("CNCSTEPPER_CASES", "20"))
NESTED = ["square.dxf,laser.toml,plywood,3,5", "ring.dxf,laser.toml,plywood,3,3", "ring.dxf,laser.toml,plywood,5,1"]
USUAL = NestOptions()
SMALL = NestOptions(sheet_mm=(70.0, 50.0), seeds=2, attempts=1)


def made(order: Path, folder: Path, workers: Workers, options: NestOptions = USUAL) -> BatchResult:
    folder.mkdir(exist_ok=True)
    with workers:
        result = run_batch(read_rows(order), folder, workers, options)
    write_tables(result, folder, "order")
    return result


def test_parts_of_one_stock_are_nested_and_priced(tmp_path: Path) -> None:
    order = write_order(tmp_path / "in", NESTED)
    result = made(order, tmp_path / "out", WorkersHere(), SMALL)
    assert result.is_whole, [sheet.error or sheet.result["refused"] for sheet in result.sheets]
    assert len(result.sheets) >= 3 and result.sheets[-1].rows == {2: 1}
    counts: Counter[int] = Counter()
    for sheet in result.sheets:
        counts.update(dict(sheet.rows))
    assert counts == {0: 5, 1: 3, 2: 1}
    rows, total = row_figures(result), total_figures(result)
    assert [row.parts for row in rows] == [5, 3, 1]
    assert [row.pierces for row in rows] == [5, 6, 2]  # a line, a pierce
    for name in ("sheets", "metres", "pierces", "hours", "cost"):
        assert sum(getattr(row, name) for row in rows) == pytest.approx(getattr(total, name))
    area_m2 = len(result.sheets) * 0.07 * 0.05
    wanted = 60 * total.hours + 0.5 * total.metres + 0.1 * total.pierces + 2 * total.sheets + 20 * area_m2
    assert total.cost == pytest.approx(wanted) and total.currency == "EUR"
    assert "EUR" in (tmp_path / "out" / "rows.csv").read_text("utf-8")


def test_facing_edges_of_an_order_are_cut_once(tmp_path: Path) -> None:
    order = write_order(tmp_path / "in", [*NESTED[:1], *NESTED[2:]])
    shared = NestOptions(sheet_mm=(90.0, 60.0), seeds=1, attempts=2, common_lines=True)
    apart = made(order, tmp_path / "apart", WorkersHere(), NestOptions(sheet_mm=(90.0, 60.0), seeds=1, attempts=2))
    result = made(order, tmp_path / "shared", WorkersHere(), shared)
    assert result.is_whole, [*result.errors.values(), *(sheet.error for sheet in result.sheets)]
    saved_m = total_figures(apart).metres - total_figures(result).metres
    assert saved_m > 0.02, "five squares of 60 mm have edges in common"
    assert "m of cut and" in (tmp_path / "shared" / "order.txt").read_text("utf-8")


def test_an_offer_is_the_sum_of_the_prices_that_it_names(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    texts: list[str] = []
    monkeypatch.setattr(Figure, "text", lambda self, x, y, text, **style: texts.append(text))
    order = write_order(tmp_path / "in", [*NESTED[2:], "square.dxf,laser.toml,plywood,,2", "gone.dxf,laser.toml,,3,1"])
    result = made(order, tmp_path / "out", WorkersHere(), NestOptions((70.0, 50.0), seeds=1, attempts=0))
    first, second = (round(row.cost or 0.0, 2) for row in row_figures(result)[:2])
    assert f"{first + second:.2f} EUR" in texts and f"{second:.2f}" in texts
    assert texts.count("3 mm") == 2 and texts.count("plywood") == 2 and "gone (not offered)" in texts
    result.unplaced[1] = (1, "no room")
    save_offer(tmp_path / "offer.pdf", result, "a title", lambda text: {"Total": "Soma"}.get(text, text))
    assert "Soma" in texts and f"{first:.2f} EUR" in texts


def test_prices_in_several_currencies_have_no_sum() -> None:
    total = Figures(cost=1.0, currency="EUR")
    total.add(Figures(cost=2.0, currency="EUR"))
    assert (total.cost, total.currency) == (3.0, "EUR")
    total.add(Figures(cost=2.0, currency="BRL"))
    assert (total.cost, total.currency) == (None, "EUR, BRL")


def test_a_zero_in_the_middle_keeps_parts_on_their_sheet(tmp_path: Path) -> None:
    result = made(write_order(tmp_path / "in", NESTED[:1], "top-centre"), tmp_path / "out", WorkersHere(), SMALL)
    assert result.is_whole
    report = json.loads((tmp_path / "out" / "job-1-1-report.json").read_text("utf-8"))
    box = report["bounding_box_mm"]
    assert box["min"][0] >= -35.0 and box["max"][0] <= 35.0 and box["min"][0] < 0.0


def test_workers_killed_at_random_lose_nothing_and_do_nothing_twice(tmp_path: Path) -> None:
    order = write_order(tmp_path / "in", [*jobs_apart(JOBS), *NESTED[:2]])
    seed = random.randrange(1_000_000)
    print(f"seed {seed}")
    here = made(order, tmp_path / "one", WorkersHere(seed))
    workers, over, killed = LocalWorkers(2), threading.Event(), list[int]()
    journal = tmp_path / "two" / "journal.jsonl"
    killer = threading.Thread(target=_kill, args=(workers, random.Random(seed), over, killed, journal), daemon=True)
    killer.start()
    result = made(order, tmp_path / "two", workers)
    over.set()
    killer.join()
    assert killed and result.is_whole and here.is_whole
    assert bytes_in(tmp_path / "one") == bytes_in(tmp_path / "two")
    lines = (tmp_path / "two" / "journal.jsonl").read_text("ascii").splitlines()[1:]
    keys = [json.loads(line)["key"] for line in lines]
    assert len(set(keys)) == len(keys) == result.done == here.done


def _kill(
    workers: LocalWorkers, choice: random.Random, over: threading.Event, killed: list[int], journal: Path
) -> None:
    """Kill a worker now and then, once at least, but none before a task is done: one killed each time is refused."""
    most, seen = 3 + JOBS // 10, -1
    while not over.wait(0.2 + choice.random()) and len(killed) < most:
        done = journal.stat().st_size if journal.exists() else 0
        if done > seen and (pids := workers.pids):
            seen = done
            killed.append(choice.choice(pids))
            os.kill(killed[-1], signal.SIGKILL if hasattr(signal, "SIGKILL") else signal.SIGTERM)


@pytest.mark.parametrize("most", [2, 6])
def test_what_was_done_before_an_interruption_is_not_done_again(tmp_path: Path, most: int) -> None:
    order, folder = write_order(tmp_path / "in", NESTED), tmp_path / "out"
    stopped = WorkersHere(most=most)
    with pytest.raises(KeyboardInterrupt):
        made(order, folder, stopped, SMALL)
    with (folder / "journal.jsonl").open("ab") as journal:
        journal.write(b'{"key": ["odd"], "result": 1, "files": 2}\n{"key": "torn')  # as a power failure leaves it
    again = made(order, folder, rest := WorkersHere(), SMALL)
    assert again.is_whole and again.found == most and again.done == rest.done
    last = made(order, folder, idle := WorkersHere(), SMALL)
    assert idle.done == 0 and last.found == again.found + again.done
    kept = bytes_in(folder)
    (folder / "job-2-1.nc").write_text("changed", "ascii")
    made(order, folder, once := WorkersHere(), SMALL)
    assert once.done == 1 and bytes_in(folder) == kept


def test_a_second_order_waits_for_the_first_one_in_a_folder(tmp_path: Path) -> None:
    with TaskJournal(tmp_path), pytest.raises(JobError, match="another process"), TaskJournal(tmp_path):
        pass
    with TaskJournal(tmp_path):
        pass


def test_files_of_rows_that_are_gone_are_taken_away(tmp_path: Path) -> None:
    order, folder = write_order(tmp_path / "in", jobs_apart(2)), tmp_path / "out"
    made(order, folder, WorkersHere())
    assert (folder / "job-2-1.nc").exists()
    made(write_order(tmp_path / "in", jobs_apart(2)[:1]), folder, WorkersHere())
    assert not (folder / "job-2-1.nc").exists() and (folder / "job-1-1.nc").exists()


def test_a_scheduler_with_two_workers_gives_the_same_bytes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    distributed = pytest.importorskip("distributed")
    order = write_order(tmp_path / "in", NESTED)
    made(order, tmp_path / "here", WorkersHere(), SMALL)
    options: dict[str, Any] = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": "127.0.0.1:0"}
    with distributed.LocalCluster(processes=True, host="127.0.0.1", **options) as cluster:
        result = made(order, tmp_path / "there", ClusterWorkers(cluster.scheduler_address), SMALL)
        monkeypatch.setattr(cluster_workers, "CONNECT_S", 3.0)  # for which a lost scheduler is looked for
        with pytest.raises(LinkError) as told, ClusterWorkers(cluster.scheduler_address) as workers:
            cluster.close()  # in the middle
            list(workers.results([{"kind": "read"}]))
    assert told.value.code == "cluster-lost" and "same command" in told.value.advice
    assert result.is_whole
    assert bytes_in(tmp_path / "here") == bytes_in(tmp_path / "there")


def test_a_port_that_takes_the_call_and_never_answers_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr(cluster_workers, "CONNECT_S", 0.5)
    with socket.create_server(("127.0.0.1", 0)) as silent, pytest.raises(LinkError) as told:
        ClusterWorkers(f"tcp://127.0.0.1:{silent.getsockname()[1]}").__enter__()
    assert told.value.code == "cluster-silent" and "start one" in told.value.advice


@pytest.mark.parametrize(
    ("address", "code"),
    [
        ("tcp://10.0.0.5:8786", "cluster-open"),
        ("tcp://scheduler.shop:8786", "cluster-open"),
        ("tcp://0.0.0.0:8786", "cluster-open"),
        ("ucx://127.0.0.1:8786", "cluster-address"),
        ("127.0.0.1:8786", "cluster-address"),
        ("tcp://127.0.0.1", "cluster-address"),
        ("tcp://127.0.0.1:99999", "cluster-address"),
        ("tcp://[::1", "cluster-address"),
        ("tls://10.0.0.5:8786", "cluster-keys"),
    ],
)
def test_a_cluster_that_others_could_reach_is_refused(address: str, code: str) -> None:
    with pytest.raises(JobError) as told:
        require_safe(address, ())
    assert told.value.code == code and told.value.advice and told.value.value == address


def test_a_scheduler_here_or_with_keys_is_taken() -> None:
    for address in ("tcp://127.0.0.1:8786", "tcp://[::1]:8786", "tcp://localhost:8786"):
        require_safe(address, ())
    require_safe("tls://10.0.0.5:8786", [Path("ca.pem"), Path("cert.pem"), Path("key.pem")])


def test_rates_are_kept_in_a_profile_and_change_no_proof(tmp_path: Path) -> None:
    from CNCStepper.job.make_certificate import machine_digest

    write_order(tmp_path, NESTED)
    machine = load_machine(tmp_path / "machine.toml")
    assert machine.rates and machine.rates.square_metre_of("plywood") == 20.0
    assert machine.rates.square_metre_of("steel") == 0.0
    assert machine_digest(machine) == machine_digest(load_machine("laser-table"))
