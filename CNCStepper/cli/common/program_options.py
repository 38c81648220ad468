# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of every verb that proves a program: its machine, stock, tool, job, start state and dialect."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any

from CNCStepper.cli.common.options import (
    check_stock,
    dialect_name,
    dialect_option,
    job_option,
    machine_option,
    stock_of,
    stock_options,
)
from CNCStepper.cli.common.start_state_options import StartOptions, start_options
from CNCStepper.cli.job_file import is_turning_file, job_and_machine, machine_of_turning
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool

if TYPE_CHECKING:
    from CNCStepper.job.model import Job
    from CNCStepper.simulation.stock import Stock


@dataclass(frozen=True)
class ProgramOptions:
    """The command line's values of these options; `origin` is where on the stock the work zero lies."""

    machine: Machine | None
    stock_mm: tuple[float, float, float] | None
    origin: str
    tool: Tool | None
    job_path: Path | None
    dialect: str | None
    start_options: StartOptions

    @property
    def stock(self) -> Stock | None:
        """The stock that the command line names."""
        return stock_of(self.stock_mm, self.origin)

    def check_stock(self, required: bool = False) -> None:
        """Refuse options that describe the stock twice or in part; raises a usage error."""
        check_stock(self.stock_mm, self.tool, self.job_path, required)

    def job_and_machine(self) -> tuple[Job | None, Machine | None]:
        """Return the job and the machine: the command line's own, else that of the job; of a lathe's job no more."""
        if not self.job_path:
            return None, self.machine
        if is_turning_file(self.job_path):
            return None, self.machine or machine_of_turning(self.job_path)
        job, machine = job_and_machine(self.job_path)
        return job, self.machine or machine

    def dialect_on(self, machine: Machine | None) -> str:
        """Return the dialect of the command line, else that of the machine, else grbl."""
        return dialect_name(self.dialect, machine)


def program_options(machine_required: bool = False) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Return the decorator that adds the options; the function gets their values as `given`."""

    def add(function: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(function)
        def command(
            *arguments: Any,
            machine: Machine | None,
            stock: tuple[float, float, float] | None,
            origin: str,
            tool: Tool | None,
            job_path: Path | None,
            dialect: str | None,
            given: StartOptions,
            **more: Any,
        ) -> Any:
            options = ProgramOptions(machine, stock, origin, tool, job_path, dialect, given)
            return function(*arguments, given=options, **more)

        options = (machine_option(machine_required), stock_options(required=False), job_option, start_options)
        for option in reversed((*options, dialect_option)):
            command = option(command)
        return command

    return add
