# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job: drawing + operations + machine in, program, proof and report out."""
