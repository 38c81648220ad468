# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a drawing to a cut part on stepper-driven machines."""

__version__ = "0.1.0"
