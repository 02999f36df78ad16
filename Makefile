# Needs Python 3.11 or newer and make; everything else goes into .venv.

.DEFAULT_GOAL := book
.PHONY: help setup book book-fast pdf screenshots test lint notebooks lock benchmark clean

BIN := .venv/bin
STARTED := $(shell date +%s)
export PIP_DISABLE_PIP_VERSION_CHECK := 1
# Where this is set, every kernel would compile SymPy and pandas anew: minutes lost.
unexport PYTHONDONTWRITEBYTECODE

# The first of these that is new enough. Looked for only when .venv has to be made.
PYTHON = $(firstword $(foreach python,python3 python3.11 python3.12 python3.13 python3.14,$(shell \
  $(python) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $(python))))

help: ## list the targets
	@sed -nE 's/^([a-z-]+):.*## (.*)/\1 \2/p' Makefile | while read name what; do printf '  %-12s %s\n' "$$name" "$$what"; done

setup: .venv/.ready ## make .venv from the lock file

book: .venv/.ready ## execute every notebook afresh and render the book (the default)
	$(BIN)/python tools/build_book.py --started $(STARTED)

book-fast: .venv/.ready ## the same, executing only what changed
	$(BIN)/python tools/build_book.py --started $(STARTED) --reuse

pdf: book-fast ## print the whole book to _build/coxeter-triangulations.pdf (needs a Chromium)
	$(BIN)/python tools/make_pdf.py

screenshots: book-fast ## a picture of every page, wide and phone, light and dark (needs a Chromium)
	$(BIN)/python tools/screenshots.py

test: .venv/.ready ## every check: lint, types, imports, tests, notebooks, book, site, browser
	$(BIN)/python tools/run_checks.py --started $(STARTED)

lint: .venv/.ready ## the quick checks only
	$(BIN)/python tools/run_checks.py --started $(STARTED) format lint types imports

notebooks: .venv/.ready ## execute every notebook and store its outputs
	$(BIN)/python tools/run_notebooks.py

lock: .venv/.ready ## renew requirements.lock from pyproject.toml
	$(BIN)/uv pip compile --universal --python-version 3.11 --all-extras --generate-hashes --upgrade \
	  --no-emit-index-url --no-emit-find-links --no-header --no-annotate --quiet \
	  pyproject.toml -o requirements.lock

benchmark: .venv/.ready ## measure the library, beside its peers
	$(BIN)/python benchmarks/run.py
	$(BIN)/python benchmarks/locate.py -o benchmarks/results.json

clean: ## remove what was built, but not .venv
	rm -rf _build .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis *.egg-info

# uv installs in seconds what takes pip minutes. It does not know pip's settings, so pip is the fallback.
.venv/.locked: requirements.lock
	$(if $(PYTHON),,$(error Python 3.11 or newer is needed, and was found neither as python3 nor as python3.11 to python3.14))
	rm -rf .venv
	$(PYTHON) -m venv .venv
	sed -n '/^uv==/,/[^\\]$$/p' $< | $(BIN)/pip install --quiet --require-hashes -r /dev/stdin \
	  && $(BIN)/uv pip install --quiet --python $(BIN)/python --require-hashes -r $< \
	  || $(BIN)/pip install --require-hashes -r $<
	touch $@

.venv/.ready: .venv/.locked pyproject.toml
	$(BIN)/pip install --quiet --no-build-isolation --no-deps --editable .
	touch $@
