# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verbs that send a job and control it while it runs: send, hold, go, stop, override, drive."""
