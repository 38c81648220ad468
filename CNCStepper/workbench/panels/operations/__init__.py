# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels of operations have besides the fields of their values."""
