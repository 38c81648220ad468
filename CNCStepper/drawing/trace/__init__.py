# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tracing of pictures: contours of dark areas."""
