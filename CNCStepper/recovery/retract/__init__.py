# SPDX-License-Identifier: LGPL-2.1-or-later
"""Retract of a held tool along its path: the place on the path, the wire text of a leg, its proof, and the client."""
