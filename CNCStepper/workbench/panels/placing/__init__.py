# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels of things that are placed on sheets: parts of a nest, programs of an arrangement."""
