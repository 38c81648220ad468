# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate of a program: which bytes were proven, against what, what was found, and all that a sender needs.

`job.make_certificate` makes it; here it is read, so that who sends need not know how a proof is made. What was proven
(program, wire, start, machine, stock, tools, clamps) stands in it with its SHA-256; one more, over the whole, finds
what was changed in the certificate itself. None of them is a signature: they stop mistakes, not a forger.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import whole_file
from CNCStepper.control.program.bundle import (
    LINE_MAP,
    WIRE,
    Bundle,
    array_bytes,
    head_bytes,
    is_bundle,
    line_bytes,
    number_bytes,
    read_bundle,
    write_bundle,
)
from CNCStepper.control.program.program_columns import MESSAGES, message_bytes, message_members, messages_of
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import MOST_TEXT_BYTES, read_input

FORMAT, VERSION, OLD_VERSION = "CNCStepper certificate", 2, 1  # the old one: a JSON file with the lines in it
PROOF = "proof.json"
CHECK_AGAIN = "check the program again, and send it with the certificate that this gives"
OTHER = {
    "program": "the program is not the one that was proven: its text differs",
    "wire": "the lines to send are not those that were proven",
    "start": "the program was proven from another start state: work zero, offsets or tool lengths differ",
    "machine": "the program was proven for another machine, or its profile was changed since",
    "stock": "the program was proven with another stock",
    "tools": "the program was proven with other tools",
    "keep_out": "the program was proven with other clamps, or another distance from the sheet's edge",
    "cut": "the program was proven for another process, material, thickness or consumable",
}


def digest_of(content: Any) -> str:
    """Return the SHA-256 of plain data, as hexadecimal digits; the order of keys does not count."""
    return digest_of_text(json.dumps(content, sort_keys=True, separators=(",", ":")))


def digest_of_text(text: str) -> str:
    """Return the SHA-256 of a text, as hexadecimal digits."""
    return digest_of_pieces([text])


def digest_of_pieces(text: Iterable[str]) -> str:
    """Return the SHA-256 of a text that comes in pieces, as hexadecimal digits."""
    return _digest(piece.encode("utf-8") for piece in text)


def digest_of_lines(lines: Sequence[str]) -> str:
    """Return the SHA-256 of wire lines as they are sent, each with its newline."""
    return _digest(line_bytes(lines))


def _digest(pieces: Iterable[bytes]) -> str:
    digest = hashlib.sha256()
    for piece in pieces:
        digest.update(piece)
    return digest.hexdigest()


@dataclass(frozen=True)
class Certificate:
    """The result of a proof; content: plain data with the keys that `job.make_certificate` writes.

    lines, file_lines, messages: what is sent, as a `SendJob` has it.
    """

    content: Mapping[str, Any]
    lines: Sequence[str] = ()
    file_lines: Sequence[int] = ()
    messages: Mapping[int, str] = field(default_factory=dict)

    @classmethod
    def read(cls, path: Path) -> Certificate:
        """Return the certificate of a file; raises JobError naming it.

        Its lines are never held whole: they are read when they are wanted, from the file, which must not change.
        """
        try:
            if is_bundle(path):
                return cls.of_bundle(read_bundle(path))
            if path.stat().st_size > MOST_TEXT_BYTES:
                raise ValueError("a JSON of the first release, and too large")
            return cls._of_old(read_input(path))
        except (OSError, ValueError) as error:
            if isinstance(error, JobError):
                raise error.at(Place(str(path))) from error
            raise _refusal("certificate", "the certificate cannot be read", str(error)).at(Place(str(path))) from error

    @classmethod
    def of_bundle(cls, bundle: Bundle) -> Certificate:
        """Return the certificate of a bundle; raises JobError when it is none, or not as it was made."""
        _check_format(bundle.head, VERSION)
        content = dict(bundle.head)
        noted, messages = content.pop("sha256", None), messages_of(bundle.columns)
        certificate = cls(content, bundle.lines, bundle.file_lines, messages)
        _check_same(noted, certificate.sha256)
        return certificate._checked()

    @classmethod
    def _of_old(cls, text: bytes) -> Certificate:
        """Return the certificate of an old file, held whole; raises as `of_bundle` does, and ValueError."""
        try:
            content = json.loads(text)
            _check_format(content, OLD_VERSION)
            _check_same(content.pop("sha256", None), digest_of(content))
            sent = content["send"]
            return cls(content, sent.pop("lines"), sent.pop("file_lines", ()))._checked()
        except (AttributeError, KeyError, TypeError, RecursionError) as error:
            raise ValueError(str(error)) from error

    def write(self, path: Path) -> None:
        """Write the certificate to a file, whole or not at all; raises OSError."""
        members = {PROOF: head_bytes(self.head(), indent=1, allow_nan=False), WIRE: line_bytes(self.lines)}
        with whole_file(path) as file:
            write_bundle(file, members | {LINE_MAP: array_bytes(self.file_lines)} | message_members(self.messages))

    def head(self) -> dict[str, Any]:
        """Return all but the lines that are sent, with the fingerprint of all."""
        return {**self.content, "sha256": self.sha256}

    def _checked(self) -> Certificate:
        """Return the certificate; raises JobError where its lines are others than those proven."""
        self.send_job()
        wire = self.content.get("wire")
        if not isinstance(wire, Mapping) or not isinstance(wire.get("sha256"), str):
            raise _refusal("certificate", "the certificate lacks an entry that a sender needs", "wire")
        self.compare("wire", digest_of_lines(self.lines))
        return self

    @cached_property
    def sha256(self) -> str:
        """The fingerprint of all of it."""
        columns = {LINE_MAP: _digest(number_bytes(self.file_lines))}
        if self.messages:
            columns[MESSAGES] = _digest(message_bytes(self.messages))
        return digest_of({**self.content, **columns})

    @property
    def dialect(self) -> str:
        """The language of the lines that are sent."""
        return str(self.content["wire"]["dialect"])

    @property
    def program_dialect(self) -> str:
        """The language in which the program was read."""
        return str(self.content["program"].get("dialect") or self.dialect)

    def compare(self, what: str, sha256: str) -> None:
        """Refuse something else than was proven; `what` is a key of OTHER. Raises JobError."""
        proven = self.content[what]["sha256"]
        if sha256 != proven:
            raise JobError(
                f"certificate-{what}",
                OTHER[what],
                value=f"SHA-256 {sha256[:12]}…",
                limit=f"{proven[:12]}…",
                advice=CHECK_AGAIN,
            )

    def check_clean(self) -> None:
        """Refuse a program in which the proof found errors; raises JobError naming the first."""
        try:
            errors = [finding for finding in self.content["findings"] if finding["severity"] == "error"]
            place = Place(errors[0]["file"], errors[0]["line"], errors[0]["column"]) if errors else None
        except (KeyError, TypeError) as error:
            raise _refusal("certificate", "the certificate's findings are damaged", str(error)) from error
        if errors:
            what = Text(
                "the proof found {errors} error(s) in the program, the first: {text}",
                errors=len(errors),
                text=errors[0]["text"],
            )
            raise JobError("certificate-errors", what, advice="correct the program, and check it again", place=place)

    def sending(self, **more: Any) -> Certificate:
        """Return the certificate with more fields of a `SendJob` in what a sender is given."""
        return replace(self, content={**self.content, "send": {**self.content["send"], **more}})

    def send_job(self, **instead: Any) -> SendJob:
        """Return the job of sending the proven lines, with other values for some fields of it."""
        try:
            columns = {"lines": self.lines, "file_lines": self.file_lines}
            sent = {"messages": self.messages, **self.content["send"], **columns}
            return SendJob.from_content({"port": "", **sent, **self._identity(), **instead})
        except (AttributeError, KeyError, TypeError) as error:
            raise _refusal("certificate", "the certificate lacks an entry that a sender needs", str(error)) from error

    def _identity(self) -> dict[str, str]:
        """Return the identity of program, machine and proof for a journal, and the language of the lines."""
        return {
            "dialect": str(self.content.get("wire", {}).get("dialect", "")),
            "program_dialect": str(self.content.get("program", {}).get("dialect", "")),
            "machine": str(self.content.get("machine", {}).get("name", "")),
            "program_sha256": str(self.content.get("program", {}).get("sha256", "")),
            "certificate_sha256": self.sha256,
        }


def sendable(path: Path, private: bool = False, **instead: Any) -> SendJob:
    """Return the job of a certificate's file, or of one that `write_job` wrote, with other values for some fields.

    private: as `read_bundle` takes it. Raises JobError for a certificate that was changed or that holds errors, and for
    what is neither.
    """
    try:
        bundle = read_bundle(path, private) if is_bundle(path) else None
    except (OSError, ValueError) as error:
        raise JobError(
            "send-job", Text("the job cannot be read: {error}", error=error), advice="make it again"
        ) from error
    if bundle and "format" not in bundle.head:
        return SendJob.of_bundle(bundle, **instead)
    certificate = Certificate.of_bundle(bundle) if bundle else Certificate.read(path)
    certificate.check_clean()
    return certificate.send_job(**instead)


def _check_format(content: Any, version: int) -> None:
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise _refusal("certificate", "this is no certificate")
    if content.get("version") != version:
        raise _refusal("certificate", "the certificate is of another version", str(content.get("version")))


def _check_same(noted: Any, sha256: str) -> None:
    if noted != sha256:
        raise _refusal("certificate-changed", "the certificate was changed after it was made")


def _refusal(code: str, what: str, value: str = "") -> JobError:
    return JobError(code, what, value=value[:60], advice=CHECK_AGAIN)
