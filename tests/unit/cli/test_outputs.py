# SPDX-License-Identifier: LGPL-2.1-or-later
"""No verb writes over what it reads: every output option of every verb, held against every file that the verb reads.

The calls are made from the declarations of the options, so that a new verb or option is held to the rule without a
line here.
"""

from __future__ import annotations

import errno
import os
import shutil
from collections.abc import Iterator
from pathlib import Path

import click
import pytest
from click.testing import CliRunner, Result

from CNCStepper import atomic_file
from CNCStepper.cli.common.path_types import InputFolder, InputPath, OutputFolder, OutputPath
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.main import FAMILY_OF, group, main

EXAMPLES = Path(__file__).parents[3] / "examples"
PROGRAM = "G21 G90\nG0 X1 Y1 Z1\nG1 X10 F600\no<sub> call\nM2\n"
IN_FOLDERS = {
    ("run",): ["program.nc", "report.json", "certificate-1-T2.zip", "part.png"],
    ("edit", "split"): ["p-2-T7.nc"],
    ("slice",): ["slice-001.dxf", "slices.json", "assembled.png"],
    ("batch",): ["job-1-1.nc", "rows.csv", "order.txt", "offer.pdf", "journal.jsonl"],
    ("nest",): ["sheet-0.dxf", "remnant-0-1.dxf", "placements.json", "nest.png"],
}
WORDS = {"PROFILE": "m.toml", "DIALECT": "grbl", "SHAPE:MM": "flat:3", "NUMBER": "1", "X,Y": "1,1", "X,Y,Z": "1,1,1"}
WORDS["HEIGHT,D1,D2,D3"] = "1,1,1,1"


def commands(holder: click.Command = group, *names: str) -> Iterator[tuple[tuple[str, ...], click.Command]]:
    """Yield every command that can be called, with its words."""
    if not isinstance(holder, click.Group):
        yield names, holder
        return
    context = click.Context(holder)
    for name in holder.list_commands(context):
        command = holder.get_command(context, name)
        assert command is not None
        yield from commands(command, *names, name)


def outputs_of(command: click.Command) -> list[click.Parameter]:
    return [param for param in command.params if isinstance(param.type, OutputPath)]


WRITING = {names: command for names, command in commands() if outputs_of(command)}
PAIRS = [(names, param.opts[-1]) for names, command in WRITING.items() for param in outputs_of(command)]


@pytest.mark.parametrize(
    ("names", "command"), list(commands()), ids=lambda value: " ".join(value) if isinstance(value, tuple) else ""
)
def test_every_path_of_every_verb_is_an_input_or_under_the_rule(names: tuple[str, ...], command: click.Command) -> None:
    for param in command.params:
        if isinstance(param.type, click.Path | click.File):
            known = isinstance(param.type, InputPath | InputFolder | OutputPath)
            assert known, f"{' '.join(names)} {param.opts}: say what it is with a type of cli/common/path_types.py"
    if outputs_of(command):
        assert isinstance(command, Verb), f"{' '.join(names)} does not check its outputs"
        assert any("--overwrite" in param.opts for param in command.params)


def test_the_walk_finds_the_verbs_that_write() -> None:
    writers = {
        "drawing",
        "job",
        "run",
        "check",
        "steps",
        "simulate",
        "edit",
        "compact",
        "compare",
        "print",
        "convert",
        "chart",
        "tools",
        "restart",
        "virtual",
        "machine",
        "machine-test",
        "settings",
        "nest",
        "arrange",
        "slice",
        "batch",
        "part-records",
    }
    assert {names[0] for names in WRITING} == writers <= set(FAMILY_OF)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a file of every kind that a verb reads."""
    folder = tmp_path / "peça 1"
    (folder / "sub").mkdir(parents=True)
    (folder / "p.nc").write_text(PROGRAM, "ascii")
    (folder / "sub" / "sub.nc").write_text("o<sub> sub\nG1 X20\no<sub> endsub\n", "ascii")
    (folder / "m.toml").write_bytes((EXAMPLES / "machines" / "table-a.toml").read_bytes())
    (folder / "outline.csv").write_text("x,y\n0,0\n10,0\n10,10\n", "ascii")
    (folder / "j.toml").write_text('machine = "m.toml"\n[[operation]]\npoints = "outline.csv"\n', "ascii")
    for name in ("i.txt", "i.tbl"):
        (folder / name).write_text("T1 P1 Z1 D1\n", "ascii")
    monkeypatch.chdir(folder)
    return folder


def inputs(command: click.Command) -> dict[str, str]:
    """Return the files that a call of `call` reads, by the option or argument that names them."""
    named = {"program": "p.nc", "job": "j.toml", "job_path": "j.toml", "file": "i.tbl", "template": "j.toml"}
    files = {}
    for param in command.params:
        if isinstance(param.type, InputPath):
            files[param.opts[-1]] = named.get(str(param.name), "i.txt")
        elif param.type.name == "PROFILE":
            files[param.opts[-1]] = "m.toml"
    return files


def call(names: tuple[str, ...], command: click.Command, output: str, path: str) -> list[str]:
    """Return a call that reads every file it may, gives what is required, and writes to `path` by one option."""
    words, files = list(names), inputs(command)
    for param in command.params:
        if isinstance(param.type, InputFolder):
            value = "sub"
        elif param.opts[-1] in files:
            value = files[param.opts[-1]]
        elif param.opts[-1] == output:
            value = path
        elif param.required:
            value = written_for(param)
        else:
            continue
        words += [value] if isinstance(param, click.Argument) else [f"{param.opts[-1]}={value}"]
    return words


def written_for(param: click.Parameter) -> str:
    if isinstance(param.type, click.Choice):
        return str(param.type.choices[0])
    if isinstance(param.type, OutputPath):
        return "another"
    return WORDS.get(param.type.name, "1")


def places(names: tuple[str, ...], command: click.Command, output: str, victim: Path) -> Iterator[tuple[str, Path]]:
    """Yield what the option is given, and the file that is written by that: each a name of `victim`."""
    param = next(param for param in command.params if param.opts[-1] == output)
    if isinstance(param.type, OutputFolder):
        for name in IN_FOLDERS[names]:
            for kind, link in (("hard", os.link), ("soft", os.symlink)):
                out = victim.parent / f"out {kind} {name}"
                out.mkdir()
                link(victim, out / name)
                yield out.name, out / name
        return
    os.link(victim, victim.with_name("hard" + victim.suffix))
    victim.with_name("soft" + victim.suffix).symlink_to(victim)
    for path in (victim.name, f"hard{victim.suffix}", f"soft{victim.suffix}", f"sub/../{victim.name}", str(victim)):
        yield path, victim


def content(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize(
    ("names", "output"), PAIRS, ids=lambda value: " ".join(value) if isinstance(value, tuple) else value
)
def test_no_output_of_any_verb_is_one_of_its_inputs(names: tuple[str, ...], output: str, folder: Path) -> None:
    command = WRITING[names]
    for number, victim in enumerate(sorted(set(inputs(command).values()))):
        most = None if number == 0 else 2  # names: all of the first, two of the others
        for given, _ in list(places(names, command, output, folder / victim))[:most]:
            before = content(folder)
            refused = CliRunner().invoke(group, [*call(names, command, output, given), "--overwrite"])
            assert_refused(refused, output, "would write over")
            assert content(folder) == before
        for path in folder.glob("hard*"):
            path.unlink()
        for path in folder.glob("soft*"):
            path.unlink()
        for path in folder.glob("out *"):
            shutil.rmtree(path)


def assert_refused(refused: Result, output: str, said: str) -> None:
    words = f"{refused.output}{refused.exception}"
    assert refused.exit_code in (1, 2) and said in words, words
    assert output in words, words


@pytest.mark.parametrize(
    ("names", "output"), PAIRS, ids=lambda value: " ".join(value) if isinstance(value, tuple) else value
)
def test_a_foreign_file_is_replaced_only_when_asked(names: tuple[str, ...], output: str, folder: Path) -> None:
    command, given = WRITING[names], "theirs.nc"
    (folder / given).write_bytes(b"G1 X1 (of another program)\n")
    if names in IN_FOLDERS:
        given = "theirs"
        (folder / given).mkdir()
        for name in IN_FOLDERS[names]:
            (folder / given / name).write_bytes(b"of another program\n")
    before = content(folder)
    refused = CliRunner().invoke(group, call(names, command, output, given))
    assert_refused(refused, output, "--overwrite")
    assert content(folder) == before


def test_what_a_job_names_and_what_a_program_calls_are_inputs(folder: Path) -> None:
    before = content(folder)
    base = ["check", "p.nc", "--machine", "table-a", "--job", "j.toml"]
    for words in (["--json", "outline.csv"], ["--json", "m.toml"], ["--certificate", "./outline.csv"]):
        refused = CliRunner().invoke(group, [*base, *words, "--overwrite"])
        assert_refused(refused, words[0], "a file that --job names")
    refused = CliRunner().invoke(
        group, ["convert", "p.nc", "--to", "grbl", "--search", "sub", "-o", "sub/sub.nc", "--overwrite"]
    )
    assert_refused(refused, "--out", "a subroutine that is called")
    assert content(folder) == before


def test_two_outputs_of_a_call_are_two_files(folder: Path) -> None:
    os.symlink(folder, folder / "here")
    words = ["check", "p.nc", "--machine", "table-a", "--json", "new.json", "--certificate", "here/new.json"]
    assert_refused(CliRunner().invoke(group, words), "--certificate", "--json")
    assert not (folder / "new.json").exists()


@pytest.mark.slow
def test_a_job_runs_into_its_own_old_results_without_a_word(folder: Path) -> None:
    job = folder / "placa.toml"
    text = (EXAMPLES / "jobs" / "brazil-engraving.toml").read_text("utf-8")
    text = text.replace("../brazil-outline.csv", "outline.csv").replace("../machines/table-a.toml", "m.toml")
    job.write_text(text.replace("[200, 200, 6]", "[30, 30, 6]"), "utf-8")
    for _ in range(2):
        done = CliRunner().invoke(group, ["run", str(job), "-o", "out"])
        assert done.exit_code == 0, done.output
    assert (folder / "out" / "program.nc").read_text("ascii").startswith("(made by CNCStepper: placa)\n")
    (folder / "out" / "program.nc").write_text("G1 X1 (typed by hand)\n", "ascii")
    assert_refused(CliRunner().invoke(group, ["run", str(job), "-o", "out"]), "--out", "--overwrite")
    assert (folder / "out" / "program.nc").read_text("ascii") == "G1 X1 (typed by hand)\n"
    assert CliRunner().invoke(group, ["run", str(job), "-o", "out", "--overwrite"]).exit_code == 0


OWN = [
    ("convert", "p.nc", "--dialect", "grbl", "--to", "linuxcnc", "-o", "again.ngc"),
    ("check", "p.nc", "--machine", "table-a", "--json", "again.json", "--certificate", "other.json"),
    ("steps", "p.nc", "--machine", "table-a", "--as", "csv", "-o", "again.csv"),
    ("steps", "p.nc", "--machine", "table-a", "--as", "vcd", "-o", "again.vcd"),
    ("steps", "p.nc", "--machine", "table-a", "--as", "parport", "-o", "again.csv"),
    ("steps", "p.nc", "--machine", "table-a", "--as", "coils", "-o", "again.csv"),
    ("restart", "p.nc", "--machine", "table-a", "--line", "6", "-o", "again.nc", "--certificate", "again.json"),
    ("simulate", "p.nc", "--stock", "20,20,5", "--tool", "flat:3", "-o", "a.png", "--stl", "a.stl", "--json", "a.json"),
    ("simulate", "p.nc", "--stock", "20,20,5", "--tool", "flat:3", "-o", "a.svg"),
    ("print", "p.nc", "-o", "again.pdf"),
    ("print", "p.nc", "-o", "again.html"),
]


@pytest.mark.parametrize("words", OWN, ids=" ".join)
def test_a_verb_replaces_what_it_has_written_itself(words: tuple[str, ...], folder: Path) -> None:
    (folder / "p.nc").write_text(
        "G21 G90 G94 G54\nM3 S9000\nG0 X1 Y1 Z1\nG1 X9 F600\nG1 Z-1\nG1 Y9\nG0 Z5\nM2\n", "ascii"
    )
    for _ in range(2):
        done = CliRunner().invoke(group, [*words])
        assert not isinstance(done.exception, OSError) and "--overwrite" not in done.output, done.output
    assert [path for path in folder.iterdir() if path.name.startswith(("again", "a."))], done.output


@pytest.mark.parametrize("ending", ["gif", "apng", "webp"])
def test_an_animation_is_known_again(ending: str, tmp_path: Path) -> None:
    from PIL import Image

    from CNCStepper.output_files import is_ours
    from CNCStepper.simulation.views.animation import _ImageWriter

    writer = _ImageWriter(fps=10)
    writer.outfile = str(tmp_path / f"a.{ending}")
    writer._frames = [Image.new("RGB", (8, 8), colour) for colour in ("red", "blue")]
    writer.finish()
    assert is_ours(Path(writer.outfile), "picture")
    with Image.open(writer.outfile) as read:
        assert read.n_frames == 2


def test_devices_take_every_output(folder: Path) -> None:
    for words in (["--json", os.devnull], ["--certificate", os.devnull, "--json", os.devnull]):
        done = CliRunner().invoke(group, ["check", "p.nc", "--machine", "table-a", *words])
        assert not isinstance(done.exception, OSError) and "would" not in done.output


def test_a_full_disk_leaves_nothing_and_the_sentence_names_the_file(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def full(descriptor: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    before = content(folder)
    monkeypatch.setattr(atomic_file.os, "fsync", full)
    words = ["convert", "p.nc", "--to", "grbl", "-o", "out.nc", "--search", "sub"]
    monkeypatch.setattr("sys.argv", ["cncstepper", *words])
    with pytest.raises(SystemExit) as end:
        main()
    assert end.value.code == 1 and content(folder) == before
    assert capsys.readouterr().err.splitlines()[-1] == "cncstepper: out.nc: No space left on device"


def test_the_sentence_names_the_file_and_the_option(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["cncstepper", "convert", "p.nc", "--to", "grbl", "-o", "p.nc"])
    with pytest.raises(SystemExit) as end:
        main()
    assert end.value.code == 1
    assert capsys.readouterr().err == (
        "cncstepper: p.nc: --out would write over the program that is read; give another name [output-is-input]\n"
    )
