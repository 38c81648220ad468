# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two tool paths compared: what each has alone, where they differ most, and at which lines they part."""
