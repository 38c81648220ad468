# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all parts of the window share: translation, messages, icons, number formats, processes."""
