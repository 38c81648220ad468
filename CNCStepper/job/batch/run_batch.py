# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs an order: rows are read, grouped and nested, sheets are made and proven, by workers; nothing is done twice.

rows ──► read ──► groups of one template, material, thickness ──► nest, a task a seed ──► lay ──► make, a sheet each
                     └── one part alone: made as it is                                               └──► BatchResult
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

from CNCStepper import __version__
from CNCStepper.control.session.status import error_from_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.job.batch.local_workers import Result, Task, Workers
from CNCStepper.job.batch.nest_task import best_of
from CNCStepper.job.batch.order_rows import OrderRow
from CNCStepper.job.batch.task_files import file_bytes, own_machine, template_files, whole
from CNCStepper.job.batch.task_journal import TaskJournal, task_key
from CNCStepper.job.templates.template import Template, read_template

Group = tuple[Path, str, float | None]
Key = TypeVar("Key")


@dataclass(frozen=True)
class NestOptions:
    """How parts are nested. sheet_mm: None: the template's, or the machine's travel; gap_mm: None: its margin.

    common_lines: facing edges of neighbours are cut once; the gap is the kerf of the template's operations.
    """

    sheet_mm: tuple[float, float] | None = None
    gap_mm: float | None = None
    turn: str = "half"
    seeds: int = 2
    attempts: int = 4
    common_lines: bool = False


@dataclass(frozen=True)
class MadeSheet:
    """A sheet, or a part alone. rows: the order's rows on it, by number, with how many parts of each."""

    name: str
    rows: Mapping[int, int]
    result: Result
    error: CNCStepperError | None = None


@dataclass
class BatchResult:
    """What became of an order. reads: the result of each row's reading, {} for a refused one.

    errors: of rows, by number; notes: of rows; unplaced: how many parts of a row lie on no sheet, and why. done: how
    many tasks were found in the journal. nests: the layout of each group.
    """

    rows: Sequence[OrderRow]
    reads: list[Result] = field(default_factory=list)
    errors: dict[int, CNCStepperError] = field(default_factory=dict)
    unplaced: dict[int, tuple[int, str]] = field(default_factory=dict)
    sheets: list[MadeSheet] = field(default_factory=list)
    nests: dict[int, Result] = field(default_factory=dict)
    found: int = 0
    done: int = 0

    @property
    def is_whole(self) -> bool:
        """Whether all parts of all rows are made and no program is refused."""
        sound = all(sheet.error is None and not sheet.result["refused"] for sheet in self.sheets)
        return sound and not self.errors and not self.unplaced


Progress = Callable[[str, float], None]


def run_batch(
    rows: Sequence[OrderRow],
    folder: Path,
    workers: Workers,
    options: NestOptions,
    progress: Progress = lambda doing, share: None,
) -> BatchResult:
    """Return what became of an order whose files are written into a folder, which exists.

    A row that is refused costs no other one. Raises OSError for files that cannot be written, LinkError for a cluster
    that does not answer.
    """
    with TaskJournal(folder) as journal:
        return _Batch(rows, folder, workers, options, progress, journal).run()


@dataclass(frozen=True)
class _Sheet:
    """A sheet that is going to be made. place: number of its group, and its own; rows: as in MadeSheet."""

    task: Task
    place: tuple[int, int]
    rows: Mapping[int, int]


class _Batch:
    def __init__(
        self,
        rows: Sequence[OrderRow],
        folder: Path,
        workers: Workers,
        options: NestOptions,
        progress: Progress,
        journal: TaskJournal,
    ):
        self._rows, self._folder, self._workers, self._options = rows, folder, workers, options
        self._progress, self._journal = progress, journal
        self._result = BatchResult(rows)
        self._templates: dict[Path, Template] = {}
        self._keys: set[str] = set()

    def run(self) -> BatchResult:
        """Read, nest, make; return all results in the order of rows and sheets."""
        self._read()
        groups = self._groups()
        alone = {number: group for number, group in groups.items() if self._is_alone(group)}
        sheets = [self._sheet_alone(number, group[0]) for number, group in alone.items()]
        sheets += self._laid({number: group for number, group in groups.items() if number not in alone})
        self._make(sorted(sheets, key=lambda sheet: sheet.place))
        self._journal.drop_others(self._keys)
        return self._result

    def _read(self) -> None:
        tasks: dict[int, Task] = {}
        self._result.reads = [{} for _ in self._rows]
        for number, row in enumerate(self._rows):
            try:
                if row.error:
                    raise row.error
                tasks[number] = self._task("read", row, self._files([row]), drawing=whole(row.drawing))
            except CNCStepperError as error:
                self._result.errors[number] = error
        for number, result in self._results("reading", tasks):
            if "error" in result:
                self._result.errors[number] = error_from_json(result["error"])
            else:
                self._result.reads[number] = result

    def _groups(self) -> dict[int, list[int]]:
        """Return the numbers of the rows that are nested together, by the number of the group, from 1."""
        groups: dict[Group, list[int]] = defaultdict(list)
        for number, row in enumerate(self._rows):
            if number not in self._result.errors:
                groups[row.template.absolute(), row.material, row.thickness_mm].append(number)
        return dict(enumerate(groups.values(), start=1))

    def _is_alone(self, group: Sequence[int]) -> bool:
        """Whether a group is one part, which lies on a stock as its template says."""
        return sum(self._rows[number].count for number in group) == 1 and self._options.sheet_mm is None

    def _sheet_alone(self, group: int, number: int) -> _Sheet:
        row, name = self._rows[number], f"job-{group}-1"
        task = self._task("make", row, self._files([row]), drawing=whole(row.drawing), name=name)
        return _Sheet(task, (group, 1), {number: 1})

    def _laid(self, groups: Mapping[int, Sequence[int]]) -> Iterator[_Sheet]:
        """Yield the sheets of the best layout of each group."""
        seeds = range(1, self._options.seeds + 1)
        wanted = {
            (group, seed): self._nest_task(group, numbers, seed) for group, numbers in groups.items() for seed in seeds
        }
        found = dict(self._results("nesting", wanted))
        best = {group: best_of([found[group, seed] for seed in seeds]) for group in groups}
        tasks = {
            group: wanted[group, 1] | {"kind": "lay", "placements": best[group]["placements"]}
            for group, numbers in groups.items()
            if not self._refuse(numbers, best[group])
        }
        for group, result in sorted(self._results("drawing sheets", tasks)):
            if self._refuse(groups[group], result):
                continue
            self._result.nests[group] = result
            for each in best[group]["unplaced"]:
                self._result.unplaced[groups[group][each["part"]]] = (each["count"], each["why"])
            yield from self._sheets(group, groups[group], result)

    def _refuse(self, numbers: Sequence[int], result: Result) -> bool:
        """Note the error of a group at all its rows, and return whether there is one."""
        if "error" in result:
            self._result.errors.update(dict.fromkeys(numbers, error_from_json(result["error"])))
        return "error" in result

    def _sheets(self, group: int, numbers: Sequence[int], layout: Result) -> Iterator[_Sheet]:
        row = self._rows[numbers[0]]
        for place, counts in enumerate(layout["sheets"], start=1):
            drawing = self._folder / f"sheet-{group}-{place}.dxf"
            files = self._files([row], drawing)
            told = {"drawing": whole(drawing), "name": f"job-{group}-{place}", "sheet_mm": layout["sheet_mm"]}
            task = self._task("make", row, files, **told)
            lie = {number: count for number, count in zip(numbers, counts, strict=True) if count}
            yield _Sheet(task, (group, place), lie)

    def _nest_task(self, group: int, numbers: Sequence[int], seed: int) -> Task:
        rows = [self._rows[number] for number in numbers]
        told = self._options
        return self._task(
            "nest",
            rows[0],
            self._files(rows),
            parts=[{"drawing": whole(row.drawing), "count": row.count} for row in rows],
            group=group,
            seed=seed,
            attempts=told.attempts,
            turn=told.turn,
            gap_mm=told.gap_mm,
            sheet_mm=told.sheet_mm and list(told.sheet_mm),
            common_lines=told.common_lines,
        )

    def _make(self, sheets: Sequence[_Sheet]) -> None:
        tasks = {sheet.place: sheet.task for sheet in sheets}
        found = dict(self._results("making and proving", tasks))
        for sheet in sheets:
            result = found[sheet.place]
            error = error_from_json(result["error"]) if "error" in result else None
            self._result.sheets.append(MadeSheet(sheet.task["name"], sheet.rows, result, error))

    def _task(self, kind: str, row: OrderRow, files: Mapping[str, bytes], **told: Any) -> Task:
        """Return a task with what all kinds have: the row's template, thickness and material."""
        return {
            "kind": kind,
            "version": __version__,
            "folder": whole(self._folder),
            "template": whole(row.template),
            "machine": own_machine(self._template(row.template)),
            "thickness_mm": row.thickness_mm,
            "material": row.material,
            "files": files,
            **told,
        }

    def _files(self, rows: Sequence[OrderRow], drawing: Path | None = None) -> dict[str, bytes]:
        """Return the bytes of the rows' drawings, or of a sheet's, and of what their template names."""
        drawings = [drawing] if drawing else [row.drawing for row in rows]
        files = {whole(path): file_bytes(path) for path in drawings}
        return files | template_files(self._template(rows[0].template))

    def _template(self, path: Path) -> Template:
        if path not in self._templates:
            self._templates[path] = read_template(path)
        return self._templates[path]

    def _results(self, doing: str, tasks: Mapping[Key, Task]) -> Iterator[tuple[Key, Result]]:
        """Yield the result of each task, those of the journal first; what is finished is noted there at once.

        Tasks that are equal, as the reading of two equal rows, are done once.
        """
        waiting: dict[str, list[Key]] = defaultdict(list)
        for name, task in tasks.items():
            self._keys.add(key := task_key(task))
            found = self._journal.found(key)
            if found is None:
                waiting[key].append(name)
            else:
                self._result.found += 1
                yield name, found
        self._progress(doing, 0.0)
        keys = list(waiting)
        runs = self._workers.results([tasks[waiting[key][0]] for key in keys])
        for count, (number, result) in enumerate(runs, start=1):
            self._progress(doing, count / len(keys))
            self._result.done += 1
            told = result if "error" in result else self._journal.note(keys[number], result)
            yield from ((name, told) for name in waiting[keys[number]])
