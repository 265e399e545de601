# tessera: CityGML and IFC through Unix pipes. `make help` lists the targets.

config ?= release
build ?= build/$(config)
PREFIX ?= /usr/local
CC = gcc
CXX = g++
PKG_CONFIG ?= pkg-config

configs := debug release sanitize fuzz
ifeq ($(filter $(config),$(configs)),)
$(error config=$(config) is none of: $(configs))
endif

# ---- flags -----------------------------------------------------------------

warnings := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wwrite-strings -Wvla
warnings_c := $(warnings) -Wstrict-prototypes -Wmissing-prototypes
flags_debug := -O1 -g
flags_release := -O2 -g -DNDEBUG
flags_sanitize := -O1 -g -fsanitize=address,undefined \
	-fno-sanitize-recover=all -fno-omit-frame-pointer
flags_fuzz := $(flags_sanitize) -fsanitize=fuzzer-no-link -DTESSERA_FUZZ
ifeq ($(config),fuzz)
CC = clang
CXX = clang++
endif
ifdef WERROR
warnings += -Werror
endif

# Recipes run only once the packages are there, so ask pkg-config lazily.
xml_flags = $(shell $(PKG_CONFIG) --cflags libxml-2.0 2>/dev/null)
xml_libs = $(shell $(PKG_CONFIG) --libs libxml-2.0 2>/dev/null)

common := $(flags_$(config)) -pthread -Ilib -D_POSIX_C_SOURCE=200809L
all_cflags = -std=c11 $(warnings_c) $(common) $(CPPFLAGS) $(CFLAGS)
all_cxxflags = -std=c++17 $(warnings) $(common) $(CPPFLAGS) $(CXXFLAGS)
all_ldflags = $(flags_$(config)) -pthread $(LDFLAGS)

# ---- what is built ---------------------------------------------------------

# A program's sources: the file with its main, and the files of its family.
# Each lists its own libraries; a C++ file makes it link with the C++ compiler.
programs := parsers/citygml2tcs parsers/json2tcs writers/tcs2json \
	writers/tcs2gltf tessera

citygml2tcs_sources := parsers/citygml2tcs.c parsers/srs.c \
	$(wildcard parsers/citygml_*.c)
citygml2tcs_libs = $(xml_libs) -lproj -lGLU -lz -lm
json2tcs_sources := parsers/json2tcs.c $(wildcard parsers/json_*.c)
json2tcs_libs = -ljansson -lz -lm
tcs2json_sources := writers/tcs2json.c $(wildcard writers/json_*.c)
tcs2json_libs = -lz -lm
tcs2gltf_sources := writers/tcs2gltf.c $(wildcard writers/gltf_*.c) \
	$(wildcard writers/gltf_*.cpp)
tcs2gltf_libs = -ltinygltf -lz -lm
tessera_sources := tessera.c
tessera_libs = -lz -lm

lib_objects := $(patsubst %.c,$(build)/%.o,$(wildcard lib/*.c))
lib_archive := $(build)/libtessera.a
bin := $(build)/bin
program_names := $(notdir $(programs))
pages := $(wildcard *.1 parsers/*.1 simplify/*.1 writers/*.1)

objects_of = $(patsubst %.cpp,$(build)/%.o,$(patsubst %.c,$(build)/%.o,$(1)))
link_with = $(if $(filter %.cpp,$(1)),$(CXX),$(CC))

.PHONY: all demo test unit cases lint bench install clean help packages
.DELETE_ON_ERROR:

all: $(addprefix $(bin)/,$(program_names))

define program_rule
$(bin)/$(1): $(call objects_of,$($(1)_sources)) $(lib_archive)
	@mkdir -p $$(@D)
	$(call link_with,$($(1)_sources)) $$(all_ldflags) -o $$@ $$^ $$($(1)_libs)
endef
$(foreach name,$(program_names),$(eval $(call program_rule,$(name))))

$(lib_archive): $(lib_objects)
	@mkdir -p $(@D)
	rm -f $@
	$(AR) rcs $@ $^

$(build)/%.o: %.c Makefile
	@mkdir -p $(@D)
	$(CC) $(all_cflags) $(cflags_$(basename $(notdir $<))) -MMD -MP -c -o $@ $<

$(build)/%.o: %.cpp Makefile
	@mkdir -p $(@D)
	$(CXX) $(all_cxxflags) -MMD -MP -c -o $@ $<

$(call objects_of,$(citygml2tcs_sources)): CPPFLAGS += $(xml_flags)

-include $(shell find $(build) -name '*.d' 2>/dev/null)

# ---- tests -----------------------------------------------------------------

unit_tests := $(patsubst tests/unit/%.c,$(build)/tests/unit/%,\
	$(wildcard tests/unit/*_test.c))

$(build)/tests/unit/%: $(build)/tests/unit/%.o $(lib_archive)
	$(CC) $(all_ldflags) -o $@ $(filter %.o,$^) $(lib_archive) \
		-lproj -lGLU -ljansson -lz -lm

# A test of a file that is not in lib links that file too.
$(build)/tests/unit/srs_test: $(build)/parsers/srs.o

unit: $(unit_tests)
