#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Run tests inside FreeCAD's window: tools/window.sh host|0.20.2|1.0.0|1.1.3 [KIND] [files and options for pytest]
# KIND is plain unless said; scaled, portuguese and bare are told in tests/window_helpers/window_kinds.py.
set -euo pipefail
cd "$(dirname "$0")/.."
exec .venv/bin/python tests/window_helpers/start_window.py "$@"
