# SPDX-License-Identifier: LGPL-2.1-or-later
"""Builds the illustrated manual in English and Portuguese: `make manual`.

    docs/user-guide, docs/reference, docs/manual, glossary ─┐
    the code: fields, commands, keys, options, refusals ────┴─► source/LANGUAGE ── Sphinx ──► build/manual/LANGUAGE

A page in Portuguese lies beside the English one as NAME.pt-BR.md; where there is none, the English page stands there
with a note. Of the reference, what tools/reference.py writes is written in the language. Pages that follow from the
code are written by the same functions as FreeCAD's help window and docs/reference. Both languages have the same files;
`manual.pdf` lies beside `index.html`.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tools")]

import reference  # noqa: E402
import refusal_codes  # noqa: E402
import translations  # noqa: E402

from CNCStepper import __version__  # noqa: E402
from CNCStepper.workbench.help import object_pages  # noqa: E402
from CNCStepper.workbench.help.machine_page import machine_page  # noqa: E402
from CNCStepper.workbench.help.object_tables import properties_of_type  # noqa: E402
from CNCStepper.workbench.help.topics import GUIDE_PAGES, OBJECT_TOPICS, SUFFIXES, slug  # noqa: E402

DOCS, REFERENCE = ROOT / "docs", ROOT / "docs" / "reference"
BUILD, ENVIRONMENT = ROOT / "build" / "manual", ROOT / ".cache" / "manual-env"
COMMANDS = ROOT / "CNCStepper" / "workbench" / "commands"
CATALOGUES = {"en": "", "pt_BR": "_pt-BR"}
WORDS = {"en": reference.ENGLISH, "pt_BR": reference.PORTUGUESE}  # of pages of the reference
REFERENCES = ("cli", "job-file", "shapes", "gcode", "dialects", "files", "ramps", "signals", "python")
PARTS = (
    "sign",
    "plate",
    "elliptical-pocket",
    "name-plate",
    "brazil-engraving",
    "gasket-plasma",
    "rib-wire",
    "lathe-shaft",
    "lathe-thread",
    "thesis-a",
)
TURNING_HEAD = """## Operações de um torno

`turn_rough`, `turn_bore` e `turn_finish` têm o nome de um `profile`, `turn_thread` pode ter. O [guia do
torneamento](../user-guide/turning.md) tem as outras tabelas de um trabalho de torno. Toda operação tem uma
`tool` e pode ter
"""
TABLE_WORDS = (  # what tools/reference.py writes between the texts of the code, and its Portuguese
    (r"^\| key \| value \| default \| \|$", "| chave | valor | padrão | |"),
    (r"^Shapes: `", "Formas: `"),
    (r"Moves what is drawn", "Move o que é desenhado"),
    (r"How the tool comes or leaves", "Como a ferramenta chega ou sai"),
    (r"Whether each line must end where it begins", "Se cada linha precisa terminar onde começa"),
    (r"How many holes along X; How many holes along Y", "Quantos furos ao longo de X; quantos ao longo de Y"),
    (re.escape(reference.TURNING_HEAD), TURNING_HEAD),
    (r"^The other keys are those of ", "As outras chaves são as de "),
    (r"(\| [-\d.e]+) to ([\d.]+(?: [\w/]+)?)", r"\1 a \2"),
    (r", or 0 \|", ", ou 0 |"),
    (r"\| a text \|", "| um texto |"),
    (r" \(with (`[^)]*`)\) \|$", r" (com \1) |"),
    (r"(\(com `[^)]*`) or (`)", r"\1 ou \2"),
)
LINK = re.compile(r"(?<!!)\[([^\]\n]+(?:\n[^\]\n]+)?)\]\(([^)\s]+)\)")
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)")
CODE_BLOCK = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
VALUE = re.compile(r"\{(\w*)[^{}]*\}")
NOT_TRANSLATED = "*Esta página ainda está em inglês.*"
TITLES = {
    "en": {
        "guides": "Guides",
        "fields": "Panels and their fields",
        "reference": "Reference",
        "commands": "Commands of the workbench",
        "commands_about": "The entries of toolbar and menu, with what each does.",
        "problems": "When something is refused",
        "code": "Refusals by their codes",
        "do": "What to do",
        "said": "The message itself has the reason and what to do.",
        "jobs": "The job files",
    },
    "pt_BR": {
        "guides": "Guias",
        "fields": "Painéis e seus campos",
        "reference": "Referência",
        "commands": "Comandos da bancada",
        "commands_about": "Os itens da barra e do menu, com o que cada um faz.",
        "problems": "Quando algo é recusado",
        "code": "Recusas pelos seus códigos",
        "do": "O que fazer",
        "said": "A própria mensagem traz o motivo e o que fazer.",
        "jobs": "Os arquivos de trabalho",
    },
}


class Catalogue:
    """The translations of a language; a text that it lacks stays English."""

    def __init__(self, language: str):
        self.language = language
        suffix = CATALOGUES[language]
        known = translations.read(translations.catalogue(suffix)) if suffix else {}
        self._by_context = {(text.context, text.source): said for text, said in known.items() if said}
        self._by_text = {text.source: said for text, said in known.items() if said}

    def tr(self, text: str) -> str:
        """Return a text of the window."""
        return self._by_context.get((translations.OURS, text)) or self._by_text.get(text, text)

    def core(self, text: str) -> str:
        """Return a sentence of the core."""
        return self._by_context.get((translations.CORE, text)) or self._by_text.get(text, text)

    def of_command(self, command: str, text: str) -> str:
        """Return a text of a command."""
        return self._by_context.get((command, text), text)


def pages(language: str, refusals: dict[str, refusal_codes.Refusal]) -> dict[str, str]:
    """Return all pages of a language by their paths, as Markdown."""
    said = Catalogue(language)
    found = {
        f"user-guide/{guide.file}": written_page(DOCS / "user-guide" / guide.file, language) for guide in GUIDE_PAGES
    }
    found["glossary.md"] = written_page(DOCS / "glossary.md", language)
    for name in REFERENCES:
        found[f"reference/{name}.md"] = reference_page(name, said)
    for topic in OBJECT_TOPICS:
        picture = f"../pictures/cycles/{topic.picture}.png" if topic.picture else ""
        entries, guide = properties_of_type(topic.type), f"../user-guide/{topic.guide}"
        found[f"objects/{topic.type}.md"] = object_pages.object_page(topic, entries, said.tr, picture, guide)
    found["machine-profile.md"] = machine_page(said.tr, "user-guide/machines.md")
    found["controller-codes.md"] = object_pages.codes_page(said.tr, said.core)
    found["commands.md"] = commands_page(said)
    found["manual/refusals.md"] = written_page(DOCS / "manual" / "refusals.md", language) + refusals_part(
        refusals, said
    )
    found["manual/worked-parts.md"] = written_page(DOCS / "manual" / "worked-parts.md", language) + job_files(language)
    index = (
        written_page(DOCS / "manual" / "index.md", language)
        .replace("](../", "](")
        .replace("](refusals", "](manual/refusals")
    )
    found["index.md"] = index + contents(language)
    return {path: whole_links(path, text, found) for path, text in found.items()}


def written_page(english: Path, language: str) -> str:
    """Return a page that a person has written; in English with a note where the language has none."""
    own = english.with_name(localized_name(english.name, language))
    text = (own if own.exists() else english).read_text("utf-8")
    if not own.exists():
        heading, _, rest = text.partition("\n")
        text = f"{heading}\n\n{NOT_TRANSLATED}\n{rest}"
    return text.replace(SUFFIXES["pt_BR"], ".md")


def reference_page(name: str, said: Catalogue) -> str:
    """Return a page of the reference; what follows from the code is in the language of the page."""
    words = WORDS[said.language]
    if name == "cli":
        return reference.cli_page(words)
    page = (
        reference.shapes_page(words, said.tr)
        if name == "shapes"
        else written_page(REFERENCE / f"{name}.md", said.language)
    )
    if said.language == "en":
        return page
    tables = translated_tables(reference.tables(), said.tr)
    return with_table_words(page.replace(reference.BEGIN, f"{reference.BEGIN}\n{tables}\n"))


def with_table_words(text: str) -> str:
    """Return a page whose tables, as tools/reference.py writes them, have Portuguese words for ranges and headings."""
    for words, said in TABLE_WORDS:
        text = re.sub(words, said, text, flags=re.MULTILINE)
    return text


def translated_tables(text: str, tr: Callable[[str], str]) -> str:
    """Return a page whose tables' last column is translated where the catalogue has it, also before " (with …"."""
    return "\n".join(translated_row(line, tr) if line.startswith("| ") else line for line in text.split("\n"))


def translated_row(line: str, tr: Callable[[str], str]) -> str:
    """Return a table's row with its last cell translated."""
    *cells, last, end = line.split("|")
    words, bracket, rest = last.strip().partition(" (with `")
    return "|".join([*cells, f" {tr(words)}{bracket}{rest} " if words else last, end])


def commands_page(said: Catalogue) -> str:
    """Return the page of the workbench's commands."""
    titles = TITLES[said.language]
    lines = [f"# {titles['commands']}", "", titles["commands_about"], ""]
    for name, menu_text, tooltip in commands():
        lines += [
            f"## {said.of_command(name, menu_text)}",
            "",
            f"{said.of_command(name, tooltip)}.",
            "",
            f"`{name}`",
            "",
        ]
    return "\n".join(lines)


def commands() -> Iterator[tuple[str, str, str]]:
    """Yield name, menu text and tooltip of every command, from their modules."""
    from CNCStepper.workbench.services.command import Command

    for path in sorted(COMMANDS.glob("*.py")):
        __import__(f"CNCStepper.workbench.commands.{path.stem}".removesuffix(".__init__"))
    waiting, found = list(Command.__subclasses__()), dict[str, type[Command]]()
    while waiting:
        kind = waiting.pop()
        waiting += kind.__subclasses__()
        if kind.name:
            found[kind.name] = kind
    yield from ((name, kind.menu_text, kind.tooltip) for name, kind in sorted(found.items()))


def refusals_part(refusals: dict[str, refusal_codes.Refusal], said: Catalogue) -> str:
    """Return a section for each code: what is said, and what to do."""
    titles = TITLES[said.language]
    lines = ["", f"## {titles['code']}", ""]
    for code, refusal in refusals.items():
        lines += [f"### {code}", ""]
        for what, advice in refusal.sayings:
            todo = f"{titles['do']}: {sentence(advice, said)}" if advice else ""
            words = " ".join(filter(None, (sentence(what, said), f"*{todo}*" if todo else "")))
            lines.append(f"- {words or titles['said']}")
        lines.append("")
    return "\n".join(lines)


def sentence(template: str, said: Catalogue) -> str:
    """Return a template as a sentence, its values as ‹name›."""
    text = object_pages.escaped(VALUE.sub("‹…›", said.core(template))).strip()
    return f"{text[:1].upper()}{text[1:]}." if text else ""


def job_files(language: str) -> str:
    """Return a section with the job files of the worked parts, each with its heading."""
    lines = ["", f"## {TITLES[language]['jobs']}", ""]
    for name in PARTS:
        path = ROOT / "examples" / "jobs" / f"{name}.toml"
        lines += [
            f"### {path.name}",
            "",
            "```toml",
            path.read_text("utf-8").rstrip(),
            "```",
            "",
        ]
    return "\n".join(lines)


def contents(language: str) -> str:
    """Return the trees of contents of the first page."""
    titles = TITLES[language]
    trees = {
        titles["guides"]: [f"user-guide/{guide.file}" for guide in GUIDE_PAGES] + ["manual/worked-parts.md"],
        titles["problems"]: ["manual/refusals.md", "controller-codes.md"],
        titles["fields"]: [
            *(f"objects/{topic.type}.md" for topic in OBJECT_TOPICS),
            "machine-profile.md",
            "commands.md",
        ],
        titles["reference"]: [*(f"reference/{name}.md" for name in REFERENCES), "glossary.md"],
    }
    parts = [
        "\n".join(["```{toctree}", f":caption: {title}", ":maxdepth: 1", "", *entries, "```", ""])
        for title, entries in trees.items()
    ]
    return "\n" + "\n".join(parts)


def whole_links(path: str, text: str, pages: dict[str, str]) -> str:
    """Return a page whose links to what the manual has not are their words alone; code stays as it is."""
    kept: list[str] = []

    def keep(found: re.Match[str]) -> str:
        kept.append(found[0])
        return f"\0{len(kept) - 1}\0"

    text = LINK.sub(lambda found: whole_link(path, found, pages), CODE_BLOCK.sub(keep, text))
    return re.sub("\0(\\d+)\0", lambda found: kept[int(found[1])], text)


def whole_link(path: str, found: re.Match[str], pages: dict[str, str]) -> str:
    """Return a link: to a heading, to its page where that has no such heading, or its words where there is no page.

    A page in Portuguese has headings of its own: an English page that leads to one leads to the page.
    """
    words, target = found[1], found[2]
    file, _, heading = target.partition("#")
    if "://" in file:
        return found[0]
    page = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
    if page not in pages:
        return words
    if heading and heading not in headings(pages[page]):
        return f"[{words}]({file})" if file else words
    return found[0]


def headings(text: str) -> set[str]:
    """Return the names of a page's headings, as links have them."""
    lines = re.findall(r"^#+ (.+)$", CODE_BLOCK.sub("", text), re.MULTILINE)
    return {slug(re.sub(r"[*`\\]", "", LINK.sub(r"\1", line))) for line in lines}


def pictures(found: dict[str, str]) -> set[str]:
    """Return the files of the pictures that pages show, below docs."""
    named = ((path, target) for path, text in found.items() for target in PICTURE.findall(text))
    return {os.path.normpath(os.path.join(os.path.dirname(path), target)) for path, target in named}


def write_sources(language: str, found: dict[str, str]) -> Path:
    """Write the pages of a language with their pictures and Sphinx's settings, and return their folder."""
    folder = BUILD / "source" / language
    shutil.rmtree(folder, ignore_errors=True)
    for path, text in found.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, "utf-8", newline="\n")
    for picture in pictures(found):
        (folder / picture).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(DOCS / localized(picture, language), folder / picture)
    shutil.copyfile(DOCS / "manual" / "conf.py", folder / "conf.py")
    shutil.copytree(DOCS / "manual" / "_static", folder / "_static")
    return folder


def localized(picture: str, language: str) -> str:
    """Return the file of a picture in a language, where it has one of its own: NAME.pt-BR.png."""
    own = Path(picture).with_name(localized_name(Path(picture).name, language))
    return own.as_posix() if (DOCS / own).exists() else picture


def localized_name(name: str, language: str) -> str:
    """Return the name of a file that is in a language: NAME.pt-BR.png of NAME.png."""
    stem, dot, kind = name.rpartition(".")
    return stem + SUFFIXES[language].removesuffix(".md") + dot + kind


def build(language: str, source: Path) -> None:
    """Build HTML and PDF of a language."""
    target, single = BUILD / language, BUILD / "single" / language
    for builder, folder in (("html", target), ("singlehtml", single)):
        run_sphinx(language, source, builder, folder)
    weasyprint = ENVIRONMENT / "bin" / "weasyprint"
    subprocess.run([weasyprint, "-q", single / "index.html", target / "manual.pdf"], check=True)


def run_sphinx(language: str, source: Path, builder: str, folder: Path) -> None:
    """Build the pages of a language into a folder that is made anew; warnings of Sphinx are errors."""
    shutil.rmtree(folder, ignore_errors=True)
    variables = {"CNCSTEPPER_MANUAL_LANGUAGE": language, "CNCSTEPPER_MANUAL_VERSION": __version__}
    command = [ENVIRONMENT / "bin" / "python", "-m", "sphinx", "-q", "-W", "--keep-going", "-b", builder]
    doctrees = BUILD / "doctrees" / language
    subprocess.run([*command, source, folder, "-d", doctrees], check=True, env=os.environ | variables)


def main() -> None:
    """Build the manual in all languages, or only its pages with --pages."""
    refusals = refusal_codes.refusals()
    for language in CATALOGUES:
        source = write_sources(language, pages(language, refusals))
        if "--pages" not in sys.argv:
            build(language, source)
            print(f"manual: build/manual/{language}/index.html and manual.pdf")


if __name__ == "__main__":
    main()
