# One command each: `make help` lists them. Continuous integration runs the same ones (.ci/run).

SHELL := bash
.SHELLFLAGS := -eu -o pipefail -c
CARGO ?= cargo
PART := examples/01-first-cut/first-cut.sbp
FIGURES := examples/03-coaster/coaster.sbp
PREFIX ?= $(HOME)/.local
# Tools, tests and programs take dependencies with the features of the whole workspace: no crate is compiled twice.
XTASK := $(CARGO) build --workspace --locked --quiet --bin xtask --test repository && target/debug/xtask
DIST = kerf-$(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)-$(shell rustc -vV | sed -n 's/^host: //p')

.DEFAULT_GOAL := help
.PHONY: help install dist console console-browser console-check console-test rust-test run bench bench-geometry test properties check soak traces mutants fuzz format conformance book figures prepare peers

help: ## list these targets
	@awk -F':.*## ' '/^[a-z-]+:.*## / { printf "  make %-14s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

test: rust-test console-test console-browser ## run every test, once

# The server is compiled with the page in it, so the page comes first.
rust-test: prepare console ## tests of everything but the console
	$(XTASK) test | awk -f .ci/told-tests.awk

properties: prepare ## try the properties on new random cases
	seed=$$(date +%s); echo "PROPTEST_RNG_SEED=$$seed"; \
	PROPTEST_RNG_SEED=$$seed PROPTEST_CASES=2000 $(CARGO) test --workspace --locked --no-fail-fast

check: prepare console-check ## formatting, lints and the project's own rules
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --all-targets --locked -- -D warnings
	$(XTASK) check

soak: prepare ## RUNS (1000000) random runs in the simulation, the process and the host of a board killed KILLS (1000) times, boards on a faulty line TRIES (34) times
	KERF_SIM_RUNS=$${RUNS:-1000000} KERF_SIM_SEED=$${SEED:-1} \
	  $(CARGO) test --release --locked --package kerf-ledger --test all simulated::whole_runs -- --nocapture
	KERF_KILLS=$${KILLS:-1000} KERF_SEED=$${SEED:-1} \
	  $(CARGO) test --locked --package kerf --test all killed:: -- --nocapture
	KERF_KILLS=$${KILLS:-1000} KERF_SEED=$${SEED:-1} \
	  $(CARGO) test --release --locked --package kerf-control --test all queued_killed:: -- --nocapture
	TRIES=$${TRIES:-34} $(CARGO) test --release --locked --package kerf-driver-klipper --test all motion:: -- --nocapture

traces: prepare console ## hashes of the traces of the corpus, the examples and 2,000 random runs: recorded the first time, then compared
	KERF_TRACES="$(CURDIR)/target/traces" $(CARGO) test --release --locked --package kerf-ledger --package kerf \
	  --test all traces_are_the_recorded_ones -- --nocapture

mutants: prepare console ## break CRATES in SAMPLE (300) small ways by SEED, list the ones that no test notices
	@CRATES="$(CRATES)" SAMPLE="$(SAMPLE)" SEED="$(SEED)" .ci/mutants

fuzz: prepare console ## throw bytes at all that reads them, FUZZ_SECONDS (60) a target; look at FUZZ_MADE (600) made things in 1 GiB
	@cargo-fuzz --version >/dev/null 2>&1 || $(CARGO) install cargo-fuzz --locked
	@rustup toolchain list | grep -q '^nightly' || rustup toolchain install nightly --profile minimal
	@for target in $$(sed -n 's/^path = "fuzz_targets\/\(.*\)\.rs"/\1/p' fuzz/Cargo.toml); do \
	  mkdir -p fuzz/corpus/$$target; \
	  $(CARGO) +nightly fuzz run $$target fuzz/corpus/$$target fuzz/seeds/$$target -- \
	    -max_total_time=$${FUZZ_SECONDS:-60} -timeout=20 -rss_limit_mb=2048 || exit 1; \
	done
	seed=$${SEED:-$$(date +%s)}; echo "KERF_FUZZ_SEED=$$seed"; \
	KERF_FUZZ_SEED=$$seed KERF_FUZZ_RUNS=$${FUZZ_MADE:-600} KERF_FUZZ_WHOLE=1 \
	  $(CARGO) test --release --locked --package kerf --test all structured:: -- --nocapture

format: ## format every source file
	$(CARGO) fmt --all

conformance: ## enter new tests into the score and write its page
	$(CARGO) xtask conformance mark
	$(CARGO) xtask conformance page

book: ## write the generated pages of the user's book
	$(CARGO) xtask book

run: prepare console ## build everything and open the console on the simulated machine, a sample loaded
	$(CARGO) build --release --locked --package kerf
	target/release/kerf serve $(notdir $(PART)) --parts $(dir $(PART))

install: prepare console ## build kerf and copy it to PREFIX/bin (PREFIX: ~/.local)
	$(CARGO) build --release --locked --package kerf
	install -D -m 755 target/release/kerf "$(DESTDIR)$(PREFIX)/bin/kerf"

dist: prepare console ## build kerf and pack it with examples and licence into target/dist
	$(CARGO) build --release --locked --package kerf
	mkdir -p target/dist
	tar --create --gzip --sort=name --owner=0 --group=0 --numeric-owner --transform 's,^target/release/,,;s,^,$(DIST)/,' \
	  --file target/dist/$(DIST).tar.gz target/release/kerf README.md CHANGELOG.md LICENSE* examples
	cd target/dist && sha256sum $(DIST).tar.gz >$(DIST).tar.gz.sha256

figures: prepare console ## draw the pictures of README and book anew
	$(CARGO) build --release --locked --package kerf
	for part in $(FIGURES); do \
	  target/release/kerf preview $$part --force -o docs/figures/$$(basename $$part .sbp).svg; \
	done
	for model in shopbot profiler "optimal --jerk 10000"; do \
	  target/release/kerf plot docs/figures/corners.sbp --units mm --over time \
	    --ramps $$model --force -o docs/figures/speed-$${model%% *}.svg; \
	done
	target/release/kerf preview docs/figures/corners.sbp --units mm --force -o docs/figures/corners.svg
	@.ci/browser
	cd console && KERF="$(CURDIR)/target/release/kerf" npm run --silent figures
	for kind in router input pierce plasma; do \
	  target/release/kerf timing docs/figures/line.rsg --machine docs/figures/timing-$$kind.toml \
	    $$(cat docs/figures/timing-$$kind.txt) --force -o docs/figures/timing-$$kind.svg; \
	done
	target/release/kerf heights docs/figures/wave.rsg --machine docs/figures/height-error.toml \
	  $$(cat docs/figures/height-error.txt) --title Height-control --force -o docs/figures/height-error.svg

# Python's ezdxf, kept apart from whatever Python is there.
EZDXF := target/peers/ezdxf
bench: prepare peers console ## measure speed and memory; RECORD=1 writes docs/benchmarks.md
	$(CARGO) build --release --locked --package kerf --package kerf-bench --bin kerf --bin kerf-bench \
	  --bin kerf-bench-drawings
	target/release/kerf-bench $(if $(RECORD),--record) $(INPUT)
	@[ -x $(EZDXF)/bin/python3 ] || .ci/python-peer $(EZDXF) ezdxf
	PATH="$(CURDIR)/$(EZDXF)/bin:$$PATH" target/release/kerf-bench-drawings $(if $(RECORD),--record)
	@.ci/browser
	cd console && RECORD=$(RECORD) KERF="$(CURDIR)/target/release/kerf" npm run --silent bench
	RECORD=$(RECORD) KERF_STOPS=1100 KERF="$(CURDIR)/target/release/kerf" \
	  $(CARGO) test --locked --package kerf --test stop_under_load -- --nocapture

# GEOS comes with Python's shapely, kept apart from whatever Python is there.
SHAPELY := target/peers/shapely
bench-geometry: ## offsets beside those of others; GEOS=N compares N hard shapes a family with GEOS, PROVE=N counts proofs
	$(CARGO) build --release --locked --package kerf-bench --bin kerf-bench-geometry --no-default-features
	@[ -x $(SHAPELY)/bin/python3 ] || .ci/python-peer $(SHAPELY) shapely
	PATH="$(CURDIR)/$(SHAPELY)/bin:$$PATH" target/release/kerf-bench-geometry $(if $(GEOS),--geos $(GEOS)) \
	  $(if $(PROVE),--prove $(PROVE))

peers: ## install the other programs that `make bench` compares with
	@.ci/peers

# The console: npm installs when the list of packages changes.
console/node_modules/.package-lock.json: console/package-lock.json
	cd console && npm install --no-save --no-fund --no-audit --loglevel=error

console-check: console/node_modules/.package-lock.json ## types and lints of the console
	cd console && npm run --silent check

console-test: console/node_modules/.package-lock.json ## tests of the console that need no browser
	cd console && npm run --silent test

console-browser: console ## tests of the console in a browser, on the simulated machine and on a pretended controller
	@.ci/browser
	$(CARGO) build --locked --workspace --bin kerf --example grbl --example linuxcnc
	cd console && npm run --silent browser

console: console/node_modules/.package-lock.json ## build the console's page
	cd console && npm run --silent build

prepare: ## install what building and testing need
	@.ci/prepare
