# SPDX-License-Identifier: LGPL-2.1-or-later
"""What motors and devices receive: pulses, step letters, port bytes, coils, edges, and their export as text."""
