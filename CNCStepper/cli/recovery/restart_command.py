# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that restarts a job that did not end, whole: as it is, it proves the restart and sends it.

journal: program, line | machine, dialect | stock, tool, job | start | port, homing  ─►  words, and what they lack
"""

from __future__ import annotations

import shlex
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper.cli.common.options import digest_of_file
from CNCStepper.control.journal.store import PROFILE
from CNCStepper.control.session.files import write_private
from CNCStepper.errors import JobError, Text
from CNCStepper.machine.controller_family import BAUD
from CNCStepper.machine.profile import Machine, load_machine, profile_names, validated

if TYPE_CHECKING:
    from CNCStepper.control.journal.replay import JobReplay

START_SYSTEM = "G54"  # that --work-zero names
NO_PROFILE = "PROFILE.toml"
NO_STOCK = "--without-stock"
ONLY_RESTART = ("--part", "--overlap", "--height")


class RestartLine:
    """The words of the command, and `told`: what of it is not known, or is not as it was; a name and a sentence each.

    story: of a job whose program stands in `file` as it was sent, and is to go on from `line`; 0 sends it whole again.
    """

    def __init__(self, story: JobReplay, file: Path, line: int):
        self.told: list[tuple[str, str]] = []
        self._story = story
        made_with = story.header.get("made_with", {})
        self._options: dict[str, list[str]] = dict(made_with.get("options", {}))
        self._profile: dict[str, Any] = story.header.get("profile", {})
        self._set_machine()
        self._set_dialect()
        self._set_work_zero()
        verb = ["restart", str(file), "--line", str(line), *self._no_stock()] if line else ["send", str(file)]
        self.words = ["cncstepper", *verb, *self._said(is_whole=not line), *self._sending()]
        self._look_at(made_with.get("files", {}))

    def __str__(self) -> str:
        return subprocess.list2cmdline(self.words) if sys.platform == "win32" else shlex.join(self.words)

    def _said(self, is_whole: bool) -> Iterator[str]:
        for name, values in self._options.items():
            for value in values:
                if not (is_whole and name in ONLY_RESTART):
                    yield from (name, value)

    def _sending(self) -> Iterator[str]:
        story = self._story
        yield from ("--port", story.header["port"])
        if (baud := story.header.get("baud", BAUD)) != BAUD:
            yield from ("--baud", str(baud))
        if story.header["homing"] and not story.position_kept:
            yield "--home"

    def _set_machine(self) -> None:
        """Name the profile that the job had: as it was named, one that is shipped, or a copy of the journal's own."""
        named = self._options.pop("--machine", [])
        if not named and "--job" in self._options:
            return  # its machine counts
        self._options = {"--machine": [self._machine(named)], **self._options}

    def _machine(self, named: list[str]) -> str:
        header, profile = self._story.header, self._profile
        if named and (not profile or _read(named[0]) == profile):
            return named[0]
        for shipped in profile_names():
            if _read(shipped) == profile or (not profile and load_machine(shipped).name == header["machine"]):
                return shipped
        if profile:
            return self._copy_of_profile(named)
        machine = header["machine"] or Text("the machine, which the job was sent without")
        what = Text("the profile of {machine}: put its file in place of {name}", machine=machine, name=NO_PROFILE)
        self._tell("not known", what)
        return NO_PROFILE

    def _copy_of_profile(self, named: list[str]) -> str:
        """Write the profile that the journal has beside it, and return where."""
        copy = self._story.path.with_suffix(PROFILE)
        write_private(copy, self._profile)
        if named:
            what = Text(
                "{name} is not as it was, or not there: {copy} is what the job was sent with", name=named[0], copy=copy
            )
            self._tell("profile", what)
        return str(copy)

    def _set_dialect(self) -> None:
        dialect = self._story.header.get("dialect", "")
        if dialect and dialect != self._usual_dialect():
            self._options["--dialect"] = [dialect]

    def _usual_dialect(self) -> str:
        """Return how the programs of the journal's machine are read where nothing is said."""
        return validated(Machine, self._profile, "journal").language() if self._profile else "grbl"

    def _no_stock(self) -> Iterator[str]:
        """Note where the job was sent without stock."""
        if "--job" not in self._options and not {"--stock", "--tool"} <= set(self._options):
            yield NO_STOCK
            what = Text(
                "the stock and its tool, so nobody sees whether a rapid meets material: give --stock and --tool, or "
                "--job, in place of {option}",
                option=NO_STOCK,
            )
            self._tell("not known", what)

    def _set_work_zero(self) -> None:
        """Give the zero with which the restart is made and compared: one that was set again within the job counts.

        Of a machine that cannot home itself machine coordinates mean nothing after a loss: then no zero is given, and
        one that was set is said in words only.
        """
        story = self._story
        zero_mm = story.zero.get("offsets_mm", {}).get(START_SYSTEM)
        is_set_again = bool(zero_mm) and START_SYSTEM in story.zero["modes"].split()
        if is_set_again or not (story.header["homing"] or story.position_kept):
            self._options.pop("--work-zero", None)
        if is_set_again and story.header["homing"]:
            self._options["--work-zero"] = [",".join(f"{value:.3f}" for value in zero_mm[:3])]

    def _look_at(self, files: Mapping[str, str]) -> None:
        """Note which of the files that the command names have changed."""
        for name in (name for name in files if name in self.words):
            if not Path(name).is_file():
                what = Text("{name} is not there any more: the restart is made with it, bring it back", name=name)
                self._tell("missing", what)
            elif digest_of_file(Path(name)) != files[name]:
                what = Text("{name} was changed since: see that it still says what was cut", name=name)
                self._tell("changed", what)

    def _tell(self, name: str, text: str) -> None:
        self.told.append((name, text))


def _read(profile: str) -> dict[str, Any]:
    """Return the content of a machine's profile; {} where it cannot be read any more."""
    try:
        return load_machine(profile).model_dump(mode="json")
    except (JobError, OSError):
        return {}
