# SPDX-License-Identifier: LGPL-2.1-or-later
"""Processes of this package: the Python that runs them, how they begin, and the locked file of one that lives."""
