# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate of a program: which bytes were proven, against what, what was found, and all that a sender needs.

`job.certify` makes it; here it is read, so that who sends need not know how a proof is made. What was proven
(program, wire, start, machine, stock, tools, clamps) stands in it with its SHA-256; one more, over the whole, finds
what was changed in the certificate itself. None of them is a signature: they stop mistakes, not a forger.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from CNCStepper.control.program.long_json import blocks_of, pieces, read_long
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.errors import JobError, Place

FORMAT, VERSION = "CNCStepper certificate", 1
CHECK_AGAIN = "check the program again, and send it with the certificate that this gives"
OTHER = {
    "program": "the program is not the one that was proven: its text differs",
    "wire": "the lines to send are not those that were proven",
    "start": "the program was proven from another start state: work zero, offsets or tool lengths differ",
    "machine": "the program was proven for another machine, or its profile was changed since",
    "stock": "the program was proven with another stock",
    "tools": "the program was proven with other tools",
    "keep_out": "the program was proven with other clamps, or another distance from the sheet's edge",
}


def digest_of(content: Any) -> str:
    """Return the SHA-256 of plain data, as hexadecimal digits; the order of keys does not count."""
    return digest_of_pieces(pieces(content, json.JSONEncoder(sort_keys=True, separators=(",", ":"))))


def digest_of_text(text: str) -> str:
    """Return the SHA-256 of a text, as hexadecimal digits."""
    return digest_of_pieces([text])


def digest_of_pieces(text: Iterable[str]) -> str:
    """Return the SHA-256 of a text that comes in pieces, as hexadecimal digits."""
    digest = hashlib.sha256()
    for piece in text:
        digest.update(piece.encode("utf-8"))
    return digest.hexdigest()


def digest_of_lines(lines: Iterable[str]) -> str:
    """Return the SHA-256 of wire lines as they are sent, each with its newline."""
    return digest_of_pieces("\n".join((*block, "")) for block in blocks_of(lines))


@dataclass(frozen=True)
class Certificate:
    """The result of a proof; content: plain data with the keys that `job.certify` writes."""

    content: Mapping[str, Any]

    @classmethod
    def read(cls, path: Path, files: ExitStack) -> Certificate:
        """Return the certificate of a file; raises JobError naming it.

        Its lines are never held whole: they are read when they are wanted, from the file, which `files` closes.
        """
        try:
            return cls.from_content(read_long(files.enter_context(path.open("rb"))))
        except (OSError, ValueError) as error:
            if isinstance(error, JobError):
                raise error.at(Place(str(path))) from error
            raise _refusal("certificate", "the certificate cannot be read", str(error)).at(Place(str(path))) from error

    @classmethod
    def from_json(cls, text: str) -> Certificate:
        """Return the certificate of `to_json`; raises JobError when it is none, or not as it was made."""
        try:
            content = json.loads(text)
        except ValueError as error:
            raise _refusal("certificate", "this is no certificate", str(error)) from error
        return cls.from_content(content)

    @classmethod
    def from_content(cls, content: Any) -> Certificate:
        """Return the certificate of JSON already read, as `from_json` does."""
        if not is_certificate(content):
            raise _refusal("certificate", "this is no certificate")
        if content.get("version") != VERSION:
            raise _refusal("certificate", "the certificate is of another version", str(content.get("version")))
        content = dict(content)
        told, certificate = content.pop("sha256", None), cls(content)
        if told != certificate.sha256:
            raise _refusal("certificate-changed", "the certificate was changed after it was made")
        certificate.compare("wire", digest_of_lines(certificate.send_job().lines))
        return certificate

    def to_json(self) -> str:
        """Return the certificate as strict JSON, with the fingerprint of all of it."""
        return "".join(self.json_pieces())

    def json_pieces(self) -> Iterator[str]:
        """Yield the text of `to_json`; lines that are in a spool are never held whole."""
        content = dict(self.content) | {"sha256": self.sha256}
        if isinstance(self.content["send"]["lines"], list):
            yield json.dumps(content, indent=1, allow_nan=False)
        else:
            yield from pieces(content, json.JSONEncoder(allow_nan=False))
        yield "\n"

    @cached_property
    def sha256(self) -> str:
        """The fingerprint of all of it."""
        return digest_of(self.content)

    @property
    def dialect(self) -> str:
        """The language in which the program was read."""
        return str(self.content["wire"]["dialect"])

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
        errors = [finding for finding in self.content["findings"] if finding["severity"] == "error"]
        if errors:
            first = errors[0]
            place = Place(first["file"], first["line"], first["column"])
            what = f"the proof found {len(errors)} error(s) in the program, the first: {first['text']}"
            raise JobError("certificate-errors", what, advice="correct the program, and check it again", place=place)

    def sending(self, **more: Any) -> Certificate:
        """Return the certificate with more fields of a `SendJob` in what a sender is given."""
        return Certificate({**self.content, "send": {**self.content["send"], **more}})

    def send_job(self, **instead: Any) -> SendJob:
        """Return the job of sending the proven lines, with other values for some fields of it."""
        try:
            return SendJob.from_content({"port": "", **self.content["send"], **self._identity(), **instead})
        except (AttributeError, KeyError, TypeError) as error:
            raise _refusal("certificate", "the certificate lacks what a sender needs", str(error)) from error

    def _identity(self) -> dict[str, str]:
        """Return by what a journal knows the program, the machine and this proof, and the language of the lines."""
        return {
            "dialect": str(self.content.get("wire", {}).get("dialect", "")),
            "machine": str(self.content.get("machine", {}).get("name", "")),
            "program_sha256": str(self.content.get("program", {}).get("sha256", "")),
            "certificate_sha256": self.sha256,
        }


def is_certificate(content: Any) -> bool:
    """Return whether JSON is marked as a certificate."""
    return isinstance(content, dict) and content.get("format") == FORMAT


def sendable(content: Any, **instead: Any) -> SendJob:
    """Return the job of a certificate, or of a bare `SendJob`, read of JSON, with other values for some fields.

    Raises JobError for a certificate that was changed or that holds errors, TypeError or JobError for what is neither.
    """
    if not is_certificate(content):
        return SendJob.from_content(content | instead)
    certificate = Certificate.from_content(content)
    certificate.check_clean()
    return certificate.send_job(**instead)


def _refusal(code: str, what: str, value: str = "") -> JobError:
    return JobError(code, what, value=value[:60], advice=CHECK_AGAIN)
