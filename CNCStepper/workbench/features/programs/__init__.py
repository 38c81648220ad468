# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects that make one program of several."""
