# SPDX-License-Identifier: LGPL-2.1-or-later
"""`python -m CNCStepper.cli`, for places where the script is not installed."""

from CNCStepper.cli.main import main

main()
