# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the interpreter remembers from block to block: modal state, parameters, stored points."""
