# SPDX-License-Identifier: LGPL-2.1-or-later
"""The turned part as a lathe program cuts it, exactly, in the half plane of Z and radius."""
