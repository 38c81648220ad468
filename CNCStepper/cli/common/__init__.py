# SPDX-License-Identifier: LGPL-2.1-or-later
"""What verbs share: options, the class of every verb, hints, progress, and how findings are shown."""
