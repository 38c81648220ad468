# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings the catalogues of translations up to date with the source: `make translations`.

It reads the source, finds every text that a person sees, and writes resources/translations: new texts come in as
unfinished, those that nothing shows any more go. Qt's own lrelease then compiles what FreeCAD loads. Nothing is run but
the tables of properties, for the texts that the fields of the cycles declare (CNCStepper/cycles/parameter.py).

Where a text belongs (its context) is where FreeCAD or we look it up:
    CNCStepper       `tr("…")` and `later("…")`
    App::Property    names, groups and texts of properties, for FreeCAD's property editor
    a command's name and Workbench: `QT_TRANSLATE_NOOP("context", "…")`
    CNCStepper cli   help and texts of the command line (command_line_texts.py); Python's gettext looks these and the
                     core's up, in a catalogue that is derived here
    CNCStepper core  sentences of errors and findings; of one with values, `Text("… {key} …", key=…)`, the template
"""

from __future__ import annotations

import argparse
import ast
import importlib
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

ROOT = Path(__file__).resolve().parents[1]
DEBIAN_QT = "/usr/lib/qt5/bin"
FOLDER = ROOT / "resources" / "translations"
LANGUAGES = {"": "en", "_pt-BR": "pt_BR"}
OURS, PROPERTY, CORE, CLI = "CNCStepper", "App::Property", "CNCStepper core", "CNCStepper cli"
CORE_ROOMS = (
    "gcode",
    "geometry",
    "drawing",
    "cycles",
    "nesting",
    "machine",
    "job",
    "recovery",
    "simulation",
    "control",
    "controllers",
    "workers",
    "workbench",
)
CORE_MODULES = (
    "errors.py",
    "input_file.py",
    "output_files.py",
    "quantities.py",
    "atomic_file.py",
    "motion/signals/letter_track.py",
    "motion/signals/step_letters.py",
    "virtual/faults/host_faults.py",
    "virtual/server/pin_presses.py",
)
NO_SENTENCES = {
    "picture.py",
    "picture_style.py",
    "drawing_picture.py",
    "comparison_picture.py",
    "turned_picture.py",
    "svg_writer.py",
    "readings_plot.py",
    "path_commands.py",
    "message_translation.py",
    "macro_recorder.py",
}  # labels in pictures; what puts these together; lines of Python
DECLARATIONS = re.compile(r"/(cycles/(.*_parameters|parameter)|job/shape_forms/text_parameters)\.py$")
MARKED = {"tr", "later", "QT_TRANSLATE_NOOP"}
# lines of grbl, code, styles, names, pieces, and the calls of `gcode/interpreter/canonical_trace.py`
NO_SENTENCE = re.compile(
    r"^\[[A-Z]+:|^import |^Grbl |[\n|\\]|\{ |px|: \{0\};|^User parameter|^\*\.|^\s|^, |\s$|^[A-Z][A-Z0-9_]+\("
)
SHOWN_BY = {
    "setText", "setToolTip", "setWindowTitle", "setTitle", "setPlaceholderText", "setStatusTip", "setWhatsThis",
    "setSuffix", "setPrefix", "setInformativeText", "setDetailedText", "setLabelText", "setSpecialValueText",
    "addItem", "addItems", "insertItem", "addTab", "addRow", "addAction", "addMenu", "showMessage", "setTabText",
    "setHeaderLabels", "setHorizontalHeaderLabels", "addButton", "setFormat", "undo_step", "QLabel",
    "QPushButton", "QToolButton", "QCheckBox", "QRadioButton", "QGroupBox", "QAction", "QMenu", "QDockWidget",
}  # fmt: skip
FIELD = re.compile(r"\{[^{}]*\}")
LETTERS = re.compile(r"[^\W\d_]{2,}")
WORD = re.compile(r"[^\W\d_]{3,}")
SAME_EVERYWHERE = {"CNCStepper", "grbl", "rpm"}


@dataclass(frozen=True, order=True)
class Text:
    """A text as it stands in the source."""

    context: str
    source: str


def sources() -> list[Path]:
    """Return the files that may show a text."""
    return [*sorted((ROOT / "CNCStepper" / "workbench").rglob("*.py")), ROOT / "InitGui.py"]


def core_sources() -> list[Path]:
    """Return the files of the core whose sentences the window may show."""
    rooms = (sorted((ROOT / "CNCStepper" / room).rglob("*.py")) for room in CORE_ROOMS)
    paths = [*(path for room in rooms for path in room), *(ROOT / "CNCStepper" / name for name in CORE_MODULES)]
    return [path for path in paths if path.name not in NO_SENTENCES and not DECLARATIONS.search(path.as_posix())]


def texts() -> dict[Text, str]:
    """Return every text that a person sees, with the place where it stands first."""
    found: dict[Text, str] = {}
    for path in sources():
        for text, line in texts_of(path.read_text("utf-8"), in_features="features" in path.parts):
            found.setdefault(text, f"{path.relative_to(ROOT).as_posix()}:{line}")
    for path in core_sources():
        for sentence, line in sentences_of(path.read_text("utf-8")):
            found.setdefault(Text(CORE, sentence), f"{path.relative_to(ROOT).as_posix()}:{line}")
    for sentence, place in refusal_sentences():
        found.setdefault(Text(CORE, sentence), place)
    for text, cycle in declared_texts():
        found.setdefault(text, f"parameters of {cycle}")
    for text, kind in library_texts():
        found.setdefault(text, f"the shape {kind}")
    for sentence, place in command_line_texts().texts_of_command_line():
        found.setdefault(Text(CLI, sentence), place)
    return found


def refusal_sentences() -> Iterator[tuple[str, str]]:
    """Yield all that refusals say and advise, of every room and however short, with a place of each."""
    for refusal in beside("refusal_codes").refusals().values():
        for sentence in (part for saying in refusal.sayings for part in saying):
            if " " in sentence and LETTERS.search(FIELD.sub("", sentence)):
                yield sentence, refusal.places[0]


def command_line_texts() -> ModuleType:
    """Return the module that knows the command line."""
    return beside("command_line_texts")


def beside(name: str) -> ModuleType:
    """Return a module of this folder, also where this one is no script."""
    sys.path.append(str(ROOT / "tools"))
    return importlib.import_module(name)


def of_command_line(translations: dict[Text, str]) -> dict[str, str]:
    """Return the translations that the command line looks up: those of the core, its own before them."""
    return {
        text.source: said for context in (CORE, CLI) for text, said in translations.items() if text.context == context
    }


def declared_texts() -> Iterator[tuple[Text, str]]:
    """Yield the texts of all properties that follow from declarations, and the type of the object."""
    sys.path.append(str(ROOT))
    from CNCStepper.workbench.features.catalogue import KINDS
    from CNCStepper.workbench.features.drawings.text import Text as TextObject
    from CNCStepper.workbench.features.turning.turning_operation import TURNING_KINDS

    for kind in (*KINDS, *TURNING_KINDS, TextObject):
        for entry in kind.PROPERTIES:
            shown = {entry.group, entry.label, entry.text}
            yield from ((Text(context, text), kind.Type) for context in (OURS, PROPERTY) for text in sorted(shown))
            yield Text(PROPERTY, spaced(entry.name)), kind.Type


def library_texts() -> Iterator[tuple[Text, str]]:
    """Yield the texts of the library of basic shapes, and the name of the shape."""
    sys.path.append(str(ROOT))
    from CNCStepper.drawing.shape_library.shape_families import FAMILIES, shapes_of

    for title in FAMILIES:
        yield Text(OURS, title), title
        for shape in shapes_of(title):
            dimensions = [dimension.title for dimension in shape.dimensions.values()]
            yield from ((Text(OURS, text), shape.kind) for text in (shape.title, shape.about, *dimensions))


def sentences_of(source: str) -> Iterator[tuple[str, int]]:
    """Yield the strings of a module that read as a sentence, and their lines."""
    passed: set[int] = set()
    for node in ast.walk(ast.parse(source)):  # what holds a string comes before it
        passed.update(map(id, no_sentences_in(node)))
        if isinstance(node, ast.Call) and called(node) == "Text" and node.args and literal(node.args[0]) is not None:
            passed.add(id(node.args[0]))
            if LETTERS.search(FIELD.sub("", str(literal(node.args[0])))):
                yield str(literal(node.args[0])), node.lineno
        sentence = template(node) if isinstance(node, ast.expr) and id(node) not in passed else ""
        if len(LETTERS.findall(FIELD.sub("", sentence))) > 1 and not NO_SENTENCE.search(sentence):
            yield sentence, node.lineno


def no_sentences_in(node: ast.AST) -> list[ast.AST]:
    """Return the parts of a node that are no sentence by themselves: docstrings, pieces of strings, marked texts."""
    if isinstance(node, ast.Expr):
        return [node.value]
    if isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Call) and called(node) in MARKED):
        return list(ast.walk(node))[1:]
    return []


def template(node: ast.expr) -> str:
    """Return a string of the source, {0} and so on for its values; "" for anything else and for a single word."""
    if isinstance(node, ast.JoinedStr):
        numbers = iter(range(len(node.values)))
        text = "".join(literal(part) or f"{{{next(numbers)}}}" for part in node.values)
    else:
        text = literal(node) or ""
    return text if " " in text.strip() else ""


def texts_of(source: str, in_features: bool = False) -> Iterator[tuple[Text, int]]:
    """Yield the marked texts of a module with their lines; what `features` marks the property editor shows as well."""
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.Call):
            continue
        name, literals = called(node), [literal(argument) for argument in node.args]
        if name in ("tr", "later") and literals and literals[0] is not None:
            yield Text(OURS, literals[0]), node.lineno
            if in_features and name == "later":
                yield Text(PROPERTY, literals[0]), node.lineno
        elif name == "QT_TRANSLATE_NOOP" and len(literals) == 2 and None not in literals:
            yield Text(str(literals[0]), str(literals[1])), node.lineno
        elif name == "Property" and in_features and len(literals) > 1 and literals[1] is not None:
            yield Text(PROPERTY, spaced(literals[1])), node.lineno


def faults() -> list[str]:
    """Return every place where a text would be shown that no catalogue can hold."""
    return [
        f"{path.relative_to(ROOT).as_posix()}:{line}: {fault}"
        for path in sources()
        for line, fault in faults_of(path.read_text("utf-8"))
    ]


def faults_of(source: str) -> Iterator[tuple[int, str]]:
    """Yield lines at which a text is put together before it is translated, or shown without being translated."""
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.Call):
            continue
        name = called(node)
        if name == "tr" and not all(map(translatable, alternatives(node.args[:1]))):
            yield node.lineno, f"tr() of {ast.unparse(node.args[0])}: give it the text itself, format afterwards"
        elif name in ("later", "QT_TRANSLATE_NOOP"):
            if any(literal(argument) is None for argument in node.args):
                yield node.lineno, f"{name}() marks only texts that stand there"
        elif name in SHOWN_BY:
            for shown in filter(None, map(untranslated, shown_arguments(node))):
                yield node.lineno, f"{name}() shows {shown!r} without tr()"


def called(node: ast.Call) -> str:
    """Return the last name of what is called."""
    return ast.unparse(node.func).rpartition(".")[2]


def literal(node: ast.expr) -> str | None:
    """Return the string that stands there, None when it is anything else."""
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def translatable(node: ast.expr) -> bool:
    """Return whether tr() can look a text up: it stands there, or comes as it is from a table that marks it."""
    return literal(node) is not None or isinstance(node, ast.Name | ast.Attribute | ast.Subscript)


def shown_arguments(node: ast.Call) -> Iterator[ast.expr]:
    """Yield what a call that shows texts is given."""
    named = [keyword.value for keyword in node.keywords if keyword.arg in ("text", "title")]
    yield from alternatives([*node.args, *named])


def alternatives(nodes: Iterable[ast.expr]) -> Iterator[ast.expr]:
    """Yield expressions, for a list its members, for a choice all that may come out of it."""
    for node in nodes:
        if isinstance(node, ast.List | ast.Tuple):
            yield from alternatives(node.elts)
        elif isinstance(node, ast.IfExp):
            yield from alternatives([node.body, node.orelse])
        elif isinstance(node, ast.BoolOp):
            yield from alternatives(node.values)
        else:
            yield node


def untranslated(node: ast.expr) -> str:
    """Return the words in a string that stands there, "" when there are none that differ between languages."""
    parts = node.values if isinstance(node, ast.JoinedStr) else [node]
    words = WORD.findall(re.sub(r"<[^>]*>|CNCStepper_\w+", "", " ".join(filter(None, map(literal, parts)))))
    return " ".join(word for word in words if word not in SAME_EVERYWHERE)


def spaced(name: str) -> str:
    """Return a property's name as FreeCAD's property editor looks it up: "StockSize" as "Stock Size"."""
    return re.sub(r"(?<=[^A-Z ])(?=[A-Z])", " ", name)


def catalogue(suffix: str) -> Path:
    """Return the file of a language: "" is English, "_pt-BR" Portuguese of Brazil."""
    return FOLDER / f"CNCStepper{suffix}.ts"


def read(path: Path) -> dict[Text, str]:
    """Return a catalogue's translations; an unfinished one is "". An empty one where there is no file."""
    if not path.exists():
        return {}
    return {
        Text(str(context.findtext("name")), str(message.findtext("source"))): translation_of(message)
        for context in ET.parse(path).getroot().iter("context")
        for message in context.iter("message")
    }


def translation_of(message: ET.Element) -> str:
    """Return a message's finished translation, or ""."""
    translation = message.find("translation")
    finished = translation is not None and translation.get("type") is None
    return (translation.text or "") if finished and translation is not None else ""


def merged(wanted: dict[Text, str], known: dict[Text, str]) -> dict[Text, str]:
    """Return the translations of the wanted texts; a new one is taken from the same text in another context."""
    by_source = {text.source: translation for text, translation in known.items() if translation}
    return {text: known.get(text) or by_source.get(text.source, "") for text in sorted(wanted)}


def write(path: Path, language: str, translations: dict[Text, str]) -> None:
    """Write a catalogue as Qt Linguist writes it."""
    root = ET.Element("TS", version="2.1", language=language, sourcelanguage="en")
    for name in sorted({text.context for text in translations}):
        context = ET.SubElement(root, "context")
        ET.SubElement(context, "name").text = name
        for text, translated in translations.items():
            if text.context == name:
                message = ET.SubElement(context, "message")
                ET.SubElement(message, "source").text = text.source
                translation = ET.SubElement(message, "translation")
                translation.text = translated or None
                if not translated:
                    translation.set("type", "unfinished")
    ET.indent(root, "    ")
    body = ET.tostring(root, "unicode", short_empty_elements=False)
    path.write_text(f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{body}\n', "utf-8", newline="\n")


def update() -> int:
    """Bring all catalogues up to date, compile them, and return how many texts wait for a translation."""
    wanted = texts()
    waiting = 0
    for suffix, language in LANGUAGES.items():
        path = catalogue(suffix)
        translations = merged(wanted, read(path)) if suffix else dict.fromkeys(sorted(wanted), "")
        write(path, language, translations)
        if suffix:
            waiting += sum(not translation for translation in translations.values())
            compile_(path)
            write_command_line(translations)
    return waiting


def write_command_line(translations: dict[Text, str]) -> None:
    """Write the catalogue of the command line."""
    module = command_line_texts()
    module.CATALOGUE.parent.mkdir(parents=True, exist_ok=True)
    module.CATALOGUE.write_bytes(module.catalogue_bytes(of_command_line(translations)))


def compile_(path: Path) -> None:
    """Compile a catalogue for Qt, beside it."""
    lrelease = shutil.which("lrelease", path=os.pathsep.join([DEBIAN_QT, os.environ["PATH"]]))
    if lrelease is None:
        sys.exit("Qt's lrelease is missing: run 'make translations', which gets it")
    subprocess.run([lrelease, "-silent", str(path), "-qm", str(path.with_suffix(".qm"))], check=True)


def main() -> int:
    """Update the catalogues; the exit status tells whether nothing is left to translate."""
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    for fault in faults():
        print(fault)
    waiting = update()
    print(f"{len(texts())} texts, {waiting} wait for a translation")
    return bool(waiting or faults())


if __name__ == "__main__":
    sys.exit(main())
