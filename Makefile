# archard: wear of sliding surfaces. `make` builds, `make demo` shows, `make check` tests.

PREFIX  ?= /usr/local
BINDIR  ?= $(PREFIX)/bin
LIBDIR  ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DATADIR ?= $(PREFIX)/share
MANDIR  ?= $(DATADIR)/man

CC      ?= cc
CFLAGS  ?= -O2 -g
WARNINGS = -Wall -Wextra -Wshadow -Wmissing-prototypes -Wstrict-prototypes -Wconversion -Werror
SANITIZER ?=

comma := ,
BUILD = build$(if $(SANITIZER),-$(subst $(comma),-,$(SANITIZER)))
OBJ   = $(BUILD)/obj

PACKAGES = lua5.4 readline sqlite3
pkg_cflags := $(shell pkg-config --cflags $(PACKAGES) 2>/dev/null)
lua_libs    = $(shell pkg-config --libs lua5.4)
rl_libs     = $(shell pkg-config --libs readline)
sql_libs    = $(shell pkg-config --libs sqlite3)
# One gcc flag set for every file: -std=c11 with POSIX; contraction off, so that results do not
# depend on what the compiler fuses.
all_cflags = -std=c11 -D_POSIX_C_SOURCE=200809L -Iinclude -Isrc $(pkg_cflags) -MMD -MP \
             -ffp-contract=off $(WARNINGS) \
             $(if $(SANITIZER),-fsanitize=$(SANITIZER) -fno-omit-frame-pointer -fno-sanitize-recover=all) \
             $(CPPFLAGS) $(CFLAGS)
all_ldflags = $(if $(SANITIZER),-fsanitize=$(SANITIZER)) $(LDFLAGS)
core_libs = -lcholmod -llapack -lblas -lgomp -lm

core_src  := $(wildcard src/core/*/*.c)
side_src  := $(wildcard src/system/*.c src/plot/*.c src/store/*.c)
front_src := $(wildcard src/lua/*/*.c src/cli/*.c)
# What stands in scripts/tools is run by make; all else is embedded.
scripts   := $(sort $(filter-out scripts/tools/%,$(wildcard scripts/*/*.lua)))
obj_of     = $(patsubst %.c,$(OBJ)/%.o,$(1))

core_lib = $(BUILD)/libarchard.a
program  = $(BUILD)/archard

unit_src   := $(wildcard tests/unit/*.c)
unit_tests  = $(patsubst tests/unit/%.c,$(BUILD)/tests/%,$(unit_src))

.PHONY: all demo check study figures test-programs bench gallery man format lint install uninstall clean setup
.DELETE_ON_ERROR:

all: $(program)

# --- set-up -----------------------------------------------------------------------------------
# Plain `make` never installs: it names what is missing. `make demo` and `make check` install.
ifneq ($(MAKECMDGOALS),clean)
ifneq ($(MAKECMDGOALS),uninstall)
ifeq ($(filter demo check setup,$(MAKECMDGOALS)),)
# The list goes to standard error line by line; what is left is whether there was one.
missing := $(shell scripts/setup --list | tee /dev/stderr)
ifneq ($(missing),)
$(error These packages are missing. scripts/setup installs them)
endif
endif
endif
endif

setup:
	@scripts/setup

jobs  = $(shell nproc 2>/dev/null || echo 2)
# `make V=1` shows whole commands.
quiet = $(if $(V),,@)
say   = @$(if $(V),:,echo " ")

# --- build ------------------------------------------------------------------------------------
$(OBJ)/%.o: %.c
	@mkdir -p $(@D)
	$(say) CC $<
	$(quiet)$(CC) $(all_cflags) -c $< -o $@

$(core_lib): $(call obj_of,$(core_src))
	@rm -f $@
	$(say) AR $@
	$(quiet)$(AR) rcs $@ $^

# The Lua files that ship live inside the binary.
$(BUILD)/embedded.c: scripts/tools/embed.awk $(scripts)
	@mkdir -p $(@D)
	$(quiet)awk -f scripts/tools/embed.awk $(scripts) > $@

$(OBJ)/embedded.o: $(BUILD)/embedded.c
	@mkdir -p $(@D)
	$(say) CC $<
	$(quiet)$(CC) $(all_cflags) -c $< -o $@

$(program): $(call obj_of,$(front_src)) $(call obj_of,$(side_src)) $(OBJ)/embedded.o $(core_lib)
	$(say) LD $@
	$(quiet)$(CC) $(all_ldflags) -rdynamic $^ $(lua_libs) $(rl_libs) $(sql_libs) $(core_libs) -ldl -o $@

# A unit test links the engine, plot and store, never Lua or readline: that it links is a test.
$(BUILD)/tests/%: $(OBJ)/tests/unit/%.o $(call obj_of,$(side_src)) $(core_lib)
	@mkdir -p $(@D)
	$(say) LD $@
	$(quiet)$(CC) $(all_ldflags) $^ $(test_ldflags) -lcmocka $(sql_libs) $(core_libs) -o $@

# Out of memory on demand: this test stands between the engine and its allocations.
$(BUILD)/tests/test_oom: test_ldflags = -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free \
                                        -lsuitesparseconfig

test-programs: $(program) $(unit_tests)

# --- use --------------------------------------------------------------------------------------
demo:
	@scripts/setup
	@$(MAKE) --no-print-directory -j$(jobs) all
	@$(program) examples/demo.lua

check:
	@scripts/setup test
	@$(MAKE) --no-print-directory -j$(jobs) test-programs
	@BUILD=$(BUILD) SANITIZER=$(SANITIZER) tests/run

# The pictures of examples/gallery/.
gallery: $(program)
	$(program) examples/gallery.lua

# One BLAS thread from the start: an idle one would spin for its first 50 ms and be counted.
bench: $(program)
	OPENBLAS_NUM_THREADS=1 $(program) scripts/tools/bench.lua

# The paper's study. What an older program computed is not gone on with.
study figures: $(program)
	@for file in $(BUILD)/study.archard $(BUILD)/study-*.archard; do \
	  [ ! $$file -ot $(program) ] || rm -f $$file; done
	$(program) scripts/tools/study20.lua --file $(BUILD)/study.archard --figures $(BUILD)/figures \
	  $(if $(filter figures,$@),--converge)

# The reference part of the manual comes from the help entries inside the program.
man: $(program)
	$(program) scripts/tools/manpage.lua > man/archard.1

# --- care -------------------------------------------------------------------------------------
c_files = $(wildcard include/archard/*.h src/*/*.[ch] src/*/*/*.[ch] tests/unit/*.[ch])

format:
	@clang-format -i $(c_files)

lint:
	@clang-format --dry-run --Werror $(c_files)
	@cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr \
	  --error-exitcode=1 --suppress=missingIncludeSystem -Iinclude -Isrc src
	@shellcheck -S warning scripts/setup scripts/slurm/study.sbatch scripts/slurm/parallel tests/run .ci/run tests/tap.bash \
	  $(shell grep -l '^\#!.*bash' tests/cli/* tests/guard/*)
	@mandoc -T lint -W warning man/*.1

install: all
	install -d $(DESTDIR)$(BINDIR) $(DESTDIR)$(LIBDIR) $(DESTDIR)$(INCLUDEDIR)/archard $(DESTDIR)$(MANDIR)/man1
	install -m 755 $(program) $(DESTDIR)$(BINDIR)/archard
	install -m 644 $(core_lib) $(DESTDIR)$(LIBDIR)/libarchard.a
	install -m 644 include/archard/*.h $(DESTDIR)$(INCLUDEDIR)/archard/
	install -m 644 man/archard.1 $(DESTDIR)$(MANDIR)/man1/archard.1

uninstall:
	rm -f $(DESTDIR)$(BINDIR)/archard $(DESTDIR)$(LIBDIR)/libarchard.a $(DESTDIR)$(MANDIR)/man1/archard.1
	rm -rf $(DESTDIR)$(INCLUDEDIR)/archard

clean:
	rm -rf build build-*

-include $(shell find $(OBJ) -name '*.d' 2>/dev/null)
