# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line speaks the language of the locale; what a program reads stays as it is."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from pathlib import Path

import click
import pytest

from CNCStepper.cli.common import language
from CNCStepper.cli.common.language import OF_LOCALE, OVERRIDE, in_language, look_up, translated
from CNCStepper.cli.main import FAMILY_OF, group
from CNCStepper.errors import OutputError, ProgramError, Text
from CNCStepper.output_files import Output, check_outputs
from helpers.tools import load

ROOT = Path(__file__).parents[4]
PORTUGUESE = {OVERRIDE: "", "LANGUAGE": "", "LC_ALL": "", "LC_MESSAGES": "", "LANG": "pt_BR.UTF-8"}
CATALOGUES = load("translations")
TEXTS = CATALOGUES.command_line_texts()
OF_DEVELOPERS = {  # click says these of a command line that is declared wrong, or where it edits, which none does
    "{editor}: Editing failed",
    "Windows error: {error}",
    "deprecated",
    "DeprecationWarning",
    "Value must be an iterable.",
    "Could not determine name",
    "No options defined",
    "env var: {var}",
    "Arguments take exactly",
    "(dynamic)",
    "Name '{name}' defined twice",
    "Boolean option",
    "Confirm the action",
    "%(prog)s, version",
    "Missing {param_type}",
    "Invalid start character",
    "Couldn't detect Bash",
    "Shell completion",
    "Press any key",
    "Repeat for confirmation",
    "Error: The two entered",
    "Unknown color",
    "Choice({choices})",
    "{value!r} does not match",
    "{len_type} values",
    "{value!r} is not a valid UUID",
    "{name} {filename!r} is not executable",
    "Unknown standard stream",
    "d",
}


@pytest.fixture
def portuguese(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in PORTUGUESE.items():
        monkeypatch.setenv(name, value)


def test_the_catalogue_is_derived_from_that_of_the_window() -> None:
    translations = CATALOGUES.read(CATALOGUES.catalogue("_pt-BR"))
    assert TEXTS.CATALOGUE.read_bytes() == TEXTS.catalogue_bytes(CATALOGUES.of_command_line(translations)), (
        "run 'make translations'"
    )


@pytest.mark.slow
def test_every_text_of_every_help_and_every_refusal_is_portuguese() -> None:
    """The texts of the core are the templates of refusals and findings; test_translations holds that they are all."""
    translations = CATALOGUES.of_command_line(CATALOGUES.read(CATALOGUES.catalogue("_pt-BR")))
    core = {text.source for text in CATALOGUES.read(CATALOGUES.catalogue("")) if text.context == CATALOGUES.CORE}
    wanted = core | {text for text, _ in TEXTS.texts_of_command_line()}
    assert len(wanted) > 4000
    assert sorted(text for text in wanted if not translations.get(text)) == []


@pytest.mark.slow
@pytest.mark.parametrize("verb", FAMILY_OF)
def test_no_sentence_of_a_help_stays_english(verb: str, monkeypatch: pytest.MonkeyPatch) -> None:
    english, native = helps(verb), []
    with monkeypatch.context() as patch:
        for name, value in PORTUGUESE.items():
            patch.setenv(name, value)
        native = helps(verb)
    same = [text for text, other in zip(english, native, strict=True) if text == other]
    assert english and [text for text in same if len(text.split()) > 2 and not text.startswith("\b")] == []


def helps(verb: str) -> list[str]:
    command = group.get_command(click.Context(group), verb)
    assert command is not None
    return [text for each in TEXTS.commands_of(command) for text in TEXTS.helps_of(each)]


def test_no_verb_refuses_prints_or_asks_with_words_that_no_catalogue_holds() -> None:
    found = [
        f"{path.relative_to(ROOT)}:{line}: {words}"
        for path in sorted(TEXTS.VERBS.rglob("*.py"))
        for line, words in TEXTS.unmarked(path.read_text("utf-8"))
    ]
    assert found == [], "give the words as Text(template, key=value)"
    assert list(TEXTS.unmarked('raise click.UsageError(f"no {way}")')) == [(1, "f'no {way}'")]
    assert list(TEXTS.unmarked('click.echo(f"nothing {way}" if way else "none is open")')) == [
        (1, "nothing {0}"),
        (1, "none is open"),
    ]
    assert list(TEXTS.unmarked('click.echo(f"{x:.3f} mm")\nclick.echo(told["text"] or join("all of it"))')) == []


def test_what_click_says_is_in_the_catalogue() -> None:
    known = {*TEXTS.OF_CLICK, *TEXTS.PLURALS_OF_CLICK, *TEXTS.PLURALS_OF_CLICK.values()}
    said = {
        argument.value
        for path in Path(click.__file__).parent.glob("*.py")
        for call in TEXTS.calls(path.read_text("utf-8"))
        if TEXTS.called(call) in ("_", "ngettext")
        for argument in call.args
        if isinstance(argument, ast.Constant)
    }
    assert [text for text in sorted(said - known) if not text.startswith(tuple(OF_DEVELOPERS))] == []


@pytest.mark.parametrize(
    ("variables", "english"),
    [
        ({"LANG": "pt_BR.UTF-8"}, False),
        ({"LANG": "pt_PT"}, False),
        ({"LC_MESSAGES": "pt_BR.UTF-8", "LANG": "C"}, False),
        ({"LC_ALL": "pt_BR.UTF-8", "LANG": "en_US.UTF-8"}, False),
        ({"LC_ALL": "C", "LANG": "pt_BR.UTF-8"}, True),
        ({"LANG": "C.UTF-8"}, True),
        ({"LANG": "de_DE.UTF-8"}, True),
        ({}, True),
        ({OVERRIDE: "pt", "LANG": "C"}, False),
        ({OVERRIDE: "en", "LANG": "pt_BR.UTF-8", "LC_ALL": "pt_BR.UTF-8"}, True),
    ],
)
def test_the_locale_chooses_and_our_variable_overrides_it(
    variables: dict[str, str], english: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in (OVERRIDE, *OF_LOCALE):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert language.is_english() == english
    assert look_up("Calculate") == ("Calculate" if english else "Calcular")


def test_windows_gives_the_language_of_its_interface(monkeypatch: pytest.MonkeyPatch) -> None:
    import ctypes
    from types import SimpleNamespace

    monkeypatch.setattr(sys, "platform", "win32")
    kernel = SimpleNamespace(GetUserDefaultUILanguage=lambda: 0x0416)
    monkeypatch.setattr(ctypes, "windll", SimpleNamespace(kernel32=kernel), raising=False)
    for name in (OVERRIDE, *OF_LOCALE):
        monkeypatch.delenv(name, raising=False)
    assert look_up("Calculate") == "Calcular"
    monkeypatch.setenv("LANG", "C")
    assert look_up("Calculate") == "Calculate"


def test_a_refusal_keeps_its_values_and_its_code(portuguese: None) -> None:
    error = ProgramError("tool-length", Text("{package} is not installed", package="numba"), value="3 mm")
    assert translated(error.text) == "numba não está instalado (valor 3 mm) [tool-length]"


def test_refusals_of_files_are_portuguese_with_their_values(portuguese: None, tmp_path: Path) -> None:
    file = tmp_path / "part.nc"
    file.write_text("something of a person's own", "utf-8")
    with pytest.raises(OutputError) as refused:
        check_outputs([Output(file, "--out", "program")], [])
    assert "--out substituiria um arquivo de outro tipo" in translated(refused.value.text)
    assert translated(refused.value.advice) == "dê outro nome, ou --overwrite para substituí-lo"


def test_the_commands_themselves_stay_as_they_are(portuguese: None) -> None:
    assert group.help == "From a drawing to a cut part on stepper-driven machines."
    assert in_language(group).help == "Do desenho à peça cortada em máquinas com motores de passo."
    assert group.help.startswith("From")


def said(words: list[str], variables: dict[str, str]) -> tuple[int, str, str]:
    done = subprocess.run(
        [sys.executable, "-m", "CNCStepper.cli", *words],
        capture_output=True,
        encoding="utf-8",
        env={**os.environ, **variables, "PYTHONIOENCODING": "utf-8"},
    )
    return done.returncode, done.stdout, done.stderr


@pytest.mark.slow
def test_figures_reports_programs_and_exit_codes_are_the_same_in_every_locale(tmp_path: Path) -> None:
    program = tmp_path / "far.nc"
    program.write_text("G21 G90\nG0 X0 Y0 Z5\nG1 X9000 F600\nM2\n", encoding="ascii")
    words = ["check", str(program), "--machine", "table-a", "--work-zero", "0,0,0", "--json"]
    english = said([*words, str(tmp_path / "en.json")], {})
    native = said([*words, str(tmp_path / "pt.json")], PORTUGUESE)
    assert english[0] == native[0] == 1
    assert (tmp_path / "en.json").read_bytes() == (tmp_path / "pt.json").read_bytes()
    begins = [
        [line.rsplit(" [", 1)[-1] for line in out.splitlines() if ": error: " in line]
        for _, out, _ in (english, native)
    ]
    assert begins[0] and begins[0] == begins[1]
    assert "refused" in english[1] and "recusado" in native[1] and "refused" not in native[1]


@pytest.mark.slow
def test_click_and_our_refusals_speak_portuguese(tmp_path: Path) -> None:
    code, _, error = said(["simulate", "--stock"], PORTUGUESE)
    assert (code, error.splitlines()[-1]) == (2, "Erro: A opção '--stock' precisa de um argumento.")
    job = tmp_path / "none.toml"
    job.write_text("", encoding="ascii")
    code, _, error = said(["run", str(job), "--out", str(tmp_path / "out")], PORTUGUESE)
    assert code == 1 and error.startswith("cncstepper: ") and " falta" in error
