# SPDX-License-Identifier: LGPL-2.1-or-later
"""The processes of this package, each started by `python -m`, and the JSON lines over which most of them talk."""
