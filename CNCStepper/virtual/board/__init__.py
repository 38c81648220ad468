# SPDX-License-Identifier: LGPL-2.1-or-later
"""A USB board with four stepper motors, without hardware: its FIFO, its latches and the motors' coils."""
