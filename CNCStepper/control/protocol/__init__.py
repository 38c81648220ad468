# SPDX-License-Identifier: LGPL-2.1-or-later
"""The protocols of controllers, a folder for each controller family."""
