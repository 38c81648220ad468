# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sections of the dock, one widget each, and the small parts they are built from."""
