# SPDX-License-Identifier: LGPL-2.1-or-later
# `make demo` and `make test` do all their set-up alone; see tools/setup.sh for what that is.
# Only relative paths here: make cannot hold a path with spaces, this folder may have them.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
.PHONY: help setup demo test matrix quick bench lint translations pictures clean

help:
	@echo "make demo    draw, cut and check the demonstration part in headless FreeCAD and on the virtual grbl"
	@echo "make test    everything: lint, types, all tests, those inside FreeCAD too"
	@echo "make matrix  the tests inside FreeCAD 0.20.2, 1.0.0 and 1.1.3, with and without a window (sets them up; as root)"
	@echo "make quick   the tests that take under 60 s together and need no FreeCAD"
	@echo "make bench   measure speed, beside the programs we compare ourselves with"
	@echo "make lint    style and types only"
	@echo "make translations   collect the texts that a person sees, and compile their Portuguese"
	@echo "make pictures   take the pictures of the window in docs/pictures anew"
	@echo "make setup   only what the others need: system packages and .venv"
	@echo "make clean   remove what tests, demo and benchmarks have made (.venv stays, the FreeCADs of make matrix go)"

setup:
	@tools/setup.sh all

demo: setup
	@.venv/bin/python examples/demo.py

test: setup lint
	@.venv/bin/python -m pytest -n 2 --dist loadfile -m "not freecad"
	@.venv/bin/python -m pytest -m freecad

matrix:
	@tools/setup.sh matrix
	@.venv/bin/python tools/matrix.py

quick:
	@tools/setup.sh python
	@.venv/bin/python -m pytest -n 2 --dist loadfile -m "not slow and not freecad"

bench: setup
	@for script in bench/bench_*.py; do .venv/bin/python "$$script"; done

lint:
	@tools/setup.sh python
	@.venv/bin/python -m ruff check .
	@.venv/bin/python -m ruff format --check .
	@.venv/bin/python -m mypy

translations:
	@tools/setup.sh translations
	@.venv/bin/python tools/translations.py

pictures: setup
	@.venv/bin/python tools/pictures.py

clean:
	@rm -rf build .cache .pytest_cache .mypy_cache .ruff_cache .hypothesis
	@find . -name .venv -prune -o -name __pycache__ -type d -prune -exec rm -rf {} +
