# The front door. `make play` and `make test` start from a bare Debian 12 machine and do it all.

PRESET  ?= release
BUILD    = build/$(PRESET)
MINUTES ?= 10
SEED    ?= 7
SEEDS   ?= 1..10
OUT     ?= out/match
PREFIX  ?= /usr/local
SECONDS ?= 60
HOURS   ?= 24
COUNT   ?= 50
PYTHON  ?= /usr/bin/python3
JOBS    ?= $(shell nproc)
# Some tests are run by Node, which may have come from elsewhere, with npm in it: nearly half of all packages that a bare machine lacks.
NODE     = $(if $(and $(shell command -v node),$(shell command -v npm)),,nodejs npm)
# What films are written with: everything else is built without it.
FILMS    = libavformat-dev libavcodec-dev libswscale-dev
# What crashlog, tests and bench are built of, pictures of layouts made with, and joysticks and loudspeakers played by; a match needs
# none of it.
TOOLS    = libdw-dev libgtest-dev libgmock-dev libbenchmark-dev graphviz libsdl2-dev $(FILMS)
# What the workbench needs; everything else is built without it.
QT       = qt6-base-dev libqt6opengl6-dev libqcustomplot-dev
# What the comparisons of make bench, the page of make realism-page and what checks the sources need.
BENCH    = libprotobuf-dev protobuf-compiler libmrpt-slam-dev libopencv-imgproc-dev libegl-dev libgl1-mesa-dri
REALISM  = python3-numpy python3-pil python3-scipy python3-matplotlib python3-sklearn
CHECKS   = clang-14 clang-format-14 clang-tidy-14 libclang-rt-14-dev doxygen
# What tests of the workbench and of Node's programs need, and Python's package.
TESTS    = xvfb xauth desktop-file-utils shared-mime-info $(PACKING)
# What makes Debian packages.
PACKING  = dpkg-dev file
PYTHONS  = python3-dev python3-venv
ALL_PACKAGES = $(TOOLS) $(QT) $(BENCH) $(REALISM) $(CHECKS) $(TESTS) $(PYTHONS) nodejs npm debootstrap
# The thread sanitizer cannot see how libraries that were not built with it (libzmq) hand data from thread to thread.
export TSAN_OPTIONS = ignore_noninstrumented_modules=1:suppressions=$(CURDIR)/cmake/tsan.supp
export LSAN_OPTIONS = suppressions=$(CURDIR)/cmake/lsan.supp
# Twice as many as there are processors, since many tests wait for programs. A test that hangs fails.
CTEST    = ctest --output-on-failure --parallel $(shell expr $(JOBS) \* 2) --timeout 900
# While packages are fetched, Python's environment is made; while all is compiled, what only tests need is fetched.
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += --jobs=2
endif

.PHONY: help packages-first environment test-packages install play film control decisions eyes pictures random-input play-remote robots chaos growth test python learners replay realism-page bench experiments figures spoiled-figures figures-page lines mutants soak docs release try-release dependencies build packages format check-format lint verify verify-all test-changed build-times sanitize sanitize-python fuzz clean

help:
	@echo 'make play          plays a match of $(MINUTES) minutes and writes its report page ($(OUT)/report.html)'
	@echo 'make film          films half a minute of a match: out/match.mp4'
	@echo 'make control       opens the workbench robotcontrol on a match'
	@echo 'make decisions     draws what robots decide in ten scenes: docs/images/deciding'
	@echo 'make eyes          draws what the image processor sees in moments of docs/eyes.toml: docs/images/eyes'
	@echo 'make pictures      takes the pictures of the workbench: of each dialog, docs/images/workbench and out/workbench, and of the tutorial'"'"'s steps'
	@echo 'make random-input  clicks and types at random in the workbench for MINUTES, with SEED; PRESET=asan under the address sanitizer'
	@echo 'make test          builds everything and runs all tests'
	@echo 'make python        makes the environment build/python with the package gt2003, for PYTHON=$(PYTHON)'
	@echo 'make learners      lets learners of others learn from the environments, in a Python of their own: 5 GB'
	@echo 'make replay        finds the ball in a real robot'"'"'s log'
	@echo 'make realism-page  compares images of real robots with simulated ones: out/realism/index.html'
	@echo 'make robots        builds the programs of robots, with their source lines beside them for crashlog'
	@echo 'make play-remote   plays a minute against a team whose robots consist of three programs each'
	@echo 'make bench         measures speed, also against other libraries: out/bench.json; one part with ONLY=camera, python, python.log or workbench'
	@echo 'make bench AGAINST=COMMIT compares what a match costs with another commit, in turns'
	@echo 'make growth        measures how cost grows with players, pixels, particles, matches and logs: out/growth.json; one of them with ONLY=pixels'
	@echo 'make experiments   measures accuracy over SEEDS=$(SEEDS): out/experiments.json, out/experiments.html; a group with ONLY=vision'
	@echo 'make figures       measures the figures of docs/figures.json again and says which are better or worse; those that begin with ONLY=motion.walk,vision, the core set with CORE=1; KEEP=1 writes them into the file and into the pages'
	@echo 'make spoiled-figures spoils a parameter of vision, roles, walk, kick and speed each, and checks that make figures sees it; one of them with ONLY=walk'
	@echo 'make figures-page  shows figures of docs/figures.json over COMMITS, each built and measured here: out/history/index.html; ONLY and CORE as above'
	@echo 'make lines         counts lines of code: production, measuring, tests'
	@echo 'make mutants       breaks the modules as tests/mutants/ lists and checks that their tests fail; MUTANTS=N breaks N places by chance, with SEED'
	@echo 'make soak          plays matches under all that varies for HOURS simulated hours and watches faults, memory and speed: out/soak.json'
	@echo 'make chaos         does a robot'"'"'s programs, their network and their disk COUNT=$(COUNT) faults of each kind and watches when all plays again: out/chaos.json'
	@echo 'make install       installs the programs and their data below PREFIX=$(PREFIX)'
	@echo 'make release       makes Debian packages, an archive of the sources, sums and a page: out/release; make try-release tries the packages in a bare system (root)'
	@echo 'make dependencies  lists all packages that the project is built of and tested with, with versions and licenses: out/dependencies.md'
	@echo 'make docs          writes pages with charts about the soccer behavior, out/docs/index.html, and about the sources'"'"' interfaces, out/docs/api/index.html'
	@echo 'make sanitize      runs the tests under the address, undefined-behavior and thread sanitizers'
	@echo 'make verify        what takes longer than make test: clang-tidy and sanitizers on what changed SINCE=COMMIT, and all that is rarely built; make verify-all: everything'
	@echo 'make test-changed  runs the tests of the folders that changed SINCE=COMMIT; PRESET=asan under the address sanitizer'
	@echo 'make build-times   builds everything without compiler cache and prints the dearest steps'
	@echo 'make sanitize-python runs the tests of what the Python package has compiled under the same two'
	@echo 'make fuzz          feeds broken files to all that reads files, SECONDS=$(SECONDS) each'
	@echo 'make format        formats the sources; make check-format reports those that are not formatted'
	@echo 'make lint          checks all sources with clang-tidy; SINCE=COMMIT those changed since'
	@echo 'make build         only builds, into $(BUILD); make packages only installs what is missing'
	@echo 'make clean         removes build/ and out/'
	@echo 'Settings: MINUTES, HOURS, COUNT, SEED, SEEDS, ONLY, SECONDS, MUTANTS, OUT, PREFIX, PRESET (release, debug, asan, tsan, clang), JOBS'

packages-first:
	@scripts/install-packages $(if $(filter clang,$(PRESET)),clang-14) $(if $(filter /usr/bin/python3,$(PYTHON)),$(if $(ENVIRONMENT),$(PYTHONS)))

packages: packages-first
	@scripts/install-packages $(TOOLS) $(PACKAGES)

environment: packages-first
	@$(if $(ENVIRONMENT),scripts/python-environment $(ENVIRONMENT) $(PYTHON))

build: packages environment
	@cmake --preset $(PRESET) >/dev/null
	@cmake --build --preset $(PRESET) --parallel $(JOBS) $(TARGETS)

# A match needs one program only, and little to build it.
play: TOOLS =
film: TOOLS = $(FILMS)
play: TARGETS = --target simgt
play: build
	@$(BUILD)/bin/simgt play scenes/match.scene --minutes $(MINUTES) --seed $(SEED) --threads $(JOBS) --out $(OUT)

film: TARGETS = --target simgt
film: build
	@$(BUILD)/bin/simgt console scenes/match.scene --seed $(SEED) --threads $(JOBS) --script scenes/film.con
	@echo 'Film: out/match.mp4'

control: PACKAGES += $(QT)
control: TARGETS = --target robotcontrol
control: build
	@$(BUILD)/bin/robotcontrol scenes/match.scene --seed $(SEED) --threads $(JOBS) --start

# Of each dialog of the workbench, light and dark, in two sizes; and of the steps that pages show.
decisions: TARGETS = --target gtlog xabsl gt2003_python_package
decisions: ENVIRONMENT = build/python
decisions: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
decisions: build
	@PYTHONPATH=$(BUILD)/python build/python/bin/python -B scripts/draw-decisions --build $(BUILD)

eyes: TARGETS = --target simgt
eyes: ENVIRONMENT = build/python
eyes: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
eyes: build
	@build/python/bin/python -B scripts/draw-eyes $(ONLY) --build $(BUILD)

pictures: PACKAGES += $(QT) xvfb xauth
pictures: TARGETS = --target workbench_clicks
pictures: DISPLAYED = QT_QPA_PLATFORM=xcb xvfb-run -a -s '-screen 0 2560x1440x24'
pictures: build
	@$(DISPLAYED) $(BUILD)/bin/workbench_clicks dialogs --out out/workbench --dialogs docs/images/workbench
	@for page in docs/robotcontrol.md docs/tutorial/09-workbench.md; do \
	  $(DISPLAYED) $(BUILD)/bin/workbench_clicks page $$page --pictures docs/images/tutorial || exit 1; \
	done

# Random clicks and keys in all dialogs of the workbench; PRESET=asan under the address sanitizer.
random-input: PACKAGES += $(QT)
random-input: TARGETS = --target gt_workbench_test
random-input: build
	@GT_MINUTES=$(MINUTES) GT_SEED=$(SEED) QT_QPA_PLATFORM=offscreen $(BUILD)/bin/gt_workbench_test --gtest_filter='RandomInput.*'

install: PACKAGES += $(QT)
install: build
	@cmake --install $(BUILD) --prefix $(PREFIX)

test python release: ENVIRONMENT = build/python
test: PACKAGES += $(QT) xvfb xauth  # which the build looks for
test-packages: packages
	@scripts/install-packages $(NODE) $(TESTS)

test: TARGETS = --target all benchmarks
test: build test-packages
	@$(CTEST) --test-dir $(BUILD)

python: TARGETS = --target gt2003_python_package
python: build
	@build/python/bin/pip install --quiet --disable-pip-version-check --no-build-isolation --no-deps --force-reinstall \
	  --config-settings cmake.define.GT_BUILD=$(CURDIR)/$(BUILD) ./python
	@echo 'Now: build/python/bin/python python/examples/first_match.py'

# Learners of others have 5 GB of packages.
learners: TARGETS = --target gt2003_python_package
learners: ENVIRONMENT = build/python
learners: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
learners: build
	@scripts/python-environment build/learners $(PYTHON) python/learners/requirements.txt
	@PYTHONPATH=$(BUILD)/python build/learners/bin/python -m pytest -q -p no:cacheprovider python/tests/test_learners.py

replay: build
	@$(BUILD)/bin/replay --out out/replay

realism-page: TARGETS = --target simgt gtlog
realism-page: PACKAGES += $(REALISM)
realism-page: build
	@scripts/real-beside-simulated --build $(BUILD)

# As they go to a robot: stripped, their source lines beside them.
robots: packages
	@cmake --preset symbols >/dev/null
	@cmake --build --preset robots-symbols --parallel $(JOBS)
	@echo 'Programs: build/symbols/bin/gtrobot-*; for crashlog --symbols: build/symbols/bin/symbols'

# A whole team of programs, three a robot, in real time.
play-remote: build
	@scripts/play-remote $(BUILD) 1 red1 red2 red3 red4

ifdef AGAINST
bench: TARGETS = --target simgt
bench: build
	@python3 -B python/benchmarks/against.py $(AGAINST) --build $(BUILD) --json out/bench.json
else
bench: TARGETS = --target $(if $(filter workbench,$(ONLY)),bench_workbench,bench layout-cmd simgt gt2003_python_package)
bench: ENVIRONMENT = $(if $(filter workbench,$(ONLY)),,build/python)
bench: PACKAGES += $(BENCH)
bench: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
bench: PACKAGES += $(if $(filter workbench,$(ONLY)),$(QT))
bench: build
	@$(if $(filter workbench,$(ONLY)),QT_QPA_PLATFORM=offscreen $(BUILD)/bin/bench_workbench --json out/bench.json)
	@$(if $(filter python% workbench,$(ONLY)),,$(BUILD)/bin/bench $(if $(ONLY),--only $(ONLY)) --json out/bench.json)
	@$(if $(filter-out python%,$(ONLY)),,scripts/python-environment build/python-bench $(PYTHON) python/benchmarks/requirements.txt)
	@$(if $(filter-out python%,$(ONLY)),,PYTHONPATH=$(BUILD)/python build/python-bench/bin/python python/benchmarks/bench.py \
	  --build $(BUILD) $(patsubst python.%,--only %,$(filter python.%,$(ONLY))) --json out/bench.json)
endif

experiments: TARGETS = --target experiment
experiments: build
	@$(BUILD)/bin/experiment --seeds $(SEEDS) $(if $(ONLY),--only $(ONLY)) --threads $(JOBS) --json out/experiments.json

# Seeds are those of python/benchmarks/measured.toml if none are named: SEEDS has a default of its own.
# Speed takes more to build, and is no part of the core set.
WITH_SPEED = $(if $(CORE),,$(if $(ONLY),$(findstring speed,$(ONLY)),speed))
figures: TARGETS = --target experiment simgt gt2003_python_package $(if $(WITH_SPEED),bench)
figures: ENVIRONMENT = build/python
figures: PACKAGES += $(if $(WITH_SPEED),$(BENCH))
figures: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
figures: build
	@PYTHONPATH=$(BUILD)/python build/python/bin/python -B python/benchmarks/measure.py --build $(BUILD) $(if $(ONLY),--only $(ONLY)) \
	  $(if $(CORE),--core) $(if $(filter file,$(origin SEEDS)),,--seeds $(SEEDS)) $(if $(KEEP),--keep)
	@$(if $(KEEP),git ls-files 'docs/*.md' | xargs scripts/fill-pages docs/figures.json)

spoiled-figures: TARGETS = --target experiment simgt gt2003_python_package bench
spoiled-figures: ENVIRONMENT = build/python
spoiled-figures: PACKAGES += $(BENCH) $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
spoiled-figures: build
	@PYTHONPATH=$(BUILD)/python build/python/bin/python -B python/benchmarks/spoiled.py --build $(BUILD) $(if $(ONLY),--only $(ONLY))

# Commits are built each in a clone of its own.
COMMITS ?= HEAD
figures-page: TARGETS = --target gt2003_python_package
figures-page: ENVIRONMENT = build/python
figures-page: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
figures-page: build
	@PYTHONPATH=$(BUILD)/python build/python/bin/python -B python/benchmarks/history.py $(COMMITS) $(if $(ONLY),--only $(ONLY)) $(if $(CORE),--core)

lines:
	@scripts/lines

mutants: TARGETS = --target gt_behavior_test gt_kinematics_test gt_modeling_test gt_motion_test gt_perception_test
mutants: build
	@nice scripts/mutants $(BUILD) $(if $(MUTANTS),--sample $(MUTANTS) --seed $(SEED),tests/mutants/*.list) --jobs $(JOBS)

# The same commit gives the same bytes: times are the commit's, and it is only made of what is committed.
RELEASE = out/release
VERSION = $(shell awk '/^project/ {print $$3}' CMakeLists.txt)
COMMIT  = $(shell git rev-parse HEAD)
release: export SOURCE_DATE_EPOCH = $(shell git log -1 --format=%ct)
release: PACKAGES += $(QT) $(PACKING)
release: build
	@git diff --quiet HEAD || { echo 'make release: commit your changes first' >&2; exit 1; }
	@rm -rf $(RELEASE) $(BUILD)/packages && mkdir -p $(RELEASE)
	@cd $(BUILD) && cpack >packages.log 2>&1 || { tail -20 packages.log >&2; exit 1; }
	@cp $(BUILD)/packages/*.deb $(RELEASE)
	@git archive --prefix=gt2003-$(VERSION)/ HEAD | gzip -n9 >$(RELEASE)/gt2003-$(VERSION).tar.gz
	@scripts/dependencies $(ALL_PACKAGES) --debs $(RELEASE) >$(RELEASE)/dependencies.md
	@scripts/release-page $(RELEASE) $(VERSION) $(COMMIT) --figures out/bench.json out/experiments.json
	@echo 'Release: $(RELEASE)/index.html'

try-release:
	@scripts/try-packages $(RELEASE)

dependencies:
	@mkdir -p out
	@scripts/dependencies $(ALL_PACKAGES) >out/dependencies.md
	@echo 'Dependencies: out/dependencies.md'

# Matches one after another in one process; SCENES names others, such as dynamic.
soak: TARGETS = --target gt2003_python_package
soak: ENVIRONMENT = build/python
soak: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
soak: build
	@PYTHONPATH=$(BUILD)/python build/python/bin/python python/tests/soak.py --hours $(HOURS) --seed $(SEED) $(if $(SCENES),--scene $(SCENES))

growth: TARGETS = --target gt2003_python_package
growth: ENVIRONMENT = build/python
growth: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
growth: build
	@PYTHONPATH=$(BUILD)/python build/python/bin/python python/benchmarks/growth.py $(if $(ONLY),--only $(ONLY))

# Faults of a network need root; ONLY=Killed does those of one test.
chaos: TARGETS = --target chaos_test
chaos: build
	@mkdir -p out
	@GT_FAULTS=$(COUNT) GT_CHAOS=out/chaos.json $(BUILD)/bin/chaos_test --gtest_filter='*Chaos*$(ONLY)*'

docs: TARGETS = --target xabsl
docs: PACKAGES += doxygen
docs: build
	@$(BUILD)/bin/xabsl doc behavior/GT2003.xabsl -o out/docs
	@doxygen docs/Doxyfile

sanitize: PACKAGES += $(NODE) $(QT) $(TESTS)
sanitize sanitize-python: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
sanitize: packages
	@scripts/python-environment build/python $(PYTHON)
	@for preset in asan tsan; do \
	  cmake --preset $$preset >/dev/null && cmake --build --preset $$preset --parallel $(JOBS) && \
	  $(CTEST) --test-dir build/$$preset || exit 1; \
	done

# The Python package's compiled part: no call of it may break anything.
sanitize-python: packages
	@scripts/python-environment build/python $(PYTHON)
	@cmake --preset asan >/dev/null
	@cmake --build --preset asan --parallel $(JOBS) --target gt2003_python_package
	@$(CTEST) --test-dir build/asan --tests-regex '^python_'

# What is found stays in out/fuzz as a file that reproduces it.
fuzz: TARGETS = --target gt2003_python_package
fuzz: ENVIRONMENT = build/python
fuzz: PACKAGES += $(if $(filter /usr/bin/python3,$(PYTHON)),$(PYTHONS))
fuzz: build
	@scripts/install-packages clang-14 libclang-rt-14-dev
	@cmake --preset fuzz >/dev/null
	@cmake --build --preset fuzz --parallel $(JOBS)
	@mkdir -p out/fuzz
	@for target in build/fuzz/bin/fuzz_*; do \
	  name=$${target##*/fuzz_}; echo "$$name:"; \
	  $$target build/fuzz/corpus/$$name -max_total_time=$(SECONDS) -timeout=10 -rss_limit_mb=4096 \
	    -artifact_prefix=out/fuzz/$$name- -print_final_stats=1 -verbosity=0 || exit 1; \
	done
	@PYTHONPATH=$(BUILD)/python build/python/bin/python python/tests/fuzz_bindings.py --seconds $(SECONDS) --seed $(SEED)

# Also those that git does not know yet; none that is deleted.
SOURCES = git ls-files -z --cached --others --exclude-standard '*.h' '*.cpp' | xargs -0 ls -d 2>/dev/null | tr '\n' '\0'
format:
	@scripts/install-packages clang-format-14
	@$(SOURCES) | xargs -0 clang-format-14 -i
	@if [ -x $(BUILD)/bin/xabsl ]; then git ls-files 'behavior/*.xabsl' | xargs $(BUILD)/bin/xabsl format -i; fi

check-format:
	@scripts/install-packages clang-format-14
	@$(SOURCES) | xargs -0 clang-format-14 --dry-run -Werror

# The headers that the build generates have to be there; the preset "clang" has no precompiled headers.
lint:
	@scripts/install-packages clang-14 clang-tidy-14 $(QT)
	@cmake --preset clang >/dev/null
	@cmake --build --preset clang --parallel $(JOBS) --target commit gt_behavior_symbols
	@scripts/lint build/clang $(if $(SINCE),--since $(SINCE))

# The test programs of the folders that changed since a commit.
test-changed: packages
	@[ -n "$(SINCE)" ] || { echo 'make $@: name a commit: SINCE=COMMIT' >&2; exit 2; }
	@cmake --preset $(PRESET) >/dev/null
	@tests=$$(scripts/changed-tests $(BUILD) $(SINCE)) || exit 2; [ -n "$$tests" ] || exit 0; \
	  cmake --build --preset $(PRESET) --parallel $(JOBS) --target $$tests && \
	  $(CTEST) --test-dir $(BUILD) --tests-regex "^($$(echo $$tests | tr ' ' '|'))$$"

# No reason not to merge, but what it finds is mended before an issue is resolved.
verify: PACKAGES += $(NODE) $(QT) $(TESTS)
verify: packages
	@[ -n "$(SINCE)" ] || { echo 'make $@: name a commit: SINCE=COMMIT' >&2; exit 2; }
	@$(MAKE) --no-print-directory lint
	@$(MAKE) --no-print-directory test-changed PRESET=asan
	@$(MAKE) --no-print-directory build PRESET=clang TARGETS="--target simgt robotcontrol"
	@$(MAKE) --no-print-directory build TARGETS="--target bench experiment"
	@$(MAKE) --no-print-directory figures CORE=1

verify-all:
	@$(MAKE) --no-print-directory lint SINCE=
	@$(MAKE) --no-print-directory build PRESET=clang
	@$(MAKE) --no-print-directory figures spoiled-figures
	@$(MAKE) --no-print-directory sanitize sanitize-python fuzz mutants

# Of an idle machine.
build-times: PACKAGES += $(NODE) $(QT) $(TESTS) $(PYTHONS)
build-times: packages
	@rm -rf build/times && cmake --preset release -B build/times >/dev/null
	@CCACHE_DISABLE=1 cmake --build build/times --parallel $(JOBS) >/dev/null
	@scripts/build-times build/times

clean:
	@rm -rf build out
