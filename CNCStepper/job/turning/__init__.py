# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs of a lathe: the job file, its profiles, the program made of it."""
