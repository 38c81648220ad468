# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a drawing to a cut part on stepper-driven machines.

The names in `__all__` are the stable Python interface; docs/reference/python.md has examples. Each is loaded when it is
first used, so that `import CNCStepper` costs nothing.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from CNCStepper.api import make, prove, send
    from CNCStepper.errors import CNCStepperError
    from CNCStepper.gcode.interpreter.interpret import interpret
    from CNCStepper.gcode.writer.write import write
    from CNCStepper.job.model import Job
    from CNCStepper.machine.profile import Machine

__version__ = "0.1.0"
__all__ = ["CNCStepperError", "Job", "Machine", "interpret", "make", "prove", "send", "write"]

_MODULES = {
    "CNCStepperError": "CNCStepper.errors",
    "Job": "CNCStepper.job.model",
    "Machine": "CNCStepper.machine.profile",
    "interpret": "CNCStepper.gcode.interpreter.interpret",
    "make": "CNCStepper.api",
    "prove": "CNCStepper.api",
    "send": "CNCStepper.api",
    "write": "CNCStepper.gcode.writer.write",
}


def __getattr__(name: str) -> Any:
    """Load a name of the interface when it is first used."""
    if name not in _MODULES:
        raise AttributeError(f"module 'CNCStepper' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_MODULES[name]), name)


def __dir__() -> list[str]:
    """Return the names of the module, those too that are not loaded yet."""
    return sorted({*globals(), *__all__})
