# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways in which a job file describes shapes."""
