# SPDX-License-Identifier: LGPL-2.1-or-later
"""Orders: many drawings made, nested, proven and priced, by processes here or by the workers of a cluster."""
