# Every target sets up what it needs, once, inside this checkout.
PYTHON ?= python3
BIN := .venv/bin

.PHONY: book test audit bench lab notebooks lock clean help
.DEFAULT_GOAL := help

help: ## list the targets
	@sed -n 's/^\([a-z]*\):.*## /  make \1\t/p' Makefile

book: .venv/ready ## build the book into _build/html
	$(BIN)/jupyter-book build . -W --keep-going
	@echo "The book is here: _build/html/index.html"

test: .venv/ready .venv/browser ## check code, notebooks and the built book
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy
	$(BIN)/pytest
	@echo "All checks passed."

audit: book .venv/browser ## weigh the pages; Lighthouse and axe judge them
	$(BIN)/python tools/audit.py

bench: .venv/ready ## measure speed beside other packages (one minute)
	$(BIN)/python benchmarks/run.py

lab: .venv/ready ## open the notebooks in JupyterLab, with live scenes
	$(BIN)/jupyter lab book

notebooks: .venv/ready ## run the notebooks and store what they print
	$(BIN)/python tools/run_notebooks.py

lock: .venv/ready ## write requirements.txt and package-lock.json anew
	echo '-e .[bench,book,lab,lock,test]' | $(BIN)/uv pip compile - --universal \
	    --python-version 3.11 --no-header --upgrade --output-file requirements.txt
	$(BIN)/npm install --package-lock-only --no-audit --no-fund

clean: ## remove everything that was made here
	rm -rf .venv _build node_modules

.venv/ready: requirements.txt pyproject.toml tools/set_up.py
	@$(PYTHON) tools/set_up.py
	@touch $@

.venv/browser: .venv/ready
	@$(PYTHON) tools/set_up.py --browser
	@touch $@
