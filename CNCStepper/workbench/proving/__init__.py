# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a program to its proof: what can be proven, the proof process, the newest proof, saving."""
