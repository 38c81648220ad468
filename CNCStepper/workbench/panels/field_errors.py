# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refusals of values by core, stock and machine, as sentences at the fields; the rules are in the core."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Any

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.files.validation_errors import message_of
from CNCStepper.quantities import ERROR_TYPE
from CNCStepper.workbench.document.input_limits import limits_passed
from CNCStepper.workbench.features.base import JOB, LATHE_JOB, proxy_type
from CNCStepper.workbench.features.cycle_operation import LINKS, jobs_of
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.services.translation import later

LIMITS = {
    "greater_than": ("gt", later("must be above {0}")),
    "greater_than_equal": ("ge", later("must be at least {0}")),
    "less_than": ("lt", later("must be below {0}")),
    "less_than_equal": ("le", later("must be at most {0}")),
}
BY_CODE = {  # of errors that speak of several keys
    "chart-material": "material",
    "chart-thickness": "stock_size_mm",
    "chart-consumable": "consumable",
    "chart-feed": "feed_mm_min",
    "process-machine": "process",
    "tool-shape": "tool",
    "font-unknown": "font",
    "font-style": "style",
    "text-glyph": "text",
    "text-script": "text",
    "text-empty": "text",
    **dict.fromkeys(("blade-width", "groove-width"), "width_mm"),
    **dict.fromkeys(("groove-depth", "thread-crest", "thread-wide", "taper-wide"), "diameter_mm"),
    **dict.fromkeys(("groove-outside", "part-outside", "thread-outside", "taper-outside"), "z_mm"),
    "taper-axis": "angle_deg",
    **dict.fromkeys(("drill-deep", "drill-reach"), "depth_mm"),
    **dict.fromkeys(("thread-length", "thread-cylinder"), "length_mm"),
    "thread-axis": "taper_deg",
    **dict.fromkeys(("thread-speed", "speed-missing", "speed-high", "speed-low"), "spindle_rpm"),
    **dict.fromkeys(("feed-missing", "feed-high", "feed-low"), "feed_mm_rev"),
    "ap-high": "ap_mm",
    "face-outside": "to_z_mm",
    "face-diameter": "to_diameter_mm",
    "surface-speed": "constant_surface_speed",
    **dict.fromkeys(
        ("profile-outside", "profile-begin", "profile-end", "profile-chuck", "bore-wide", "bore-deep"), "drawings"
    ),
    **dict.fromkeys(("profile-axis", "profile-crossing", "profile-undercut", "profile-several"), "drawings"),
    **dict.fromkeys(("profile-missing", "profile-chains", "profile-closed"), "drawings"),
    "bore-missing": "tool",
    **dict.fromkeys(("blade-tool", "blade-reach", "drill-tool", "drill-wide", "face-tool", "part-tool"), "tool"),
    **dict.fromkeys(
        ("thread-tool", "thread-hand", "thread-insert", "profile-tool", "bore-tool", "bore-narrow"), "tool"
    ),
    **dict.fromkeys(("insert-front", "insert-back", "nose-radius"), "tool"),
}
NOT_BETWEEN = later("must be 0, or at least {0}")
SENTENCES = {
    "depth": later("goes far beyond the stock; at most {0}"),
    "travel": later("exceeds the machine's travel; at most {0}"),
    "width": later("goes far beyond the stock and the machine; at most {0}"),
    "feed": later("goes far beyond the machine's fastest axis; at most {0}"),
}


def model_of_type(obj: Any) -> Any:
    """Return the core's model of the parameters of one of our objects, or None where the core has none."""
    if proxy_type(obj) == "CNCStepper_Tool":
        from CNCStepper.machine.tools.tool import Tool

        return Tool
    if proxy_type(obj) == "CNCStepper_Job":
        from CNCStepper.job.model import Job

        return Job
    if proxy_type(obj) == LATHE_JOB:
        from CNCStepper.job.turning.turning_job import TurningJob

        return TurningJob
    if proxy_type(obj) == "CNCStepper_TurningTool":
        from CNCStepper.machine.tools.turning_tool import TurningTool

        return TurningTool
    if proxy_type(obj) == "CNCStepper_Drawing":
        from CNCStepper.job.shape_forms.drawing_form import DrawingForm

        return DrawingForm
    if proxy_type(obj) == "CNCStepper_Text":
        from CNCStepper.job.shape_forms.text_form import TextForm

        return TextForm
    if proxy_type(obj) == "CNCStepper_Slices":
        from CNCStepper.job.slicing.slice_form import SliceForm

        return SliceForm
    if proxy_type(obj) == "CNCStepper_Nest":
        from CNCStepper.job.nesting.nest_form import NestForm

        return NestForm
    if proxy_type(obj) == "CNCStepper_Arrangement":
        from CNCStepper.job.editing.arrange_form import ArrangeForm

        return ArrangeForm
    if not getattr(obj.Proxy, "CYCLE", ""):
        return None
    if obj.Proxy.JOB_TYPE == LATHE_JOB:
        from CNCStepper.cycles.turning.turning_operation import turning_operation_class

        return turning_operation_class(obj.Proxy.CYCLE)
    from CNCStepper.cycles.catalogue import cycle_class

    return cycle_class(obj.Proxy.CYCLE)


def complaints(model: Any, values: dict[str, Any], shown: Callable[[str, float], str]) -> dict[str, Refused]:
    """Return what a pydantic model has against single values, by key; what is not in `values` is not judged.

    A value in a table is known by both names: "tabs_count" is "count" in the table "tabs".
    shown: gives a limit as the user reads it, from a key and a number in the unit of that key.
    """
    from pydantic import ValidationError

    tables = {key: value for key, value in values.items() if isinstance(value, dict)}
    keys = {*values, *(f"{table}_{key}" for table, content in tables.items() for key in content)}
    try:
        model.model_validate({key: value for key, value in values.items() if key in model.model_fields})
    except ValidationError as error:
        found = [(_key_at(problem["loc"]), problem) for problem in error.errors() if problem["loc"]]
        return {key: sentence_of(key, problem, shown) for key, problem in reversed(found) if key in keys}
    return {}


def _key_at(place: tuple[Any, ...]) -> str:
    """Return the key of a place in a model; in between may stand the name of a kind, at the end a row's number."""
    names = [part for part in place if isinstance(part, str)]
    return names[0] if len(names) == 1 else f"{names[0]}_{names[-1]}"


def sentence_of(key: str, problem: Any, shown: Callable[[str, float], str]) -> Refused:
    """Return what one of pydantic's errors says of the value of a key; `shown` as for `complaints`."""
    if problem["type"] in LIMITS:
        name, sentence = LIMITS[problem["type"]]
        return Refused(sentence, shown(key, problem["ctx"][name]))
    if problem["type"] == ERROR_TYPE and isinstance(problem["input"], int | float):
        return _out_of_bounds(key, problem["input"], problem["ctx"], shown)
    return Refused("{0}", message_of(problem))


def _out_of_bounds(key: str, value: float, bounds: Any, shown: Callable[[str, float], str]) -> Refused:
    """Return what a number beyond the bounds of its quantity must be; they stand in the context of pydantic's error."""
    if value > bounds["high"]:
        return Refused(LIMITS["less_than_equal"][1], shown(key, bounds["high"]))
    if bounds["zero"] and value > 0:
        return Refused(NOT_BETWEEN, shown(key, bounds["low"]))
    return Refused(LIMITS["greater_than_equal"][1], shown(key, 0.0 if bounds["zero"] else bounds["low"]))


def key_of(error: CNCStepperError, keys: Iterable[str]) -> str:
    """Return the one key that a sentence of the core speaks of first ("stepover_mm (ae) is larger than the tool")."""
    keys = list(keys)
    if BY_CODE.get(error.code) in keys:
        return BY_CODE[error.code]
    places = {key: match.start() for key in keys if (match := _word(key).search(error.what))}
    return min(places, key=places.__getitem__) if places else ""


def labelled(sentence: str, labels: dict[str, str]) -> str:
    """Return a sentence of the core with the labels that a person sees in place of the keys."""
    keys = {key: label for key, label in labels.items() if "_" in key}
    return re.sub(r"\w+", lambda word: f"“{keys[word[0]]}”" if word[0] in keys else word[0], sentence)


def _word(key: str) -> re.Pattern[str]:
    stem = re.sub("_(mm|mm_min|deg|rpm)$", "", key)
    return re.compile(rf"\b({key}|{stem})\b")


def beyond(obj: Any, changes: dict[str, Any], shown: Callable[[str, float], str]) -> dict[str, Refused]:
    """Return what of some changed values goes beyond stock or machine of the object's job, by key.

    shown: gives a limit as the user reads it, from a key and a number in the unit of that key.
    """
    job = obj if proxy_type(obj) == JOB else next((other for other in obj.InList if proxy_type(other) == JOB), None)
    if job is None or not changes:
        return {}
    passed = limits_passed(job, {key: value for key, value in changes.items() if key not in LINKS})
    return {key: Refused(SENTENCES[limit.reason], shown(key, limit.most)) for key, limit in passed.items()}


def stock_findings_of(obj: Any) -> list[Any]:
    """Return the findings for an operation in its stock with the values that it has now, the worst first.

    None for what is no operation, belongs to no job, or is refused for another reason, which its panel says.
    """
    is_milled = getattr(obj.Proxy, "CYCLE", "") and obj.Proxy.JOB_TYPE == JOB
    jobs = jobs_of(obj) if is_milled else []
    if not jobs:
        return []
    from CNCStepper.job.stock_fit import stock_findings
    from CNCStepper.workbench.document.stock_of_job import stock_of

    try:
        cycle = obj.Proxy.cycle(obj, tuple(jobs[0].WorkOrigin))
        return stock_findings(cycle, stock_of(jobs[0]))
    except CNCStepperError:  # the panel says it beside its field
        return []
