# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program that is sent: its certificate, its wire lines, and the bundle that holds them on the disk."""
