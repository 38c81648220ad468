# SPDX-License-Identifier: LGPL-2.1-or-later
"""A session with the process that holds a machine's port: files, socket, server, client, commands and status."""
