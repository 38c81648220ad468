# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that compute, jump and call are proven piece by piece as their whole text is."""

from __future__ import annotations

import random
from collections import Counter
from pathlib import Path

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.program_file import LineStore
from CNCStepper.gcode.wire.wire_file import WireBlocks, wire_of_file
from CNCStepper.job.prove import prove
from CNCStepper.job.prove_file import prove_file
from CNCStepper.state import Start
from helpers.job.prove_runs import CORED, STOCK, TABLE, assert_same, both, machine_with, pieces  # noqa: F401  a fixture

START = Start.with_work_zero((-200.0, -200.0, -40.0))
HEAD = "%\nG21 G90 G17 T1\nG0 Z5\nG0 X1 Y1\nM3 S10000\nG4 P3\n"
END = "G0 Z5\nM5\nM2\n%\n"
WORDS = [
    f"{line}\n" for line in ("G0 X30", "M5", "M3 S9000", "(MSG, look at #7)", "(operation: again)", "G4 P0.2", "T2")
]
WORDS += ["#<deep> = [#<deep> - 4]\n", "#<deep> = -1\n", "G2 X5 Y5 R60\n", "\n(a comment, ç)\n"]
DIALECTS = ("linuxcnc", "grblhal", "fluidnc")


class Jumps:
    """Writes a program of nested loops, branches, subroutines and faults."""

    def __init__(self, seed: int):
        self._dice, self._labels = random.Random(seed), 100
        self._subs = [self._sub(number) for number in (1, 2)]
        self.text = HEAD + "".join(self._subs) + "#<deep> = -1\n#7 = 3\n" + self._some(3) + END

    def _some(self, depth: int, lines: int = 4) -> str:
        return "".join(self._one(depth) for _ in range(lines))

    def _one(self, depth: int) -> str:
        kinds = [self._cut, self._cut, self._word, self._call]
        if depth:
            kinds += [self._repeat, self._while, self._if]
        return self._dice.choice(kinds)(depth)

    def _label(self) -> str:
        self._labels += 1
        return f"o{self._labels}"

    def _cut(self, depth: int) -> str:
        x, y = self._dice.randint(-20, 20), self._dice.randint(-20, 20)
        return f"#7 = [#7 + 0.25]\nG1 X[{x} + #7] Y{y} Z#<deep> F{self._dice.choice((100, 300, 9000))}\n"

    def _word(self, depth: int) -> str:
        return self._dice.choice(WORDS)

    def _call(self, depth: int) -> str:
        return f"o{self._dice.choice((1, 2))} call [{self._dice.randint(-9, 9)}] [#7]\n"

    def _sub(self, number: int) -> str:
        return f"o{number} sub\nG1 X#1 Y[#2 / 2] F300\nG0 Z{number}\no{number} endsub\n"

    def _repeat(self, depth: int) -> str:
        label = self._label()
        return f"{label} repeat [{self._dice.randint(0, 3)}]\n{self._some(depth - 1)}{label} endrepeat\n"

    def _while(self, depth: int) -> str:
        label = self._label()
        name = f"#<n{label}>"
        body = f"{name} = [{name} + 1]\n{self._some(depth - 1, 2)}"
        return f"{name} = 0\n{label} while [{name} LT {self._dice.randint(1, 3)}]\n{body}{label} endwhile\n"

    def _if(self, depth: int) -> str:
        label = self._label()
        return (
            f"{label} if [#7 GT 5]\n{self._some(depth - 1, 2)}{label} else\n{self._some(depth - 1, 2)}{label} endif\n"
        )


@pytest.mark.slow
@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.usefixtures("pieces")
def test_loops_branches_and_calls(tmp_path: Path, dialect: str) -> None:
    machine, codes, again = machine_with(controller=dialect), Counter[str](), 0
    for seed in range(4):
        print(f"seed {seed}")
        whole, parts = both(tmp_path, Jumps(seed).text, machine, dialect, stock=STOCK, tools=CORED, start=START)
        assert_same(whole, parts)
        lines = whole.toolpath.table().line
        again += int((lines[1:] < lines[:-1]).sum())
        codes.update(finding.code for finding in whole.findings)
        codes["messages"] += len(whole.wire.messages)
        assert parts.wire.messages == whole.wire.messages or dialect == "linuxcnc"
        assert list(parts.wire.file_lines) == whole.wire.file_lines.tolist()
    assert again > 20 and {"rapid-in-stock", "spindle-off", "below-stock", "messages"} <= set(codes), (again, codes)


@pytest.mark.parametrize("dialect", ["grblhal", "fluidnc"])
@pytest.mark.usefixtures("pieces")
def test_play_is_taken_up_in_lines_that_are_written_out(tmp_path: Path, dialect: str) -> None:
    machine = machine_with(controller=dialect, backlash_mm=0.05)
    text = HEAD + "o1 repeat [9]\n(MSG, next)\nG1 X9 Z-1 F200\nX[2 * 3]\nG4 P0.1\no1 endrepeat\nG2 X20 Y4 R30\n" + END
    whole, parts = both(tmp_path, text, machine, dialect, stock=STOCK, tools=CORED)
    assert len(whole.wire.lines) > 45, "play is taken up in lines of its own"
    assert_same(whole, parts)


@pytest.mark.usefixtures("pieces")
def test_parameters_without_jumps_and_a_first_move_without_motion(tmp_path: Path) -> None:
    text = "#1 = 4\nG21 G90\nX[#1] Y1\nM3 S9000\n#1 = [#1 * 2]\nG1 Z-1 F[#1 * 50]\nX#1\n(operation: a)\nX1\nM2\n"
    for dialect in ("mach", "grblhal"):
        own = text.replace("X[#1] Y1", "G0 X[#1] Y1") if dialect == "mach" else text
        whole, parts = both(tmp_path, own, machine_with(controller=dialect), dialect, stock=STOCK, tools=CORED)
        assert_same(whole, parts)


@pytest.mark.usefixtures("pieces")
def test_a_subroutine_in_a_file_beside_the_program(tmp_path: Path) -> None:
    (tmp_path / "ring.ngc").write_text("o<ring> sub\nG1 X#1 F300\nG1 Y#1\no<ring> endsub\n", encoding="ascii")
    text = HEAD + "o<ring> call [5]\nG1 X20\no<ring> call [-5]\n" + END
    for dialect in DIALECTS:
        assert_same(*both(tmp_path, text, machine_with(controller=dialect), dialect, start=START))


@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("line", ["G1 X5 Q7", "G999", "G1 X[1 / 0]", "o5 endif", "o9 endsub"])
@pytest.mark.usefixtures("pieces")
def test_a_refused_line_is_named_as_in_the_whole_text(tmp_path: Path, dialect: str, line: str) -> None:
    file = tmp_path / "p.ngc"
    file.write_text(f"{HEAD}o1 repeat [5]\nX2\no1 endrepeat\n  {line}\nX3\n{END}", encoding="ascii")
    with pytest.raises(ProgramError) as whole:
        prove(file.read_text("ascii"), TABLE, file=str(file), dialect=dialect)
    with pytest.raises(ProgramError) as parts:
        prove_file(file, TABLE, dialect=dialect)
    assert str(parts.value) == str(whole.value)


@pytest.mark.slow
@pytest.mark.parametrize("dialect", DIALECTS)
def test_rows_and_events_of_a_loop_are_handed_on_while_it_runs(tmp_path: Path, dialect: str) -> None:
    file = tmp_path / "p.ngc"
    file.write_text(
        f"{HEAD}o1 repeat [30000]\nG1 X1 F300\nX2\nX3\nG4 P0\n(MSG, on)\no1 endrepeat\n{END}", encoding="ascii"
    )
    wire = wire_of_file(file, None, dialect)
    assert isinstance(wire, WireBlocks) == (dialect != "linuxcnc")
    first = next(wire.chunks())
    assert len(first) == 65_536 and wire.table.index < 80_000


def test_lines_are_read_in_any_order_and_few_are_held() -> None:
    lines = [f"X{number} é\x0b" for number in range(300_000)]
    pieces_of = ("".join(f"{line}\r\n" for line in lines[first : first + 999]) for first in range(0, len(lines), 999))
    with LineStore.of(pieces_of) as store:
        dice = random.Random(7)
        for place in [0, len(lines) - 1, -1, *(dice.randrange(len(lines)) for _ in range(5000))]:
            assert store[place] == lines[place]
        assert len(store) == len(lines) and list(store[255:513]) == lines[255:513]
        assert sum(map(len, store._blocks.values())) <= 512 * 256
        with pytest.raises(IndexError):
            store[len(lines)]
