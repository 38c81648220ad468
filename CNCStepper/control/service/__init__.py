# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs in the background at a machine: the connection service with its clients, and the sender of one job."""
