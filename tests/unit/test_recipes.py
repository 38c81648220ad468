# SPDX-License-Identifier: LGPL-2.1-or-later
"""The recipes of docs/developer/recipes are followed by machine in a copy of the project, and what they add works.

Code stands below a line that names its file and place: "`FILE`, new:", "`FILE`, after the line `TEXT`:", also "before"
and "in place of", or "the line with". It is a block, or a single line between backticks, which is indented
as the line that was named. Blocks of `sh` are commands, of which those of pytest are run. The last block, below "Try
it", is a script that asserts.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
RECIPES = ROOT / "docs" / "developer" / "recipes"
LONGEST = 80  # lines of a recipe
COPIED = ("CNCStepper", "Init.py", "pyproject.toml", "docs/reference", "examples", "resources/icons", "tests")
HEAD = re.compile(
    r"(?:- )?`(?P<file>[^`]+)`, (?:new|(?P<where>after|before|in place of) the line (?P<part>with )?"
    r"(?P<quote>`+) ?(?P<line>.+?) ?(?P=quote)):"
)
ONE = re.compile(r"  (?P<quote>`+) ?(?P<code>.+?) ?(?P=quote)")
FIRST = re.compile(r"^First follow \[[^\]]+\]\(([\w-]+)\.md\)", re.MULTILINE)
INSIDE = """# run by freecadcmd, which swallows an exception and runs a script once more
import os, sys, traceback
status = 1
try:
    exec(open({script!r}, encoding="utf-8").read(), {{"__name__": "__main__"}})
    status = 0
except BaseException:
    traceback.print_exc()
finally:
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)
"""


@dataclass(frozen=True)
class Step:
    """Code and its place; where: "" is a new file, else how it lies to the line that is, or holds, `line`.

    indents: as much as that line.
    """

    file: str
    text: str
    where: str = ""
    line: str = ""
    part: bool = False
    indents: bool = False

    def follow(self, folder: Path) -> None:
        """Put the block into its file below `folder`."""
        path = folder / self.file
        if not self.where:
            assert not path.exists(), f"{self.file} is there already"
            path.write_text(self.text, "utf-8", newline="\n")
            return
        lines = path.read_text("utf-8").splitlines(keepends=True)
        found = [number for number, line in enumerate(lines) if self._is_meant(line.strip())]
        assert len(found) == 1, f"{self.file} has {len(found)} lines `{self.line}`"
        named = lines[found[0]]
        indent = named[: len(named) - len(named.lstrip())] if self.indents else ""
        lines[found[0] + (self.where == "after") : found[0] + (self.where != "before")] = [indent + self.text]
        path.write_text("".join(lines), "utf-8", newline="\n")

    def _is_meant(self, line: str) -> bool:
        return self.line in line if self.part else line == self.line


@dataclass(frozen=True)
class Recipe:
    """What a page says: the recipe to follow before, the steps, the runs of pytest, and the script to try it."""

    first: str
    steps: Sequence[Step]
    tests: Sequence[str]
    script: str

    @classmethod
    def read(cls, name: str) -> Recipe:
        """Return the recipe of a page; every block of it but commands and the last one needs a place."""
        page = (RECIPES / f"{name}.md").read_text("utf-8")
        assert len(page.splitlines()) <= LONGEST, f"{name} has more than {LONGEST} lines"
        *blocks, (above, language, script) = code_of(page)
        assert (above, language) == ("## Try it", "python"), f"{name} does not end with a trial"
        commands = "".join(text for _, language, text in blocks if language == "sh").splitlines()
        steps = [_step(*block) for block in blocks if block[1] != "sh"]
        before = FIRST.search(page)
        return cls(before[1] if before else "", steps, [one for one in commands if "-m pytest" in one], script)


def code_of(page: str) -> Iterator[tuple[str, str, str]]:
    """Yield the line above each block of a page, its language and its text; a single line has no language."""
    above, lines = "", iter(page.splitlines(keepends=True))
    for line in lines:
        if line.startswith("```"):
            yield above, line[3:].strip(), "".join(takewhile(lambda inner: inner != "```\n", lines))
        elif (one := ONE.fullmatch(line.rstrip("\n"))) and above.endswith(":"):
            yield above, "", one["code"] + "\n"
        above = line.strip() or above


def _step(above: str, language: str, text: str) -> Step:
    head = HEAD.fullmatch(above)
    assert head, f"no place for the code below: {above}"
    return Step(head["file"], text, head["where"] or "", head["line"] or "", bool(head["part"]), not language)


def followed(name: str, folder: Path) -> Recipe:
    """Follow a recipe, and those that it builds upon, in a copy of the project."""
    if not (folder / "CNCStepper").exists():
        for part in COPIED:
            (folder / part).parent.mkdir(parents=True, exist_ok=True)
            whole = (ROOT / part).is_dir()
            shutil.copytree(ROOT / part, folder / part) if whole else shutil.copy2(ROOT / part, folder / part)
    recipe = Recipe.read(name)
    if recipe.first:
        followed(recipe.first, folder)
    for step in recipe.steps:
        step.follow(folder)
    return recipe


def run(command: Sequence[str], folder: Path, home: Path, **more: str) -> None:
    """Run a command in the copy: its own package, and plain Python for kernels, since a copy has none compiled."""
    environment = {**os.environ, "PYTHONPATH": str(folder), "NUMBA_DISABLE_JIT": "1", "XDG_CACHE_HOME": str(home)}
    environment |= {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1", "PYTEST_ADDOPTS": "-p no:cacheprovider"} | more
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr


OWN = "from pathlib import Path\nimport CNCStepper\nassert Path(CNCStepper.__file__).is_relative_to({folder!r})\n"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["add-a-cycle", "add-a-dialect", "add-a-controller", "add-a-check"])
def test_a_recipe_leads_to_what_it_promises(name: str, tmp_path: Path) -> None:
    copy, home = tmp_path / "copy", tmp_path / "home"
    copy.mkdir()
    recipe = followed(name, copy)
    run([sys.executable, "-c", OWN.format(folder=str(copy)) + recipe.script], copy, home)
    for command in recipe.tests:
        run([sys.executable, *shlex.split(command)[1:]], copy, home)


@pytest.mark.freecad
def test_the_recipe_of_a_panel_makes_an_object_in_freecad(tmp_path: Path) -> None:
    freecadcmd = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    assert freecadcmd, "FreeCAD's freecadcmd is not on PATH: run 'make setup'"
    copy, home = tmp_path / "copy", tmp_path / "home"
    copy.mkdir()
    home.mkdir()
    script, start = home / "trial.py", home / "start.py"
    script.write_text(OWN.format(folder=str(copy)) + followed("add-a-panel", copy).script, "utf-8")
    start.write_text(INSIDE.format(script=str(script)), "utf-8")
    packages = os.pathsep.join(filter(None, (os.environ.get("CNCSTEPPER_PACKAGES"), sysconfig.get_path("purelib"))))
    environment = {"LC_ALL": "C.UTF-8", "FREECAD_USER_HOME": str(home), "CNCSTEPPER_PACKAGES": packages}
    run([freecadcmd, str(start), "-M", str(copy)], copy, home, **environment)


def test_every_recipe_is_followed_here() -> None:
    assert sorted(path.stem for path in RECIPES.glob("*.md")) == [
        "add-a-check", "add-a-controller", "add-a-cycle", "add-a-dialect", "add-a-panel",
    ]  # fmt: skip


def test_a_step_whose_line_is_not_there_once_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("one = 1\ntwo = 2\ntwo = 2\n", "utf-8")
    for line in ("two = 2", "three = 3"):
        with pytest.raises(AssertionError, match=re.escape(line)):
            Step("a.py", "four = 4\n", "after", line).follow(tmp_path)
    Step("a.py", "zero = 0\n", "before", "one", part=True).follow(tmp_path)
    Step("a.py", "one = 1.0\n", "in place of", "one = 1").follow(tmp_path)
    assert (tmp_path / "a.py").read_text("utf-8") == "zero = 0\none = 1.0\ntwo = 2\ntwo = 2\n"
