# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table at a parallel port, without hardware: pins, drives, relays and inputs."""
