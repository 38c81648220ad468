# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sphinx's settings for the manual; tools/manual.py puts it beside the pages, and gives language and version."""

import os

project = "CNCStepper"
author = "CNCStepper"
language = os.environ["CNCSTEPPER_MANUAL_LANGUAGE"]
version = release = os.environ["CNCSTEPPER_MANUAL_VERSION"]
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "index"
myst_heading_anchors = 4
myst_enable_extensions = ["tasklist"]
suppress_warnings = ["misc.highlighting_failure"]  # G-code dialects that Pygments has no lexer for
highlight_language = "none"
html_theme = "alabaster"
html_theme_options = {"description": f"CNCStepper {version}", "page_width": "1100px", "fixed_sidebar": True}
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_show_sourcelink = False
html_show_sphinx = False
html_copy_source = False
