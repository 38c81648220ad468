# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person does at the machine: actions, homing, jogging, console lines and the machine's buttons."""
