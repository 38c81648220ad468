# SPDX-License-Identifier: LGPL-2.1-or-later
"""JSON and TOML files, and what is wrong in their content."""
