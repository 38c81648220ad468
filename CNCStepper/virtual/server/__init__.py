# SPDX-License-Identifier: LGPL-2.1-or-later
"""A virtual controller as a program: its serial line, the ports that clients connect to, and its clock."""
