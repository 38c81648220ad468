# SPDX-License-Identifier: LGPL-2.1-or-later
"""Orders of parts: read from files, nested with spyrrow's process beside our own search, written as drawings."""
