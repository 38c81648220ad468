# SPDX-License-Identifier: LGPL-2.1-or-later
# `make demo` and `make test` do all their set-up alone; see tools/setup.sh for what that is.
# Only relative paths here: make cannot hold a path with spaces, this folder may have them.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
# The tests start many a Python: each would compile anew what it loads, some 10 s of `make quick`.
unexport PYTHONDONTWRITEBYTECODE
.PHONY: help setup demo test matrix quick soak monkey fuzz bench bench-guard lint translations pictures manual installer clean

help:
	@echo "make demo    draw, cut and check the demonstration part in headless FreeCAD and on the virtual grbl"
	@echo "make test    lint, types, all tests but those of FreeCAD's window, which make matrix runs"
	@echo "make matrix  the tests inside FreeCAD 0.20.2, 1.0.0 and 1.1.3, with and without a window (sets them up; as root)"
	@echo "make quick   the tests that take under 60 s together and need no FreeCAD"
	@echo "make soak    the random cases of every cycle, 500 each in place of 25, and 5000 sends under faults (hours); RUNS=n takes another number"
	@echo "make monkey  20 000 random clicks, keys, values and commands in FreeCAD's window, each walk recorded as a macro and run again (STEPS=n, SEED=n; hours)"
	@echo "make fuzz    100 000 hostile programs for the reader (CASES=n), $(FILES) mutated jobs and profiles, a quarter of it tool files and drawings (FILES=n), then atheris looks for more for FUZZ_S=300 seconds"
	@echo "make bench   measure speed, beside the programs we compare ourselves with"
	@echo "make bench-guard   compare these ratios with those recorded last; name what fell by more than 10 %"
	@echo "make lint    style and types only"
	@echo "make translations   collect the texts that a person sees, and compile their Portuguese"
	@echo "make pictures   take the pictures in docs/pictures anew: of every cycle, of the worked parts, and of the window"
	@echo "make manual   build the manual in English and Portuguese, HTML and PDF: build/manual/en, build/manual/pt_BR"
	@echo "make installer   build the zip of packages for 'Install packages…' on a FreeCAD without internet (PYTHONS=\"3.11 3.13\" takes others)"
	@echo "make setup   only what the others need: system packages and .venv"
	@echo "make clean   remove what tests, demo and benchmarks have made (.venv and the FreeCADs of make matrix, which all checkouts share, stay)"

setup:
	@tools/setup.sh all

demo: setup
	@.venv/bin/python examples/demo.py

# A test that failed beside another runs once more, alone: a fault is there again, a shared core is not.
# One that waits for ever fails, with what each thread was doing, and the others go on.
define pytest
.venv/bin/python -m pytest --cache-clear $(1) || { [ $$? = 1 ] && echo "make: what failed runs once more, alone" && \
		.venv/bin/python -m pytest --last-failed --last-failed-no-failures none $(1) -n 0; }
endef

# Many a test waits for a machine that it plays: three at a time on two cores. mypy uses one core beside the first ones.
# Files without tests in FreeCAD are not even imported for those.
FREECAD_TESTS = $$(grep -rlF --include='test_*.py' --exclude-dir=freecad --exclude-dir=window mark.freecad tests)
test: setup
	@.venv/bin/python -m ruff check .
	@.venv/bin/python -m ruff format --check .
	@.venv/bin/python -m mypy & types=$$!; tests=0; \
		{ $(call pytest,-n 3 --timeout 600 --dist loadfile --no-loadscope-reorder -m "not freecad"); } || tests=$$?; \
		wait $$types; exit $$tests
	@$(call pytest,-n 2 --timeout 1800 --dist worksteal -m "freecad$(if $(filter matrix,$(MAKECMDGOALS)), and not matrix)" $(FREECAD_TESTS))

# `make test matrix` runs in the system's FreeCAD once what both have (marked "matrix").
matrix:
	@tools/setup.sh matrix
	@.venv/bin/python tools/matrix.py

quick:
	@tools/setup.sh python
	@.venv/bin/python -m pytest --timeout 60 -n 2 --dist loadfile --no-loadscope-reorder -m "not slow and not freecad"

RUNS := 500
FAULT_RUNS := $(if $(filter command,$(firstword $(origin RUNS))),$(RUNS),5000)
soak:
	@tools/setup.sh python
	@echo "seeds 1 to $(RUNS); a failed test has its seed in its name: pytest 'FILE::TEST[SEED]' repeats it"
	@grep -rlE --include='test_*.py' "helpers.cycles.seeds import|CNCSTEPPER_CASES|CNCSTEPPER_FAULT_RUNS" tests/unit | \
		CNCSTEPPER_CASES=$(RUNS) CNCSTEPPER_FAULT_RUNS=$(FAULT_RUNS) xargs -d '\n' \
		.venv/bin/python -m pytest -n 2 --dist worksteal

STEPS := 20000
SEED := 1
monkey: setup
	@CNCSTEPPER_MONKEY_STEPS=$(STEPS) CNCSTEPPER_MONKEY_SEED=$(SEED) CNCSTEPPER_WINDOW_LIMIT_S=$$((600 + $(STEPS) * 5)) \
		tools/window.sh host monkey -q tests/window/test_monkey.py

CASES := 100000
FILES := 2000
FUZZ_S := 300
fuzz:
	@tools/setup.sh python
	@CNCSTEPPER_FUZZ=$(CASES) .venv/bin/python -m pytest -q -n 2 tests/unit/gcode/test_gcode_fuzz.py
	@CNCSTEPPER_FILE_FUZZ=$(FILES) .venv/bin/python -m pytest -q -n 2 -s tests/unit/job/test_file_fuzz.py
	@.venv/bin/python -c "import atheris" 2>/dev/null || .venv/bin/python -m pip install -q atheris || \
		{ echo "fuzz: atheris cannot be installed on this Python, so there is no coverage-guided run" >&2; exit 1; }
	@mkdir -p build/fuzz
	@.venv/bin/python tests/fuzz/fuzz_gcode.py -max_total_time=$(FUZZ_S) -timeout=20 -rss_limit_mb=1500 \
		-artifact_prefix=build/fuzz- build/fuzz tests/bad tests/data/ngc

bench: setup
	@for script in bench/bench_*.py; do .venv/bin/python "$$script"; done

bench-guard: setup
	@.venv/bin/python bench/guard.py

lint:
	@tools/setup.sh python
	@.venv/bin/python -m ruff check .
	@.venv/bin/python -m ruff format --check .
	@.venv/bin/python -m mypy

translations:
	@tools/setup.sh translations
	@.venv/bin/python tools/translations.py

pictures: setup
	@.venv/bin/python tools/cycle_pictures.py
	@.venv/bin/python tools/worked_parts.py
	@.venv/bin/python tools/pictures.py

manual:
	@tools/setup.sh manual
	@.venv/bin/python tools/manual.py

# Python 3.11 is in the FreeCADs of freecad.org; a distribution's FreeCAD has the distribution's Python.
PYTHONS := 3.11
installer:
	@tools/setup.sh python
	@.venv/bin/python tools/installer.py $(PYTHONS)

clean:
	@rm -rf build .cache .pytest_cache .mypy_cache .ruff_cache .hypothesis
	@find . -name .venv -prune -o -name __pycache__ -type d -prune -exec rm -rf {} +
	@shared=$${CNCSTEPPER_FREECADS:-$${XDG_CACHE_HOME:-$$HOME/.cache}/cncstepper-freecad}; if [ -d "$$shared" ]; then \
		echo "clean: left for all checkouts: $$shared, the FreeCADs of make matrix (5 minutes to make); remove it yourself"; fi
