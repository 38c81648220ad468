# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pip writes, as sentences for a designer: how far it is, and what went wrong with what to do."""

from __future__ import annotations

import re
from collections.abc import Iterable

from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.workers.package_installer import NO_PIP, NO_WHEELS

FETCHING = re.compile(r"^\s*(?:Downloading|Using cached|Processing) (?P<file>\S+)(?: \((?P<size>[\d.]+ \w+)\))?")
WRITING = re.compile(r"^\s*Installing collected packages: (?P<packages>.+)")
NO_VERSION = re.compile(r"No matching distribution found for (?P<package>\S+)")
TAKE_ZIP = Text("or press 'From files' and take the zip that 'make installer' has built on a computer with internet")
CAUSES = (  # the first that occurs in the output is the cause; what follows in pip's output follows from it
    (
        re.escape(NO_PIP),
        "pip-missing",
        Text("the Python that belongs to this FreeCAD has no pip"),
        Text(
            "install it (Debian and Ubuntu: sudo apt-get install python3-pip), {zip}, which brings a pip", zip=TAKE_ZIP
        ),
    ),
    (
        re.escape(NO_WHEELS),
        "pip-wheels",
        Text("there are no packages in the folder or zip"),
        Text("choose the zip of 'make installer', or the folder in which its .whl files are"),
    ),
    (
        r"not a zip file|Bad magic number|Bad CRC-32|End-of-central-directory",
        "pip-zip",
        Text("the zip is damaged or not whole"),
        Text("copy it again and compare its size"),
    ),
    (
        r"ProxyError|Cannot connect to proxy|Tunnel connection failed|407 Proxy",
        "pip-proxy",
        Text("the proxy of this network does not let pip through"),
        Text(
            "enter the proxy in FreeCAD (Preferences > Addon Manager) with its name and password, as "
            "http://name:password@host:port, {zip}",
            zip=TAKE_ZIP,
        ),
    ),
    (
        r"CERTIFICATE_VERIFY_FAILED|SSLError|SSL: ",
        "pip-certificate",
        Text("the secure connection to the package index was refused, as in a network that looks into it"),
        Text(
            "check the computer's clock, ask who runs the network for its certificate and set the environment variable "
            "PIP_CERT to that file, {zip}",
            zip=TAKE_ZIP,
        ),
    ),
    (
        r"NewConnectionError|NameResolutionError|name resolution|getaddrinfo failed|Name or service not known"
        r"|nodename nor|Network is unreachable|ConnectTimeout|Read timed out|ReadTimeout|Connection refused"
        r"|ConnectionResetError|RemoteDisconnected|ProtocolError",
        "pip-offline",
        Text("the package index cannot be reached"),
        Text("connect to the internet and try again, {zip}", zip=TAKE_ZIP),
    ),
    (
        r"No space left on device|Errno 28|WinError 112",
        "pip-disk-full",
        Text("the disk is full"),
        Text("make room (the packages take about 400 MB) and try again"),
    ),
    (
        r"WinError 32|WinError 5\b|being used by another process",
        "pip-in-use",
        Text("a package that is to be replaced is in use"),
        Text("close all FreeCAD windows, start FreeCAD, and install before anything else"),
    ),
    (
        r"Permission denied|Errno 13|Read-only file system|Errno 30",
        "pip-folder",
        Text("the folder for packages cannot be written"),
        Text("make the folder writable for yourself; nothing needs an administrator"),
    ),
)


def progress(line: str) -> Text | None:
    """Return how far pip is by a line of its output, None where it says nothing of it."""
    if found := FETCHING.match(line):
        name = re.split(r"[\\/]", found["file"])[-1].partition("-")[0]
        size = found["size"]
        return Text("Fetching {name} ({size})", name=name, size=size) if size else Text("Fetching {name}", name=name)
    if found := WRITING.match(line):
        return Text("Writing {count} packages", count=len(found["packages"].split(", ")))
    return None


def failure(output: str, version: str, system: str, from_files: bool) -> CNCStepperError:
    """Return why pip failed, by all that it has written.

    version: of FreeCAD's Python, "3.11". system: as platform.system() calls it. from_files: whether wheels were given.
    """
    for pattern, code, what, advice in CAUSES:
        if re.search(pattern, output):
            return CNCStepperError(code, what, advice=advice)
    if lacking := NO_VERSION.findall(output):
        return _no_wheel(lacking, version, system, from_files)
    return CNCStepperError(
        "pip-failed",
        Text("pip could not install the packages: {said}", said=_last_error(output.splitlines())),
        advice="look at the details, and report them where they do not help",
    )


def _no_wheel(lacking: list[str], version: str, system: str, from_files: bool) -> CNCStepperError:
    values = {"packages": ", ".join(sorted(set(lacking))), "version": version, "system": system}
    if from_files:
        return CNCStepperError(
            "pip-no-wheel",
            Text("the folder or zip has no {packages} for Python {version} on {system}", **values),
            advice=Text("build the zip for it: make installer PYTHONS={version}", version=version),
        )
    return CNCStepperError(
        "pip-no-wheel",
        Text("there is no {packages} for Python {version} on {system}", **values),
        advice="use a FreeCAD of freecad.org, whose Python has all packages",
    )


def _last_error(lines: Iterable[str]) -> str:
    lines = [line for line in lines if line.strip()]
    errors = [line.partition("ERROR:")[2].strip() for line in lines if line.startswith("ERROR:")]
    return (errors or lines or ["-"])[-1]
