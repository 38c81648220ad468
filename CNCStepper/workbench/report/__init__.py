# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a job on paper: what it is, its operations with tool and time, its path, and its program."""
