# SPDX-License-Identifier: LGPL-2.1-or-later
"""The codes of all refusals, with what each says and what to do: read from the source, for the manual.

An error is raised as `JobError("code", "what", advice="what to do")`, or by a function that hands its own parameters on
to one: then the calls of that function count. Codes that are put together, such as "grbl-error-20", have pages of their
own and are named by their beginning here.
"""

from __future__ import annotations

import ast
import functools
import re
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tools"))

import translations  # noqa: E402

FINDING = "Finding"  # of a check
ROOT_ERROR = "CNCStepperError"
NAMED_FIRST = "MissingPackage"  # whose code begins with a package's name
CODE = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
HANDED_ON = 3  # so many functions may hand a code on to each other
SELF = ("self", "cls")


@dataclass
class Refusal:
    """A code; sayings: each sentence with its advice ("" for none), as templates.

    places: where it is raised; direct: whether an error itself has the code in one of them.
    """

    code: str
    sayings: dict[tuple[str, str], None] = field(default_factory=dict)
    places: list[str] = field(default_factory=list)
    direct: bool = False


@dataclass(frozen=True)
class Carrier:
    """A function that hands parameters on to an error: the position and the name of each, -1 for a fixed one."""

    name: str
    code: tuple[int, str]
    what: tuple[int, str] | str
    advice: tuple[int, str] | str


@dataclass(frozen=True)
class Source:
    """A module: its path, its calls by name, each with the function around it, its constants, its classes."""

    path: str
    calls: dict[str, list[tuple[ast.Call, ast.FunctionDef | None]]]
    constants: dict[str, ast.expr]
    classes: dict[str, set[str]]


def sources(folder: Path = ROOT / "CNCStepper") -> list[Source]:
    """Return the modules of the package."""
    return [source_of(path) for path in sorted(folder.rglob("*.py"))]


def source_of(path: Path) -> Source:
    """Return a module."""
    tree = ast.parse(path.read_text("utf-8"))
    constants = {
        name: value
        for node in tree.body
        if isinstance(node, ast.Assign)
        for target in node.targets
        for name, value in pairs(target, node.value)
    }
    calls: dict[str, list[tuple[ast.Call, ast.FunctionDef | None]]] = defaultdict(list)
    for call, around in calls_in(tree):
        calls[last_name(call)].append((call, around))
    classes = {node.name: base_names(node) for node in ast.walk(tree) if isinstance(node, ast.ClassDef)}
    return Source(path.relative_to(ROOT).as_posix(), calls, constants, classes)


def base_names(node: ast.ClassDef) -> set[str]:
    """Return the names of the classes that a class derives from, without their modules."""
    return {base.id if isinstance(base, ast.Name) else getattr(base, "attr", "") for base in node.bases}


def last_name(call: ast.Call) -> str:
    """Return the last name of what is called, "" where it has none."""
    function = call.func
    return function.id if isinstance(function, ast.Name) else getattr(function, "attr", "")


def calls_in(tree: ast.AST) -> Iterator[tuple[ast.Call, ast.FunctionDef | None]]:
    """Yield the calls of a module in the order of its text, each with the function around it."""
    waiting: list[tuple[ast.AST, ast.FunctionDef | None]] = [(tree, None)]
    while waiting:
        node, around = waiting.pop()
        if isinstance(node, ast.Call):
            yield node, around
        inside = node if isinstance(node, ast.FunctionDef) else around
        waiting.extend((child, inside) for child in reversed(list(ast.iter_child_nodes(node))))


def error_classes(modules: Iterable[Source]) -> set[str]:
    """Return the names of the classes of our errors, wherever they are declared."""
    bases = {name: of for module in modules for name, of in module.classes.items()}
    found = {ROOT_ERROR}
    while more := {name for name, of in bases.items() if of & found} - found:
        found |= more
    return found - {NAMED_FIRST}


def is_telling(refusal: Refusal) -> bool:
    """Return whether what was found is a code for certain: it has two words, or says something."""
    return "-" in refusal.code or any(map(any, refusal.sayings))


class Reader:
    """Collects the refusals of modules."""

    def __init__(self, modules: Iterable[Source], classes: set[str]):
        self.modules, self.classes = list(modules), classes
        self.found: dict[str, Refusal] = {}
        self.put_together: set[str] = set()
        everywhere: dict[str, list[ast.expr]] = defaultdict(list)
        for module in self.modules:
            for name, value in module.constants.items():
                everywhere[name].append(value)
        self._everywhere = {name: values[0] for name, values in everywhere.items() if len(values) == 1}

    def read(self) -> dict[str, Refusal]:
        """Return the refusals by code."""
        waiting = {Carrier(name, (0, "code"), (1, "what"), (-1, "advice")) for name in self.classes}
        waiting.add(Carrier(FINDING, (1, "code"), (3, "text"), (4, "advice")))
        done = set[Carrier]()
        for _ in range(HANDED_ON):
            done |= waiting
            waiting = {handed for carrier in waiting for handed in self._pass(carrier)} - done
        return {code: one for code, one in sorted(self.found.items()) if one.direct or is_telling(one)}

    def _pass(self, carrier: Carrier) -> Iterator[Carrier]:
        """Take all calls of a carrier; yield the functions that hand their own parameters to it."""
        for module in self.modules:
            for call, around in module.calls.get(carrier.name, ()):
                if handed := self._take(module, call, around, carrier):
                    yield handed

    def _take(self, module: Source, call: ast.Call, around: ast.FunctionDef | None, carrier: Carrier) -> Carrier | None:
        """Note what a call says; return the function around it where that hands the code on."""
        code = argument(call, carrier.code)
        if code is None:
            return None
        what, advice = (self._saying(module, call, around, part) for part in (carrier.what, carrier.advice))
        codes = [text for text in self._texts(module, code) if CODE.fullmatch(text)]
        for text in codes:
            self._note(text, what, advice, f"{module.path}:{call.lineno}")
            self.found[text].direct |= carrier.name in (*self.classes, FINDING)
        if isinstance(code, ast.JoinedStr):
            self.put_together.add(pieces(code))
        if codes or around is None or not isinstance(code, ast.Name):
            return None
        names = [each.arg for each in around.args.args]
        if code.id not in names:
            return None
        return Carrier(
            around.name,
            parameter(names, code.id),
            self._handed(call, carrier.what, names, what),
            self._handed(call, carrier.advice, names, advice),
        )

    def _handed(
        self, call: ast.Call, part: tuple[int, str] | str, names: list[str], said: list[str]
    ) -> tuple[int, str] | str:
        node = argument(call, part) if isinstance(part, tuple) else None
        if isinstance(node, ast.Name) and node.id in names:
            return parameter(names, node.id)
        if node is None and isinstance(part, tuple) and any(keyword.arg is None for keyword in call.keywords):
            return -1, part[1]  # among the values that the function takes by name
        return said[0] if said else ""

    def _saying(
        self, module: Source, call: ast.Call, around: ast.FunctionDef | None, part: tuple[int, str] | str
    ) -> list[str]:
        if isinstance(part, str):
            return [part] if part else []
        node = argument(call, part)
        local = assigned(around, node.id, call) if isinstance(node, ast.Name) and around else []
        nodes = local or ([] if node is None else [node])
        return list(dict.fromkeys(text for each in nodes for text in self._texts(module, each)))

    def _note(self, code: str, what: list[str], advice: list[str], place: str) -> None:
        refusal = self.found.setdefault(code, Refusal(code))
        refusal.places.append(place)
        for sentence in what or [""]:
            refusal.sayings.update(dict.fromkeys((sentence, each) for each in advice or [""]))

    def _texts(self, module: Source, node: ast.expr, deep: int = 0) -> Iterator[str]:
        """Yield the texts that an expression may be, values as {name}."""
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value
        elif isinstance(node, ast.IfExp):
            yield from self._texts(module, node.body, deep)
            yield from self._texts(module, node.orelse, deep)
        elif isinstance(node, ast.BoolOp):
            for value in node.values:
                yield from self._texts(module, value, deep)
        elif isinstance(node, ast.Call) and translations.called(node) in ("Text", "later") and node.args:
            yield from self._texts(module, node.args[0], deep)
        elif isinstance(node, ast.JoinedStr):
            yield translations.template(node)
        elif isinstance(node, ast.Name | ast.Attribute) and deep < HANDED_ON:
            name = node.id if isinstance(node, ast.Name) else node.attr
            value = module.constants.get(name, self._everywhere.get(name))
            if value is not None:
                yield from self._texts(module, value, deep + 1)


def assigned(function: ast.FunctionDef, name: str, call: ast.Call) -> list[ast.expr]:
    """Return what a name may be at a call: the nearest assignment before it, and those under an if between the two."""

    def is_named(node: ast.AST) -> bool:
        return isinstance(node, ast.Name) and node.id == name

    found: list[ast.expr] = []
    for block in reversed(blocks_before(function, call)):
        for statement in reversed(block):
            values = given(statement, name)
            found += values
            if values and isinstance(statement, ast.Assign) and not any(map(is_named, ast.walk(statement.value))):
                return found
    return found or given(function, name)


def given(node: ast.AST, name: str) -> list[ast.expr]:
    """Return all that a name is given somewhere in a node, alone or as one of several."""
    assignments = (each for each in ast.walk(node) if isinstance(each, ast.Assign))
    both = (pair for each in assignments for target in each.targets for pair in pairs(target, each.value))
    return [value for each, value in both if each == name]


def blocks_before(node: ast.AST, call: ast.Call) -> list[list[ast.stmt]]:
    """Return the statements before a call in each block around it, the outermost block first."""
    for part in ("body", "orelse", "finalbody", "handlers", "cases"):
        block = getattr(node, part, [])
        for number, each in enumerate(block):
            if any(below is call for below in ast.walk(each)):
                return [block[:number] if isinstance(each, ast.stmt) else [], *blocks_before(each, call)]
    return []


def pairs(target: ast.expr, value: ast.expr) -> Iterator[tuple[str, ast.expr]]:
    """Yield the names of an assignment, each with what it is given."""
    if isinstance(target, ast.Name):
        yield target.id, value
    elif isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple):
        for one, part in zip(target.elts, value.elts, strict=False):
            yield from pairs(one, part)


def pieces(node: ast.JoinedStr) -> str:
    """Return the fixed pieces of a string with values."""
    return "".join(translations.literal(part) or "…" for part in node.values)


def argument(call: ast.Call, part: tuple[int, str]) -> ast.expr | None:
    """Return an argument of a call by its name or its position, None where it is not given."""
    at, name = part
    named = next((keyword.value for keyword in call.keywords if keyword.arg == name), None)
    return named if named is not None else call.args[at] if 0 <= at < len(call.args) else None


def parameter(names: list[str], name: str) -> tuple[int, str]:
    """Return position and name of a parameter, as a call of the function or method has it."""
    return names.index(name) - (names[0] in SELF), name


@functools.cache
def refusals() -> dict[str, Refusal]:
    """Return all refusals of the package by their codes; they are read once in a process, which takes seconds."""
    modules = sources()
    return Reader(modules, error_classes(modules)).read()
