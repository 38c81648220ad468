# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire text: the lines that are sent, with the map to the lines of the file, and its reading back."""
