# SPDX-License-Identifier: LGPL-2.1-or-later
"""The model of the editor's text: words and their meanings, changed lines, errors. It knows no Qt."""
