# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs for the reader and the writer, and LinuxCNC as their judge."""
