# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands run as a person types them."""
