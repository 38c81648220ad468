# SPDX-License-Identifier: LGPL-2.1-or-later
"""A controller's `$` settings as a whole: their names, backups, comparison, restoring, and the profile they make."""
