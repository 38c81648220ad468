# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools of files and of the user's library in a job."""
