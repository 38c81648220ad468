# SPDX-License-Identifier: LGPL-2.1-or-later
"""Active comments with values: (DEBUG, ...), (PRINT, ...) and (LOG, ...).

`#1` and `#<name>` become their values, ###### where there is none; `%d`, `%f` (four decimals) and `%.2f` say how the
values after them are printed, six decimals where nothing is said. What is nearer to 0 than 0.0001 is said as 0.
"""

from __future__ import annotations

import re

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.interpreter.state.system_parameters import SystemParameters
from CNCStepper.gcode.syntax.words import Comment, lower_case
from CNCStepper.tolerances import SAME_NUMBER

_PIECE = re.compile(
    r"%(?P<whole>d)|%(?P<four>f)|%\.(?P<decimals>[0-9])f|%(?=\.)|#<(?P<name>[^>]*)>|#(?P<number>[0-9]+)"
)
_NONE = "######"
_CALLS = {
    "msg": 'MESSAGE("{}")',
    "debug": 'MESSAGE("{}")',
    "log": 'LOG("{}")',
    "logopen": 'LOGOPEN("{}")',
    "logappend": 'LOGAPPEND("{}")',
    "logclose": "LOGCLOSE()",
}


def canonical_call(comment: Comment) -> str:
    """Return a comment as a trace has it."""
    return _CALLS.get(comment.kind, 'COMMENT("{}")').format(comment.text)


def expanded_comment(comment: Comment, known: SystemParameters) -> str:
    """Return a comment's text with the values of the parameters that it names; raises ProgramError for (PY, ...)."""
    if comment.kind == "py":
        what = "this comment would run Python on the machine"
        raise ProgramError("not-supported", what, value="PY", place=Place(column=comment.column), advice="take it out")
    if comment.kind not in ("debug", "print", "log"):
        return comment.text
    decimals = 6

    def piece(match: re.Match[str]) -> str:
        nonlocal decimals
        if match["name"] is not None or match["number"]:
            return _value(match, known, decimals)
        decimals = 0 if match["whole"] else 4 if match["four"] else int(match["decimals"] or decimals)
        return ""

    return _PIECE.sub(piece, comment.text)


def _value(match: re.Match[str], known: SystemParameters, decimals: int) -> str:
    try:
        if match["number"]:
            value = known.number(int(match["number"][:9]))
        else:
            value = known.named(lower_case(re.sub(r"\s", "", match["name"])))
    except ProgramError:
        return _NONE
    return f"{value if abs(value) >= SAME_NUMBER else 0.0:.{decimals}f}"
