# SPDX-License-Identifier: LGPL-2.1-or-later
"""The journal of a job: what may have been sent and what was certainly cut, on the disk before it happens."""
