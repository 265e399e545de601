# tessera: CityGML and IFC through Unix pipes. `make help` lists the targets.

config ?= release
PREFIX ?= /usr/local
PKG_CONFIG ?= pkg-config
ifeq ($(origin CC),default)
CC := gcc
endif
ifeq ($(origin CXX),default)
CXX := $(if $(findstring clang,$(CC)),clang++,g++)
endif

configs := debug release sanitize fuzz
ifeq ($(filter $(config),$(configs)),)
$(error config=$(config) is none of: $(configs))
endif
ifeq ($(config),fuzz)
CC := clang
CXX := clang++
build ?= build/fuzz
else
# Objects of two compilers never share a folder.
build ?= build/$(if $(findstring clang,$(CC)),clang-)$(config)
endif

# ---- flags -----------------------------------------------------------------

warnings := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wwrite-strings -Wvla
ifdef WERROR
warnings += -Werror
endif
warnings_c := $(warnings) -Wstrict-prototypes -Wmissing-prototypes
flags_debug := -O1 -g
flags_release := -O2 -g -DNDEBUG
flags_sanitize := -O1 -g -fsanitize=address,undefined \
	-fno-sanitize-recover=all -fno-omit-frame-pointer
flags_fuzz := $(flags_sanitize) -fsanitize=fuzzer-no-link -DTESSERA_FUZZ

# Asked when a recipe runs: on a fresh machine the packages come before it.
xml_flags = $(shell $(PKG_CONFIG) --cflags libxml-2.0)

common := $(flags_$(config)) -pthread -Ilib -D_POSIX_C_SOURCE=200809L
all_cflags = -std=c11 $(warnings_c) $(common) $(CPPFLAGS) $(CFLAGS)
all_cxxflags = -std=c++17 $(warnings) $(common) $(CPPFLAGS) $(CXXFLAGS)
all_ldflags = $(flags_$(config)) -pthread -Wl,--as-needed $(LDFLAGS)
libs := -lxml2 -lproj -lGLU -ljansson -ltinygltf -lOpenMeshCore -ldeflate -lz -lm

# ---- what is built ---------------------------------------------------------

# A program is the file with its main, what it needs of the other files of its
# folder, and what it needs of lib/. Those whose main is there are built.
all_programs := parsers/citygml2tcs parsers/ifc2tcs parsers/json2tcs \
	simplify/tcs-compare simplify/tcs-exterior \
	simplify/tcs-simplify writers/tcs2json \
	writers/tcs2gltf writers/tcs2citygml tessera
programs := $(patsubst %.c,%,$(wildcard $(addsuffix .c,$(all_programs))))
program_names := $(notdir $(programs))
pages := $(wildcard *.1 parsers/*.1 simplify/*.1 writers/*.1 lib/*.5)
folders := lib parsers simplify writers

bin := $(build)/bin
binaries := $(addprefix $(bin)/,$(program_names))
objects_of = $(addprefix $(build)/,$(addsuffix .o,$(basename $(1))))
sources_in = $(filter-out $(addsuffix .c,$(all_programs)),\
	$(wildcard $(1)/*.c $(1)/*.cpp))
# `make V=1` shows the commands.
show = $(if $(V),,@echo '  $(1) $@';)
archive_of = $(if $(1),$(if $(call sources_in,$(1)),$(build)/$(1).a))
# Tests link what they need of every folder; lib stands last.
archives := $(strip $(foreach folder,parsers simplify writers lib,\
	$(call archive_of,$(folder))))

.PHONY: all demo test unit seeds cases suites cases-accept lint format bench \
	fuzz install uninstall clean help demo-here test-here \
	lint-build lint-syntax bench-peers FORCE
.DELETE_ON_ERROR:
.SECONDARY:

all: $(binaries)

define archive_rule
$(build)/$(1).a: $(call objects_of,$(call sources_in,$(1)))
	$$(call show,AR)rm -f $$@ && $$(AR) rcs $$@ $$^
endef
$(foreach folder,$(folders),$(if $(call sources_in,$(folder)),\
	$(eval $(call archive_rule,$(folder)))))

folder_of = $(patsubst %/,%,$(dir $(1)))
define program_rule
$(bin)/$(notdir $(1)): $(call objects_of,$(1).c) \
	$(call archive_of,$(filter parsers simplify writers,\
	$(call folder_of,$(1)))) \
	$(build)/lib.a $(build)/flags
	@mkdir -p $$(@D)
	$$(call show,LD)$(if $(wildcard $(dir $(1))*.cpp),$$(CXX),$$(CC)) $$(all_ldflags) \
		-o $$@ $$(filter %.o %.a,$$^) $$(libs)
endef
$(foreach program,$(programs),$(eval $(call program_rule,$(program))))

$(build)/%.o: %.c $(build)/flags
	@mkdir -p $(@D)
	$(call show,CC)$(CC) $(all_cflags) $(own_flags) -MMD -MP -c -o $@ $<

$(build)/%.o: %.cpp $(build)/flags
	@mkdir -p $(@D)
	$(call show,CXX)$(CXX) $(all_cxxflags) $(own_flags) -MMD -MP -c -o $@ $<

$(build)/parsers/%.o: own_flags = $(xml_flags)
$(build)/tests/%.o: own_flags = -I. -Itests/unit $(xml_flags)

# Changes, and so rebuilds everything, when the flags do.
$(build)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(CC) $(all_cflags) / $(CXX) $(all_cxxflags) / $(all_ldflags)' \
		>$@.new
	@cmp -s $@ $@.new && rm $@.new || mv $@.new $@

-include $(wildcard $(build)/*.d $(build)/*/*.d $(build)/*/*/*.d)

# ---- tests, benches, fuzz targets, sample generators -----------------------

built_from = $(patsubst %.c,$(build)/%,$(wildcard $(1)))
unit_tests := $(call built_from,tests/unit/*_test.c)
benches := $(call built_from,tests/bench/*_bench.c) \
	$(call built_from,tests/bench/*_bare.c) \
	$(patsubst %.cpp,$(build)/%,$(filter-out tests/bench/peer_%.cpp,\
		$(wildcard tests/bench/*.cpp)))
peer_parts := $(call objects_of,$(wildcard tests/bench/peer_*.c) \
	$(wildcard tests/bench/peer_*.cpp))
tools := $(call built_from,tests/tools/*.c)
generators := $(call built_from,samples/make*.c)
generator_parts := $(addprefix $(build)/,$(patsubst %.c,%.o,$(filter-out \
	$(wildcard samples/make*.c),$(wildcard samples/*.c))))
fuzzers := $(patsubst tests/fuzz/%_fuzz.c,$(build)/fuzz/%,\
	$(wildcard tests/fuzz/*_fuzz.c))
replays := $(call built_from,tests/fuzz/*_fuzz.c)
link_test = $(call show,LD)$(CXX) $(all_ldflags) -o $@ $(filter %.o %.a,$^) $(libs)

$(unit_tests) $(benches) $(tools): $(build)/%: $(build)/%.o $(archives) $(build)/flags
	$(link_test)

# What simplifiers are measured beside; the libraries are for this alone.
$(build)/tests/bench/lod_peer: $(peer_parts) $(archives) $(build)/flags
	$(call show,LD)$(CXX) $(all_ldflags) -o $@ $(filter %.o %.a,$^) $(libs) \
		-lmeshoptimizer -lOpenMeshTools -lOpenMeshCore -lgmp

# Each generator takes of the parts what it needs.
$(build)/samples.a: $(generator_parts)
	$(call show,AR)rm -f $@ && $(AR) rcs $@ $^

$(generators): $(build)/%: $(build)/%.o $(build)/samples.a $(build)/lib.a \
		$(build)/flags
	$(link_test)

$(fuzzers): $(build)/fuzz/%: $(build)/tests/fuzz/%_fuzz.o $(archives) \
		$(build)/flags
	@mkdir -p $(@D)
	$(link_test) -fsanitize=fuzzer

# The same without a fuzzer, to run over the seeds.
$(replays): $(build)/%: $(build)/%.o $(build)/tests/fuzz/replay.o $(archives) \
		$(build)/flags
	$(link_test)

# All processors, unless -j says otherwise.
in_parallel = $(MAKE) --no-print-directory \
	$(if $(filter -j%,$(MAKEFLAGS)),,-j$(shell nproc))

# What the scripts under tests/ need to know.
run = BUILD='$(abspath $(build))' CC='$(CC)' CXX='$(CXX)' tests/run.sh

demo:
	@tests/packages.sh build
	@$(in_parallel) demo-here

demo-here: all
	@BUILD='$(abspath $(build))' samples/demo.sh

test:
	@tests/packages.sh build test
	@$(in_parallel) test-here

# The validator and the viewer of the tests, as the lock file pins them.
node_lock := $(wildcard tests/node/package-lock.json)
node_modules := $(if $(node_lock),tests/node/node_modules/.package-lock.json)

$(node_modules): $(node_lock)
	$(call show,NPM)cd tests/node && npm ci --loglevel=error --ignore-scripts \
		--no-audit --no-fund && touch node_modules/.package-lock.json

test-here: all $(unit_tests) $(replays) $(tools) $(generators) $(node_modules)
	@$(run) suites cases seeds unit

unit: $(unit_tests)
	@$(run) unit

seeds: $(replays)
	@$(run) seeds

cases: all $(generators)
	@$(run) cases

suites: all $(tools) $(generators) $(node_modules)
	@$(run) suites

cases-accept: all $(generators)
	@BUILD='$(abspath $(build))' tests/run-cases.sh --accept $(CASES)

bench: all $(benches) $(generators) $(node_modules) \
	$(if $(filter lod simplify visibility,$(BENCH)),bench-peers)
	@BUILD='$(abspath $(build))' tests/bench/run.sh $(BENCH)

bench-peers:
	@tests/packages.sh bench
	@$(in_parallel) $(build)/tests/bench/lod_peer

ifeq ($(config),fuzz)
SECONDS ?= 60
fuzz: $(fuzzers)
	@BUILD='$(abspath $(build))' tests/fuzz/run.sh '$(SECONDS)' $(NAME)
else
fuzz:
	@$(in_parallel) config=fuzz fuzz
endif

lint:
	@tests/packages.sh build lint
	@$(in_parallel) all
	@BUILD='$(abspath $(build))' tests/lint.sh

# Everything that is C or C++, for the compilers' warnings.
test_programs := $(unit_tests) $(replays) $(benches) $(tools) $(generators)
lint-build: all $(test_programs)

# The same, no further than the objects.
lint-syntax: $(call objects_of,$(foreach folder,$(folders),\
	$(call sources_in,$(folder))) $(addsuffix .c,$(programs))) \
	$(addsuffix .o,$(test_programs)) $(generator_parts) \
	$(build)/tests/fuzz/replay.o

format:
	clang-format -i $$(tests/lint.sh --sources)

# ---- installation ----------------------------------------------------------

destination := $(DESTDIR)$(PREFIX)
man := $(destination)/share/man

install: all
	install -d '$(destination)/bin' '$(man)/man1' '$(man)/man5'
	install -m 755 $(binaries) '$(destination)/bin'
	install -m 644 $(filter %.1,$(pages)) '$(man)/man1'
	$(if $(filter %.5,$(pages)),install -m 644 $(filter %.5,$(pages)) \
		'$(man)/man5')

uninstall:
	rm -f $(foreach name,$(program_names),'$(destination)/bin/$(name)') \
		$(foreach page,$(notdir $(filter %.1,$(pages))),\
		'$(man)/man1/$(page)') \
		$(foreach page,$(notdir $(filter %.5,$(pages))),\
		'$(man)/man5/$(page)')

clean:
	rm -rf build

help:
	@echo 'make demo       set up, build, turn a sample town into a GLB'
	@echo 'make test       set up, build, run every test'
	@echo 'make all        build the programs into $(bin)'
	@echo 'make unit | seeds | cases | suites'
	@echo '                build and run one kind of test'
	@echo 'make cases-accept [CASES="tessera/help ..."]'
	@echo '                rewrite the expectations of the cases'
	@echo 'make lint       format, layering, sizes, man pages, scripts'
	@echo 'make format     format the sources in place'
	@echo 'make bench [BENCH="name ..."]'
	@echo '                measure'
	@echo 'make fuzz [NAME=name] [SECONDS=60]'
	@echo '                fuzz one reader, or each in turn'
	@echo 'make install    into $$(DESTDIR)$$(PREFIX): $(destination)'
	@echo 'make uninstall | clean | help'
	@echo
	@echo 'config=debug|release|sanitize|fuzz  (now: $(config))'
	@echo 'CC=clang        build with clang, in a folder of its own'
	@echo 'WERROR=1 V=1    warnings are errors; show the commands'
