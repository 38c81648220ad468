# SPDX-License-Identifier: LGPL-2.1-or-later
"""The checks of a program before it is sent, one module a subject, and the report of their findings."""
