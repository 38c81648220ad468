# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the editor knows of its text: words and their meanings, changed lines, errors. It knows no Qt."""
