# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print the Debian archive that this machine's own apt uses and that serves a suite.

    tools/apt_archive.py SUITE [FOLDER]      FOLDER holds apt's configuration, /etc/apt unless said

The archives of the component main are tried in apt's order; the first whose Release file of SUITE says main is
printed. Exit 1 with a sentence where none serves it.
"""

from __future__ import annotations

import sys
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit

TIMEOUT_S = 20
FETCHED = ("http", "https", "file")  # debootstrap reads these
LISTED = "mirror+file"  # apt's list of mirrors, one a line
OVERRIDE = "CNCSTEPPER_DEBIAN_MIRROR"


def archives(apt: Path) -> list[str]:
    """Return the URIs of the binary archives with main that are enabled, each once, in apt's order."""
    found: list[str] = []
    for file in (apt / "sources.list", *sorted((apt / "sources.list.d").glob("*"))):
        if file.is_file() and file.suffix in (".list", ".sources"):
            text = file.read_text("utf-8", errors="replace")
            found += _one_line(text) if file.suffix == ".list" else _deb822(text)
    return list(dict.fromkeys(uri.rstrip("/") for each in found for uri in _listed(each)))


def _one_line(text: str) -> Iterator[str]:
    """Yield the archives of lines as `deb [options] URI suite component ...`."""
    for line in text.splitlines():
        kind, _, rest = line.partition("#")[0].strip().partition(" ")
        rest = rest.strip()
        if rest.startswith("["):
            rest = rest.partition("]")[2]
        words = rest.split()
        if kind == "deb" and "main" in words[2:]:
            yield words[0]


def _deb822(text: str) -> Iterator[str]:
    """Yield the archives of stanzas, whose fields may go on in indented lines."""
    for stanza in _stanzas(text):
        enabled = stanza.get("enabled", "yes").lower() not in ("no", "false", "off", "0", "without", "disable")
        if enabled and "deb" in stanza.get("types", "").split() and "main" in stanza.get("components", "").split():
            yield from stanza.get("uris", "").split()


def _stanzas(text: str) -> Iterator[dict[str, str]]:
    stanza: dict[str, str] = {}
    name = ""
    for line in (*text.splitlines(), ""):
        if line.startswith("#"):
            continue
        if not line.strip():
            yield stanza
            stanza, name = {}, ""
        elif line[0] in " \t" and name:
            stanza[name] += " " + line.strip()
        else:
            name, _, value = line.partition(":")
            name = name.strip().lower()
            stanza[name] = value.strip()


def _listed(uri: str) -> list[str]:
    """Return an archive, or those of a list of mirrors, as far as debootstrap can fetch from them."""
    parts = urlsplit(uri)
    if parts.scheme != LISTED:
        return [uri] if parts.scheme in FETCHED else []
    mirrors = Path(parts.path)
    lines = mirrors.read_text("utf-8").splitlines() if mirrors.is_file() else []
    return [each for line in lines if line.strip() and not line.startswith("#") for each in _listed(line.split()[0])]


def serves(archive: str, suite: str) -> bool:
    """Return whether an archive has the component main of a suite."""
    try:
        with urllib.request.urlopen("/".join((archive, "dists", suite, "Release")), timeout=TIMEOUT_S) as answer:
            text = answer.read(100_000).decode("utf-8", "replace")
    except (OSError, ValueError):  # not there, or no such archive: the next one is tried
        return False
    fields = dict(line.partition(":")[::2] for line in text.splitlines() if line[:1].strip())
    names = (fields.get("Suite", "").strip(), fields.get("Codename", "").strip())
    return suite in names and "main" in fields.get("Components", "").split()


def main(suite: str, apt: str = "/etc/apt") -> int:
    """Print the archive for a suite; return the exit status."""
    tried = archives(Path(apt))
    for archive in tried:
        if serves(archive, suite):
            print(archive)
            return 0
    among = f"none of the {len(tried)} archives" if tried else "no archive"
    print(f"{among} in {apt}'s sources serves {suite}: name one that does in {OVERRIDE}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
