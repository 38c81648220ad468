# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files are written by `whole_file` alone: whole or not at all. What else writes is listed with its reason."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "CNCStepper"

METHODS = {"write_text", "write_bytes", "savefig", "savez", "savez_compressed", "savetxt", "tofile"}
FUNCTIONS = {"imsave", "copyfile", "copy2", "fdopen", "NamedTemporaryFile", "mkstemp", "write_history_file"}
PRIVATE = "a folder of 0700 that mkdtemp made, for one worker and its client"
OWN_STATE = "the user's own state folder of 0700, by O_EXCL"
BUFFER = "into memory, then whole"
REASONS = {
    "control/pulses/output_ports": "a recording that grows while pulses are sent, never over a file that is none",
    "control/pulses/parallel_port": "the device of a parallel port; it is no file",
    "control/pulses/pulse_ring": "memory that two processes share, of a file that loses its name at once",
    "atomic_file": "the one writer",
    "kernel_cache": "the user's own cache, below every other room; moved there as a whole",
    "cli/machine/console": "the line history of the user's own state folder, by readline",
    "control/journal/writer": "O_EXCL; a journal grows line by line and is never replaced",
    "control/session/detached_process": "O_EXCL; a log that grows",
    "cli/program/check": "a temporary folder of 0700 that goes when it is read",
    "control/session/files": OWN_STATE,
    "control/program/bundle": OWN_STATE,
    "job/editing/path_segments": PRIVATE,
    "workers/program_editor": PRIVATE,
    "workbench/macro": PRIVATE,
    "control/processes/process_file": (
        "the session's own file in a folder of 0700, open and locked for as long as its process lives"
    ),
    "job/proof_folder": PRIVATE,
    "job/turning/turned_groups_file": PRIVATE,
    "job/turning/turning_proof_folder": PRIVATE,
    "simulation/meshes/fallen_faces": PRIVATE,
    "recovery/restart/restart_proof_folder": PRIVATE,
    "job/start_state_file": PRIVATE,
    "workers/simulation_timeline": PRIVATE,
    "simulation/tip_track": PRIVATE,
    "workbench/editor/reader_client": PRIVATE,
    "workbench/document/program_file": PRIVATE,
    "workbench/dock/virtual_controller": "a log in the user's own state folder of 0700, under a random name",
    "control/protocol/lathe/serial_port": "a recording that grows while bytes are sent, never over another file",
    "job/batch/task_files": PRIVATE,
    "job/batch/task_journal": "it grows task by task, under a lock",
    "workers/batch_worker": "the process's own standard output",
    "job/batch/offer": BUFFER,
    "simulation/views/readings_plot": BUFFER,
    "workbench/machines/machine_test_view": BUFFER,
    "simulation/views/picture_style": BUFFER,
    "simulation/views/paper_sheet": BUFFER,
}


def writing_calls(source: str) -> Iterator[str]:
    """Yield each call in `source` that may write a file."""
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.Call):
            continue
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        moves = ast.unparse(node.func) == "shutil.move"
        if moves or name in METHODS | FUNCTIONS or (name == "open" and _writes(node)):
            yield f"{node.lineno}: {ast.unparse(node)[:80]}"


def _writes(call: ast.Call) -> bool:
    """Return whether a call of `open` names a mode or flags that write."""
    of_path = isinstance(call.func, ast.Attribute) and ast.unparse(call.func.value) not in ("os", "io", "builtins")
    values = [
        *call.args[0 if of_path else 1 :],
        *(word.value for word in call.keywords if word.arg in ("mode", "flags")),
    ]
    flags = [node.attr for value in values for node in ast.walk(value) if isinstance(node, ast.Attribute)]
    modes = [value.value for value in values if isinstance(value, ast.Constant) and isinstance(value.value, str)]
    return bool({"O_WRONLY", "O_RDWR", "O_CREAT"} & set(flags)) or any(set("wax+") & set(mode) for mode in modes[:1])


def modules() -> dict[str, Path]:
    return {path.relative_to(PACKAGE).with_suffix("").as_posix(): path for path in sorted(PACKAGE.rglob("*.py"))}


@pytest.mark.slow
def test_files_are_written_whole() -> None:
    found = [
        f"{module}:{call}"
        for module, path in modules().items()
        if module not in REASONS
        for call in writing_calls(path.read_text("utf-8"))
    ]
    assert not found, "use CNCStepper.atomic_file: " + "\n".join(found)


@pytest.mark.slow
def test_every_reason_is_still_needed() -> None:
    idle = [module for module in REASONS if not list(writing_calls(modules()[module].read_text("utf-8")))]
    assert not idle, idle


@pytest.mark.parametrize(
    "statement",
    [
        "path.write_text('x')",
        "path.write_bytes(b'')",
        "path.open('wb')",
        "open(path, 'w')",
        "open(path, mode='a')",
        "path.open(mode='x')",
        "io.open(path, 'r+b')",
        "os.open(path, os.O_WRONLY | os.O_CREAT)",
        "figure.savefig(path)",
        "np.savez(path, a=a)",
        "shutil.move(a, b)",
    ],
)
def test_the_wall_sees_a_planted_writer(statement: str) -> None:
    assert list(writing_calls(statement))


@pytest.mark.parametrize("statement", ["path.open('rb')", "open(path)", "os.open(folder, os.O_RDONLY)", "path.open()"])
def test_the_wall_lets_readers_through(statement: str) -> None:
    assert not list(writing_calls(statement))
