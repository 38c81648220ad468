# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared parts of the verbs: options, the class of every verb, hints, progress, output of findings."""
