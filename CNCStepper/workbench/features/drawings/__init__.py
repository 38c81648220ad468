# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects that are drawn or brought in: imported drawings, texts, shapes of the library."""
