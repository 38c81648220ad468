# SPDX-License-Identifier: LGPL-2.1-or-later
"""Editing of programs: each verb takes a text and gives an `Edited`, which keeps all that need not change."""
