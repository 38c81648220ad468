# SPDX-License-Identifier: LGPL-2.1-or-later
"""A position that is unknown, on the disk from one connection to the next: one file a port, gone when it is known.

PORT-DIGEST.position    beside the sessions' files, readable by their owner only

Which port a file is of says its content, so that it is found under each name of the port. Two boards of one kind
without serial numbers may have changed places, and two hosts with an address in common may be one machine or two: what
one has lost counts for the other too, until that was homed or zeroed where it is now. Its file then says so in
"known_at", and goes only when its own port is known again; a loss that comes later counts for all of them again.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable, Iterator, Mapping
from itertools import count
from pathlib import Path
from typing import Any

from CNCStepper.control.journal.replay import RUNNING
from CNCStepper.control.journal.store import replays
from CNCStepper.control.processes.process_file import is_closed, owner
from CNCStepper.control.session.files import read_private, write_durably
from CNCStepper.control.stream.position_trust import LOST, NOTHING_AGAINST, PositionTrust
from CNCStepper.control.transport.port_identity import PortIdentity, address_names, identify, other_names, read_identity
from CNCStepper.errors import JobError, Text

POSITION = ".position"
LONGEST_NAME = 40
_NOT_FOR_NAMES = re.compile(r"[^A-Za-z0-9]+")


class PositionTrustFile:
    """Saved position trust of the machine at one port, from its last connection.

    belief: as it was kept; without a file nothing speaks against the position. path: None keeps nothing. identity: of
    the port; None looks at that one file alone. aliases: older files of the same port. near: older ones of its
    addresses, perhaps of another.
    """

    def __init__(
        self,
        path: Path | None,
        identity: PortIdentity | None = None,
        aliases: frozenset[Path] = frozenset(),
        near: frozenset[Path] = frozenset(),
    ):
        self._path = path
        self._identity = identity
        self._aliases = aliases
        self._near = near
        self._looked_up: dict[PortIdentity, PortIdentity] = {}
        self._written: Path | None = None
        self.trust = self._said()

    @classmethod
    def of_port(cls, folder: Path, port: str) -> PositionTrustFile:
        """Return that of a port, by whatever name it has, in a folder of sessions."""
        identity = identify(port)
        aliases = frozenset(_path(folder, name) for name in other_names(port, identity))
        near = frozenset(_path(folder, name) for name in address_names(identity))
        return cls(_path(folder, identity.key), identity, aliases, near)

    def keep(self, trust: PositionTrust) -> None:
        """Save the present trust; on return it is on the disk. Raises JobError when it cannot be saved."""
        kept = trust if trust.position_known is False else NOTHING_AGAINST
        if kept == self.trust and (kept is NOTHING_AGAINST or self._path is None or self._is_written()):
            return
        self.trust = kept
        if self._path:
            try:
                self._write(self._path, kept)
            except OSError as error:
                raise _unwritable(self._path, error) from error

    def save_or_warn(self, trust: PositionTrust, tell: Callable[[str, str], None]) -> None:
        """Save the present trust; warn once when it cannot be saved."""
        try:
            self.keep(trust)
        except JobError as error:
            tell("warning", error.text)

    # --- inside --------------------------------------------------------------------------------

    def _write(self, path: Path, trust: PositionTrust) -> None:
        if trust.position_known is False:
            identity = {"port_identity": self._identity.to_json()} if self._identity else {}
            zeroed = "".join(sorted(trust.zeroed))
            self._written = self._own_place(path)
            write_durably(self._written, {"counts_from_here": trust.counts_from_here, "zeroed": zeroed} | identity)
            self._drop_older(self._written)
            return
        closed = []
        for file, content in list(self._against()):
            if is_closed(file):
                closed.append(file)
            elif self._is_own(file, content):
                file.unlink(missing_ok=True)
            elif self._identity:  # of a board that looks like this one
                known = [*_known_at(content), self._identity]
                write_durably(file, {**content, "known_at": [identity.to_json() for identity in known]})
        if closed:
            raise _closed(closed[0])

    def _drop_older(self, written: Path) -> None:
        """Remove what this port has kept before under other names."""
        for file, content in list(self._against()):
            if file != written and self._is_own(file, content) and not is_closed(file):
                file.unlink(missing_ok=True)

    def _is_written(self) -> bool:
        """Return whether this connection's loss is on the disk: an older file may call others known since."""
        return self._written is not None and self._written.exists()

    def _own_place(self, path: Path) -> Path:
        """Return where this port's file may be written: beside another port's, or one that this user may not open."""
        return next(place for place in _places(path) if not is_closed(place) and self._is_free(place))

    def _is_free(self, place: Path) -> bool:
        content = _read(place)
        return content is None or _identity_of(content) is None or self._is_own(place, content)

    def _said(self) -> PositionTrust:
        """Return the trust of all files together: where they differ, the one that no earlier zero restores."""
        said = {_trust(content) if self._is_own(file, content) else LOST for file, content in self._against()}
        return NOTHING_AGAINST if not said else said.pop() if len(said) == 1 else LOST

    def _against(self) -> Iterator[tuple[Path, Mapping[str, Any]]]:
        """Yield the files that say that this port's machine may have lost its position, with their contents."""
        if self._path is None:
            return
        for file in sorted(self._path.parent.glob(f"*{POSITION}")):
            content = _read(file)
            if content is not None and (self._is_own(file, content) or self._may_be_meant(file, content)):
                yield file, content

    def _is_own(self, file: Path, content: Mapping[str, Any]) -> bool:
        other = _identity_of(content)
        if other is None or self._identity is None:
            return file == self._path or file in self._aliases
        return self._is_still(other)

    def _is_still(self, other: PortIdentity) -> bool:
        """Return whether a file's port is this one; its addresses may belong to another host now."""
        assert self._identity
        if other.tcp_port is None:
            return self._identity.is_same(other)
        return self._identity.has_host_of(other) or self._identity.is_same(self._now(other))

    def _now(self, other: PortIdentity) -> PortIdentity:
        """Return the identity of a port's name now; looked up once, and only where it could be this one."""
        assert self._identity
        if other.tcp_port != self._identity.tcp_port:
            return other
        if other not in self._looked_up:
            self._looked_up[other] = other.now()
        return self._looked_up[other]

    def _may_be_meant(self, file: Path, content: Mapping[str, Any]) -> bool:
        other = _identity_of(content)
        if self._identity is None:
            return False
        if any(map(self._is_still, _known_at(content))):
            return False
        if other is None:
            return file in self._near
        return self._may_be_now(other) and not (other.board and self._runs(other))

    def _may_be_now(self, other: PortIdentity) -> bool:
        """Return whether a file's port may be this one, by its stored or its present addresses."""
        assert self._identity
        now = self._now(other)
        if now.unsure:
            return self._identity.may_be(other)
        return self._identity.may_be(now) or (not other.unsure and self._identity.may_be(other))

    def _runs(self, other: PortIdentity) -> bool:
        """Return whether a job runs at another port: then its machine is there, and is not the one at this port."""
        assert self._path
        running = (story.header for story in replays(self._path.parent) if story.end == RUNNING)
        return any(read_identity(header, header["port"]).is_same(other) for header in running)


def _path(folder: Path, name: str) -> Path:
    readable = _NOT_FOR_NAMES.sub("-", name).strip("-")[:LONGEST_NAME]
    return folder / f"{readable}-{hashlib.sha256(name.encode('utf-8')).hexdigest()[:16]}{POSITION}"


def _places(path: Path) -> Iterator[Path]:
    """Yield where a port's file may be, the best first."""
    yield path
    yield from (path.with_stem(f"{path.stem}-{number}") for number in count(2))


def _read(path: Path) -> Mapping[str, Any] | None:
    """Return a file's content; {} for one that cannot be read, None where there is none."""
    try:
        content = read_private(path)
    except (OSError, ValueError, RecursionError):
        return {}
    return content if content is None or isinstance(content, dict) else {}


def _trust(content: Mapping[str, Any]) -> PositionTrust:
    """Return a file's trust; a file that cannot be read means a lost position."""
    try:
        return LOST._replace(counts_from_here=content["counts_from_here"] is True, zeroed=frozenset(content["zeroed"]))
    except (KeyError, TypeError):
        return LOST


def _identity_of(content: Mapping[str, Any]) -> PortIdentity | None:
    try:
        return PortIdentity.from_json(content["port_identity"])
    except (ValueError, KeyError, TypeError):
        return None


def _known_at(content: Mapping[str, Any]) -> Iterator[PortIdentity]:
    known = content.get("known_at")
    for identity in known if isinstance(known, list) else []:
        if (found := _identity_of({"port_identity": identity})) is not None:
            yield found


def _closed(path: Path) -> JobError:
    user = owner(path)
    return JobError(
        "position-closed",
        Text("a file that calls this machine's position unknown belongs to {user} and cannot be opened", user=user),
        value=str(path),
        advice=Text("remove it as {user}; until then the position is unknown again at each connection", user=user),
    )


def _unwritable(path: Path, error: OSError) -> JobError:
    return JobError(
        "position-unwritable",
        Text("the state of the machine's position cannot be stored: {error}", error=error.strerror or error),
        advice=Text("make room on the disk of {parent}, and see that you may write there", parent=path.parent),
    )
