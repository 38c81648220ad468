# SPDX-License-Identifier: LGPL-2.1-or-later
"""Basic shapes with dimensions: a declaration each, a module a family."""
