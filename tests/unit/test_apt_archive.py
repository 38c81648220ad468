# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Debian of the matrix comes from the archive of the machine's own apt sources; the project names none."""

from __future__ import annotations

import subprocess
from pathlib import Path
from shlex import quote
from typing import Any

import pytest

from helpers.tools import load

ROOT = Path(__file__).parents[2]


@pytest.fixture
def tool() -> Any:
    return load("apt_archive")


@pytest.fixture
def apt(tmp_path: Path) -> Path:
    folder = tmp_path / "apt"
    (folder / "sources.list.d").mkdir(parents=True)
    return folder


def serve(folder: Path, suite: str, codename: str, components: str = "main contrib") -> str:
    """Make an archive on this disk; return its URI."""
    release = folder / "dists" / suite / "Release"
    release.parent.mkdir(parents=True)
    release.write_text(f"Origin: Debian\nSuite: {suite}\nCodename: {codename}\nComponents: {components}\nSHA256:\n x\n")
    return folder.as_uri()


def test_both_forms_of_sources_are_read_in_apts_order(tool: Any, apt: Path) -> None:
    (apt / "sources.list").write_text(
        "# deb http://commented/debian trixie main\n"
        "deb-src http://source/debian trixie main\n"
        "deb [arch=amd64 signed-by=/a b.gpg] http://first/debian/ trixie main contrib # ours\n"
        "deb http://tools/apt tool-trixie extra\n"
        "deb cdrom:[Debian 13]/ trixie main\n"
    )
    (apt / "sources.list.d" / "debian.sources").write_text(
        "Types: deb deb-src\n# a remark\nURIs: http://second/debian\n  https://third/debian\nSuites: trixie\n"
        "Components: contrib\n main\n\nEnabled: no\nTypes: deb\nURIs: http://off/debian\nSuites: x\n"
        "Components: main\n\n"
        "Types: deb-src\nURIs: http://sources-only/debian\nSuites: x\nComponents: main\n"
    )
    (apt / "sources.list.d" / "old.sources.disabled").write_text("Types: deb\nURIs: http://no/\nComponents: main\n")
    expected = ["http://first/debian", "http://second/debian", "https://third/debian"]
    assert tool.archives(apt) == expected


def test_a_list_of_mirrors_is_followed(tool: Any, apt: Path, tmp_path: Path) -> None:
    mirrors = tmp_path / "mirrors.list"
    mirrors.write_text("# ours\nhttp://near/debian\tpriority:1\nhttp://far/debian\n")
    (apt / "sources.list").write_text(f"deb mirror+file:{mirrors} trixie main\n")
    assert tool.archives(apt) == ["http://near/debian", "http://far/debian"]


def test_the_first_archive_that_serves_the_suite_is_printed(
    tool: Any, apt: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = serve(tmp_path / "other", "nodistro", "nodistro")
    security = serve(tmp_path / "security", "forky", "forky-security", "updates")
    main = serve(tmp_path / "main", "forky", "forky")
    named = serve(tmp_path / "named", "testing", "forky")
    lines = "".join(f"deb {uri} bookworm main\n" for uri in ("http://127.0.0.1:1/debian", other, security, main, named))
    (apt / "sources.list").write_text(lines)
    assert tool.main("forky", str(apt)) == 0
    assert capsys.readouterr().out == f"{main}\n"


def test_where_none_serves_it_the_override_is_named(
    tool: Any, apt: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert tool.main("forky", str(apt)) == 1
    (apt / "sources.list").write_text(f"deb {serve(tmp_path / 'a', 'sid', 'sid')} sid main\n")
    assert tool.main("forky", str(apt)) == 1
    said = capsys.readouterr().err.splitlines()
    assert "no archive" in said[0] and "none of the 1 archives" in said[1]
    assert all("CNCSTEPPER_DEBIAN_MIRROR" in line for line in said)


def test_no_tracked_file_names_an_archive_a_snapshot_or_a_registry() -> None:
    hosts = [
        r"(deb|ftp|snapshot|security|archive)\.(debian|ubuntu)\.",
        r"(pypi|pythonhosted)\.org",
        r"anaconda\.(org|com)",
    ]
    pattern = "|".join(hosts)
    found = subprocess.run(["git", "grep", "-nIiE", pattern], cwd=ROOT, capture_output=True, text=True)
    assert found.returncode in (0, 1), found.stderr
    lines = [line for line in found.stdout.splitlines() if not line.startswith("tests/unit/test_apt_archive.py:")]
    assert not lines, "\n".join(lines)


def test_the_set_up_takes_what_is_printed(tmp_path: Path) -> None:
    script = (ROOT / "tools" / "freecad_root.sh").read_text("utf-8")
    found = script[script.index("find_mirror() {") : script.index("\nremove()")]
    tools, project = quote(str(ROOT / "tools")), quote(str(tmp_path))
    run = f"mirror=$1 suite=nosuch here={tools} project={project} log={project}/log\n"
    run += 'fail() { echo "$*"; exit 1; }\n'
    (tmp_path / ".venv" / "bin").mkdir(parents=True)
    (tmp_path / ".venv" / "bin" / "python").write_text('#!/bin/sh\necho "http://printed/$2"\n')
    (tmp_path / ".venv" / "bin" / "python").chmod(0o755)
    for override, mirror in (("", "http://printed/nosuch"), ("http://own/debian", "http://own/debian")):
        command = ["bash", "-c", f"{run}{found}\nfind_mirror; echo $mirror", "bash", override]
        assert subprocess.run(command, capture_output=True, text=True).stdout == f"{mirror}\n"
