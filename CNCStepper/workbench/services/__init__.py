# SPDX-License-Identifier: LGPL-2.1-or-later
"""Services of the window: translation, messages, icons, number formats, processes."""
