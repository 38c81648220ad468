# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two programs compared by what their moves do: figures, sentences, picture, and what a window asks for them."""
