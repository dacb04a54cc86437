# Every target sets up what it needs, once, inside this checkout.
PYTHON ?= python3
BIN := .venv/bin
READY := .venv/made-of

# JupyterLab refuses root, whom a container often has alone, unless it is told.
LAB_AS_ROOT := $(if $(filter 0,$(shell id -u)),--allow-root --no-browser)

# The viewer for notebooks.
VIEWER := rotedu/figures/static/figure.js

# The Python of the pages.
LIVE := .venv/page_python/runtime/.made-of

# What Python compiles it keeps: compiling all that a kernel imports takes seconds.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: book watch test test-book test-rest test-slow audit bench lab class pdf epub notebooks lock clean help
.DEFAULT_GOAL := help
# What is half written when a command fails is made anew.
.DELETE_ON_ERROR:

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## /  make \1\t/p' Makefile | expand -t 20

book: $(READY) $(LIVE) ## build the book into _build/html
	$(BIN)/jupyter-book build . -W --keep-going
	@echo "The book is here: _build/html/index.html"

watch: $(READY) $(LIVE) ## serve the book, and build again what you edit
	$(BIN)/python tools/watch.py $(PORT)

test: $(READY) $(VIEWER) $(LIVE) .venv/browser ## check code, notebooks and the built book
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/node node_modules/.bin/biome check --error-on-warnings
	$(BIN)/node node_modules/.bin/tsc --project viewer
	$(MAKE) --no-print-directory --keep-going --jobs=2 test-book test-rest

# Two halves, each with its own core: the second needs no built book.
test-book test-rest: $(READY) $(VIEWER) $(LIVE) .venv/browser

test-book:
	$(BIN)/pytest -m "book and not slow"

test-rest:
	$(BIN)/pytest -m "not book and not slow"

test-slow: $(READY) $(VIEWER) $(LIVE) .venv/browser ## install the wheel on its own; test random input for minutes
	$(BIN)/pytest -m "slow or hypothesis" --hypothesis-profile=long

audit: .venv/browser book ## weigh the pages, let axe judge them, time their figures and cells
	$(BIN)/python tools/audit.py

bench: $(READY) ## measure speed beside other packages (one minute)
	$(BIN)/python benchmarks/run.py

lab: $(READY) $(VIEWER) ## open the notebooks in JupyterLab, with figures that turn
	@test -z "$(LAB_AS_ROOT)" || echo "You are root. To open JupyterLab from outside a container, publish" \
	    "its port (docker run -p 8888:8888) and call: make lab LAB=--ip=0.0.0.0"
	$(BIN)/jupyter lab $(LAB_AS_ROOT) $(LAB) book

class: $(READY) ## write notebooks for a class, with and without solutions, and questions
	$(BIN)/python tools/class_notebooks.py
	$(BIN)/python tools/questions.py $(SEED)

pdf: $(READY) .venv/browser ## print the book into _build/pdf
	$(BIN)/python tools/print_book.py pdf

epub: $(READY) ## write the book for e-readers into _build/epub
	$(BIN)/python tools/print_book.py epub

notebooks: $(READY) ## run the notebooks and store what they print
	$(BIN)/python tools/run_notebooks.py

lock: $(READY) ## write new requirements.txt and package-lock.json
	echo '-e .[bench,book,lab,test]' | "$(PYTHON)" tools/set_up.py uv pip compile - --universal \
	    --python-version 3.11 --no-header --upgrade --output-file requirements.txt
	$(BIN)/npm install --package-lock-only

clean: ## remove everything that make has made
	rm -rf .venv _build class dist node_modules rotedu/figures/static .benchmarks .hypothesis
	rm -rf .*_cache __pycache__ .ipynb_checkpoints
	find benchmarks book rotedu tests tools viewer -depth \
	    '(' -name __pycache__ -o -name '.*_cache' -o -name .ipynb_checkpoints ')' -exec rm -rf {} +

# tools/set_up.py sees for itself whether something is to be done.
$(READY): FORCE
	@"$(PYTHON)" tools/set_up.py

FORCE:

$(LIVE): $(READY) package-lock.json page_python/requirements.txt tools/runtime.py tools/page_python.mjs
	@$(BIN)/python tools/runtime.py

$(VIEWER): $(READY) package-lock.json tools/bundle.py $(wildcard viewer/*.* viewer/src/*.js rotedu/figures/*.* rotedu/scenes/*.*)
	@$(BIN)/python tools/bundle.py

.venv/browser: $(READY)
	@"$(PYTHON)" tools/set_up.py --browser
	@touch $@
