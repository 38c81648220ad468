# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pip 23 and its system write becomes one sentence with what to do, or a word on how far it is."""

from __future__ import annotations

import pytest

from CNCStepper.workbench.installation.pip_messages import failure, progress

RETRY = "WARNING: Retrying (Retry(total=0, connect=None)) after connection broken by '{}': /simple/pyserial/\n"
NOTHING = (
    "ERROR: Could not find a version that satisfies the requirement pyserial==3.5 (from versions: none)\n"
    "ERROR: No matching distribution found for pyserial==3.5\n"
)
UNNAMED = (
    "NewConnectionError('<HTTPSConnection at 0x7f>: Failed to establish a new connection: [Errno -2] Name or service"
)
PROXY = "ProxyError('Cannot connect to proxy.', NewConnectionError('[Errno 111] refused'))"
REFUSED = "SSLError(SSLCertVerificationError(1, '[SSL: CERTIFICATE_VERIFY_FAILED]'))"
OUTPUTS = {
    "pip-offline": RETRY.format(UNNAMED + " not known')") + NOTHING,
    "pip-proxy": RETRY.format(PROXY) + NOTHING,
    "pip-certificate": RETRY.format(REFUSED) + NOTHING,
    "pip-missing": "ERROR: No module named pip\n",
    "pip-wheels": "ERROR: no wheels in /home/ana/Downloads\n",
    "pip-zip": "ERROR: File is not a zip file\n",
    "pip-disk-full": "ERROR: Could not install packages due to an OSError: [Errno 28] No space left on device\n",
    "pip-in-use": "ERROR: [WinError 32] The process cannot access the file: 'shapely'\n",
    "pip-folder": "ERROR: [Errno 13] Permission denied: '/home/ana/.local/share/FreeCAD/AdditionalPythonPackages'\n",
    "pip-no-wheel": NOTHING,
}  # fmt: skip


@pytest.mark.parametrize(("code", "output"), OUTPUTS.items(), ids=[*OUTPUTS])
def test_the_cause_is_named_with_what_to_do(code: str, output: str) -> None:
    error = failure(output, "3.11", "Linux", from_files=False)
    assert error.code == code
    assert error.advice
    assert "Errno" not in error.sentence


def test_what_has_no_wheel_is_named() -> None:
    online = failure(NOTHING, "3.15", "Darwin", from_files=False)
    assert online.what == "there is no pyserial==3.5 for Python 3.15 on Darwin"
    offline = failure(NOTHING, "3.13", "Linux", from_files=True)
    assert offline.what == "the folder or zip has no pyserial==3.5 for Python 3.13 on Linux"
    assert "make installer PYTHONS=3.13" in offline.advice


def test_what_is_not_known_is_quoted() -> None:
    error = failure("Collecting a\nERROR: ResolutionImpossible: a and b\nmore\n", "3.11", "Linux", from_files=False)
    assert error.code == "pip-failed"
    assert "ResolutionImpossible: a and b" in error.what
    assert failure("", "3.11", "Linux", from_files=False).what.endswith(": -")


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("  Downloading numba-0.68.1-cp311-cp311-win_amd64.whl (3.9 MB)", "Fetching numba (3.9 MB)"),
        ("Processing /home/ana/wheels/shapely-2.2.0-cp311-cp311-manylinux_2_28_x86_64.whl", "Fetching shapely"),
        (r"Processing c:\users\ana\wheels\pyserial-3.5-py2.py3-none-any.whl", "Fetching pyserial"),
        ("Installing collected packages: numpy, shapely", "Writing 2 packages"),
        ("Looking in links: /home/ana/wheels", None),
    ],
)
def test_progress_is_what_pip_fetches_and_writes(line: str, expected: str | None) -> None:
    assert progress(line) == expected
