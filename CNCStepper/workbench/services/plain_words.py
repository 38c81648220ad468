# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages without what only programs need: error codes, numbers of the operating system, the scheme of an address.

"The link to socket://10.0.0.2:23 broke: [Errno 32] Broken pipe [link-lost]" is for a person
"The link to 10.0.0.2:23 broke: Broken pipe".
"""

from __future__ import annotations

import re

from CNCStepper.errors import NUMBER_OF_SYSTEM

SCHEME = "socket://"  # the one that an address typed without has
CODE = re.compile(r" \[[a-z0-9]+(?:-[a-z0-9]+)+\](?=[.;,)]|$)")  # a controller's own words have capitals or a colon
ADDRESS = re.compile(r"[\w.-]+:\d+|\[[0-9a-fA-F:]+\]:\d+")


def plain(text: str) -> str:
    """Return a message without codes, numbers of errors and `socket://`."""
    return CODE.sub("", NUMBER_OF_SYSTEM.sub("", text)).replace(SCHEME, "")


def port_of_address(typed: str) -> str:
    """Return the port that a typed text means: "10.0.0.2:23" is an address on the network."""
    return f"{SCHEME}{typed}" if ADDRESS.fullmatch(typed) else typed
