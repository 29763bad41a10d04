# archard: wear of sliding surfaces. `make` builds, `make demo` shows, `make check` tests.

PREFIX  ?= /usr/local
BINDIR  ?= $(PREFIX)/bin
LIBDIR  ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DATADIR ?= $(PREFIX)/share
MANDIR  ?= $(DATADIR)/man
LUADIR  ?= $(LIBDIR)/lua/5.4
BASHDIR ?= $(DATADIR)/bash-completion/completions
ZSHDIR  ?= $(DATADIR)/zsh/site-functions
DOCDIR  ?= $(DATADIR)/doc/archard

# Who is asked about the package.
MAINTAINER ?= the authors of archard <archard@localhost>

CC         ?= cc
CFLAGS     ?= -O2 -g
PKG_CONFIG ?= pkg-config
export CC CFLAGS CPPFLAGS LDFLAGS PKG_CONFIG
# WERROR=1 makes warnings errors: for developers and CI. SANITIZER=address,undefined, and CHECKS=1
# (every step of a run is validated), build in folders of their own.
WARNINGS = -Wall -Wextra -Wshadow -Wmissing-prototypes -Wstrict-prototypes -Wconversion -pedantic -Wno-overlength-strings

comma := ,
BUILD = build$(if $(SANITIZER),-$(subst $(comma),-,$(SANITIZER)))$(if $(CHECKS),-checks)
OBJ   = $(BUILD)/obj

.PHONY: all demo check check-full coverage fuzz fuzz-programs golden study figures test-programs bench peer gallery format lint install \
        install-files uninstall clean setup dist dist-check deb deb-check readme-check slurm-check
.DELETE_ON_ERROR:

all:

# --- what is built ----------------------------------------------------------------------------
lib_src   := $(wildcard src/core/*/*.c src/store/*.c)
plot_src  := $(wildcard src/system/*.c src/plot/*.c)
front_src := $(wildcard src/lua/*/*.c src/cli/*.c)
unit_src  := $(wildcard tests/unit/*.c)
# What stands in scripts/tools is run by make; all else is embedded.
scripts   := $(sort $(filter-out scripts/tools/%,$(wildcard scripts/*/*.lua)))

obj_of     = $(patsubst %.c,$(OBJ)/%.o,$(1))
lib_obj   := $(call obj_of,$(lib_src))
plot_obj  := $(call obj_of,$(plot_src))
front_obj := $(call obj_of,$(front_src)) $(OBJ)/embedded.o
unit_tests = $(patsubst tests/unit/%.c,$(BUILD)/tests/%,$(unit_src))
fuzz_src  := $(filter-out tests/fuzz/replay.c,$(wildcard tests/fuzz/*.c))
replays    = $(patsubst tests/fuzz/%.c,$(BUILD)/replay/%,$(fuzz_src))
fuzzers    = $(patsubst tests/fuzz/%.c,$(BUILD)/fuzz/%,$(fuzz_src))

version   := $(shell sed -n 's/^.define ARC_VERSION "\(.*\)"/\1/p' include/archard/base.h)
soname     = libarchard.so.$(firstword $(subst ., ,$(version)))
shared_lib = $(BUILD)/libarchard.so.$(version)
static_lib = $(BUILD)/libarchard.a
program    = $(BUILD)/archard
lua_module = $(BUILD)/lua/archard.so
made_pages = $(BUILD)/man/archard-lua.7 $(BUILD)/man/archard-file.5

# Folders and flags may hold spaces and quotes.
quoted = '$(subst ','\'',$(1))'

# --- with what --------------------------------------------------------------------------------
# Plain `make` never installs: scripts/probe names what is missing. `make demo` and `make check`
# install. Two notes in the build folder are written where they differ from what they hold: after
# other flags all is probed and compiled anew, after other files all is linked anew.
ifneq ($(filter-out check check-full clean coverage demo fuzz dist dist-check format install-files readme-check lint setup uninstall,$(or $(MAKECMDGOALS),all)),)
flags   := $(strip $(CC); $(CPPFLAGS); $(CFLAGS); $(LDFLAGS); $(PKG_CONFIG); $(WERROR))
sources := $(strip $(lib_src) $(plot_src) $(front_src) $(scripts))
$(shell mkdir -p $(BUILD))
ifneq ($(flags),$(file <$(BUILD)/flags))
$(file >$(BUILD)/flags,$(flags))
endif
ifneq ($(sources),$(file <$(BUILD)/sources))
$(file >$(BUILD)/sources,$(sources))
endif

# Probed anew after other flags, another probe, another Makefile.
probe = CC=$(call quoted,$(CC)) CPPFLAGS=$(call quoted,$(CPPFLAGS)) CFLAGS=$(call quoted,$(CFLAGS)) \
        LDFLAGS=$(call quoted,$(LDFLAGS)) PKG_CONFIG=$(call quoted,$(PKG_CONFIG)) scripts/probe
ifneq ($(shell find scripts/probe Makefile $(BUILD)/flags -newer $(BUILD)/config.mk 2>/dev/null || echo none),)
probed := $(shell $(probe) > $(BUILD)/config.mk.new && mv $(BUILD)/config.mk.new $(BUILD)/config.mk || echo no)
ifeq ($(probed),no)
$(error packages are missing. `make demo` and `make check` install them)
endif
endif

include $(BUILD)/config.mk
else
-include $(BUILD)/config.mk
endif

# What the compiler can do against memory errors that are still there. Checked calls need an
# optimising compiler, and hide from the sanitizers what they look for.
hardening   = -fstack-protector-strong $(guard_cflags) -fPIE \
              $(if $(SANITIZER),,$(if $(filter-out -O0,$(filter -O%,$(CFLAGS))),-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3))

# One set of flags for every file: -std=c11 with POSIX and what glibc has beyond it (on_exit, P_tmpdir),
# whatever the flags of the libraries bring; contraction off, so that results do not depend on what the
# compiler fuses; loops marked for it are vectorised, which changes no bit.
all_cflags = -std=c11 -D_DEFAULT_SOURCE -D_POSIX_C_SOURCE=200809L -Iinclude -Isrc -MMD -MP -ffp-contract=off -fopenmp-simd \
             $(lua_cflags) $(cholmod_cflags) $(readline_cflags) $(sqlite_cflags) $(gsl_cflags) $(fftw_cflags) $(omp_cflags) \
             $(hardening) $(WARNINGS) $(if $(WERROR),-Werror) $(if $(CHECKS),-DARC_CHECKS) \
             $(if $(SANITIZER),-fsanitize=$(SANITIZER) -fno-omit-frame-pointer -fno-sanitize-recover=all) \
             $(CPPFLAGS) $(CFLAGS)
all_ldflags = -Wl,-z,relro,-z,now,-z,noexecstack $(if $(SANITIZER),-fsanitize=$(SANITIZER)) $(LDFLAGS)
lib_libs    = $(sqlite_libs) $(fftw_libs) $(cholmod_libs) $(blas_libs) $(omp_libs) -lm

jobs  = $(shell nproc 2>/dev/null || echo 2)
# `make V=1` shows whole commands.
quiet = $(if $(V),,@)
say   = @$(if $(V),:,echo " ")

# --- build ------------------------------------------------------------------------------------
all: $(program) $(static_lib) $(shared_lib) $(lua_module) $(made_pages)

# The shared library exports what the public headers declare and nothing else.
$(lib_obj): all_cflags += -fPIC -fvisibility=hidden -fno-semantic-interposition
# What else goes into the module for the stock interpreter.
module_obj := $(plot_obj) $(filter-out $(OBJ)/src/cli/%,$(front_obj))
$(module_obj): all_cflags += -fPIC

$(OBJ)/%.o: %.c $(BUILD)/config.mk
	@mkdir -p $(@D)
	$(say) CC $<
	$(quiet)$(CC) $(all_cflags) -c $< -o $@

$(static_lib): $(lib_obj) $(BUILD)/sources
	@rm -f $@
	$(say) AR $@
	$(quiet)$(AR) rcs $@ $(lib_obj)

$(shared_lib): $(lib_obj) $(BUILD)/sources
	$(say) LD $@
	$(quiet)$(CC) $(all_ldflags) -shared -Wl,-soname,$(soname) $(lib_obj) $(lib_libs) -o $@

# The Lua files that ship live inside the binary.
$(BUILD)/embedded.c: scripts/tools/embed.awk $(scripts) $(BUILD)/sources
	$(quiet)awk -f scripts/tools/embed.awk $(scripts) > $@

$(OBJ)/embedded.o: $(BUILD)/embedded.c $(BUILD)/config.mk
	@mkdir -p $(@D)
	$(say) CC $<
	$(quiet)$(CC) $(all_cflags) -c $< -o $@

$(program): $(front_obj) $(plot_obj) $(static_lib) $(BUILD)/sources
	$(say) LD $@
	$(quiet)$(CC) -pie $(all_ldflags) -rdynamic $(filter-out %/sources,$^) $(lua_libs) $(readline_libs) $(gsl_libs) $(lib_libs) -ldl -o $@

# The module for the stock interpreter: the program without its command and prompt. It stays loaded,
# for the threads of BLAS and OpenMP run in it to the end.
$(lua_module): $(module_obj) $(static_lib) $(BUILD)/sources
	@mkdir -p $(@D)
	@echo '{ global: luaopen_archard; local: *; };' > $(OBJ)/module.map
	$(say) LD $@
	$(quiet)$(CC) $(all_ldflags) -shared -Wl,-z,nodelete,--version-script=$(OBJ)/module.map \
	  $(module_obj) $(static_lib) $(gsl_libs) $(lib_libs) -o $@

# The reference comes from the help entries inside the program, the format of run files from their header.
$(BUILD)/man/archard-lua.7: scripts/tools/manpage.lua $(program)
$(BUILD)/man/archard-file.5: scripts/tools/manfile.lua include/archard/store.h $(program)
$(made_pages):
	@mkdir -p $(@D)
	$(say) MAN $@
	$(quiet)$(program) $(filter-out $(program),$^) > $@

# A unit test links the library and plot, never Lua or readline: that it links is a test.
$(unit_tests): $(BUILD)/tests/%: $(OBJ)/tests/unit/%.o $(plot_obj) $(static_lib)
	@mkdir -p $(@D)
	$(say) LD $@
	$(quiet)$(CC) -pie $(all_ldflags) $^ $(test_ldflags) -lcmocka $(lib_libs) -o $@

# Out of memory on demand: this test stands between the engine and its allocations.
$(BUILD)/tests/test_oom: test_ldflags = -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free \
                                        -lsuitesparseconfig

# What tests load into the program.
preloaded = $(patsubst %,$(BUILD)/tests/%.so,failing locks power)
$(preloaded): $(BUILD)/tests/%.so: tests/memory/%.c
	@mkdir -p $(@D)
	$(say) LD $@
	$(quiet)$(CC) -O1 -std=gnu11 $(WARNINGS) -shared -fPIC $< -o $@

# A fuzz target sees all but the command and its prompt; SQLite is there to damage files with.
fuzzed = $(filter-out $(OBJ)/src/cli/%,$(front_obj)) $(OBJ)/src/cli/history_file.o $(plot_obj) $(static_lib)
fuzz_libs = $(lua_libs) $(gsl_libs) $(lib_libs) -ldl
$(replays): $(BUILD)/replay/%: $(OBJ)/tests/fuzz/%.o $(OBJ)/tests/fuzz/replay.o $(fuzzed)
	@mkdir -p $(@D)
	$(say) LD $@
	$(quiet)$(CC) -pie $(all_ldflags) $^ $(fuzz_libs) -o $@

$(fuzzers): $(BUILD)/fuzz/%: $(OBJ)/tests/fuzz/%.o $(fuzzed)
	@mkdir -p $(@D)
	$(say) LD $@
	$(quiet)$(CC) $(all_ldflags) -fsanitize=fuzzer $^ $(fuzz_libs) -o $@

test-programs: all $(unit_tests) $(replays) $(preloaded)
fuzz-programs: $(fuzzers)

-include $(patsubst %.o,%.d,$(lib_obj) $(plot_obj) $(front_obj) $(call obj_of,$(unit_src) $(wildcard tests/fuzz/*.c)))

# --- use --------------------------------------------------------------------------------------
demo:
	@scripts/setup
	@$(MAKE) --no-print-directory -j$(jobs) all
	@$(program) examples/02_wear.lua
	@echo
	@echo 'Next: $(program) starts the prompt; type help() or examples() there.'

check:
	@scripts/setup test
	@$(MAKE) --no-print-directory -j$(jobs) test-programs
	@BUILD=$(BUILD) SANITIZER=$(SANITIZER) tests/run

# Everything: long files too.
check-full:
	@scripts/setup test full
	@$(MAKE) --no-print-directory -j$(jobs) test-programs
	@BUILD=$(BUILD) SANITIZER=$(SANITIZER) tests/run -a

# What share of the sources' lines and branches the tests reach, in a build folder of its own. Counted
# is what stands in the sources, once: no copies of loops for other processors (ARC_NARROW), no branches
# that gcc makes of Lua's hints about which way a check goes (LUA_NOBUILTIN).
coverage:
	@scripts/setup test
	@$(MAKE) --no-print-directory -j$(jobs) BUILD=build-coverage CFLAGS="-O0 -g --coverage" LDFLAGS=--coverage \
	  CPPFLAGS="$(CPPFLAGS) -DARC_NARROW -DLUA_NOBUILTIN" test-programs
	@find build-coverage -name '*.gcda' -delete
	@BUILD=build-coverage ARCHARD_POINTS=400 tests/run tests/unit/ tests/fuzz/ tests/lua/ tests/cli/ \
	  verify/functions verify/geometry verify/hertz verify/revolved verify/waves; \
	status=$$?; tests/coverage build-coverage; exit $$status

# Inputs made to break things, by clang's libFuzzer under its sanitizers: SECONDS of each target, or of
# the one named by TARGET. What was found, and what reached new code, stays in the folder of the build.
SECONDS = 60
fuzz:
	@scripts/setup fuzz
	@$(MAKE) --no-print-directory -j$(jobs) CC=clang SANITIZER=fuzzer-no-link,address,undefined fuzz-programs
	@tests/fuzz/run $(SECONDS) $(TARGET)

# Hashes of all that the 20 cases come to, which must be one: optimised or not, by one worker or four,
# in one go or from files. (Bits may differ from machine to machine, by the BLAS that is there.)
golden: $(program)
	@$(MAKE) --no-print-directory -j$(jobs) BUILD=build-O0 CFLAGS=-O0 build-O0/archard
	@set -e; for p in "$(program)" build-O0/archard; do for how in 1 4 "1 broken"; do \
	  hash=$$($$p scripts/tools/golden.lua $$how 2>/dev/null); \
	  printf '%-20s workers %-10s %s\n' "$$p" "$$how" "$$hash"; echo $$hash >> $(BUILD)/golden.new; done; done; \
	  count=$$(sort -u $(BUILD)/golden.new | wc -l); rm $(BUILD)/golden.new; \
	  [ $$count -eq 1 ] || { echo "the hashes differ"; exit 1; }

# The pictures of examples/gallery/, one of each example.
gallery: $(program)
	@rm -rf $(BUILD)/gallery && mkdir -p $(BUILD)/gallery examples/gallery
	cd $(BUILD)/gallery && '$(abspath $(program))' '$(CURDIR)/scripts/tools/gallery.lua' '$(CURDIR)/examples/gallery' >/dev/null

# One BLAS thread from the start: an idle one would spin for its first 50 ms and be counted.
bench: $(program)
	OPENBLAS_NUM_THREADS=1 $(program) scripts/tools/bench.lua

# The exported decks through CalculiX, side by side with archard.
peer: $(program)
	@scripts/setup peer
	OPENBLAS_NUM_THREADS=1 $(program) scripts/tools/peer.lua

# The paper's study. What an older program computed is not gone on with.
study figures: $(program)
	@for file in $(BUILD)/study.archard $(BUILD)/study-*.archard; do \
	  [ ! $$file -ot $(program) ] || rm -f $$file; done
	$(program) examples/paper/study20.lua --file $(BUILD)/study.archard --figures $(BUILD)/figures \
	  $(if $(filter figures,$@),--fine --converge)

# --- care -------------------------------------------------------------------------------------
c_files = $(wildcard include/*.h include/archard/*.h src/*/*.[ch] src/*/*/*.[ch] tests/unit/*.[ch] tests/fuzz/*.[ch] tests/memory/*.c tests/trust/*.c examples/c/*.c)
sh_files = scripts/setup scripts/probe scripts/slurm/node scripts/deb/package scripts/deb/check scripts/deb/readme scripts/deb/root tests/run tests/fuzz/run tests/trust/trials tests/trust/escapes tests/memory/failing tests/memory/valgrind tests/coverage \
           .ci/run tests/tap.bash $(shell grep -l '^\#!.*bash' tests/cli/* tests/guard/*)

format:
	@clang-format -i $(c_files)

lint:
	@clang-format --dry-run --Werror $(c_files)
	@cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr \
	  --error-exitcode=1 --suppress=missingIncludeSystem -Iinclude -Isrc src $(filter examples/%,$(c_files))
	@shellcheck -S warning $(sh_files)
	@mandoc -T lint -W warning man/archard.1

# What stands behind the library, for archard.pc: by .pc file where there is one.
private      = cholmod blas sqlite fftw omp
requires     = $(strip $(foreach p,$(private),$($(p)_pc)))
private_libs = $(strip $(foreach p,$(private),$(if $($(p)_pc),,$($(p)_libs)))) -lm

# The loader finds a new library in its cache only, which ldconfig fills from the folders that it knows.
install: all
	@$(MAKE) --no-print-directory install-files
	@if [ -n $(call quoted,$(DESTDIR)) ]; then :; \
	elif PATH=$$PATH:/sbin:/usr/sbin; [ "$$(id -u)" = 0 ] && ldconfig 2>/dev/null && \
	  ldconfig -p | grep -qF $(call quoted,=> $(LIBDIR)/$(soname)); then :; \
	else printf '%s\n' $(call quoted,Programs find $(soname) after: sudo ldconfig "$(LIBDIR)"); fi

# What is there, without building it.
to     = $(call quoted,$(DESTDIR)$(1))
man_pages   = man/archard.1 $(made_pages)
man_folder  = $(MANDIR)/man$(subst .,,$(suffix $(1)))
documents   = README.md CHANGELOG.md SECURITY.md LICENSE man/theory.md man/accuracy.md man/constants.md man/speed.md CITATION.cff
below       = $(subst $(PREFIX)/,$${prefix}/,$(1))
install-files:
	install -d $(call to,$(BINDIR)) $(call to,$(LIBDIR)/pkgconfig) $(call to,$(INCLUDEDIR)/archard) $(call to,$(LUADIR)) \
	  $(call to,$(BASHDIR)) $(call to,$(ZSHDIR)) $(call to,$(DATADIR)/archard/examples/c) $(call to,$(DATADIR)/archard/examples/paper) $(call to,$(DOCDIR)) \
	  $(foreach m,$(man_pages),$(call to,$(call man_folder,$(m))))
	install -m 755 $(program) $(call to,$(BINDIR)/archard)
	install -m 644 $(static_lib) $(call to,$(LIBDIR)/libarchard.a)
	install -m 755 $(shared_lib) $(call to,$(LIBDIR)/)
	ln -sf $(notdir $(shared_lib)) $(call to,$(LIBDIR)/$(soname))
	ln -sf $(soname) $(call to,$(LIBDIR)/libarchard.so)
	install -m 755 $(lua_module) $(call to,$(LUADIR)/archard.so)
	install -m 644 include/archard.h $(call to,$(INCLUDEDIR)/)
	install -m 644 include/archard/*.h $(call to,$(INCLUDEDIR)/archard/)
	$(foreach m,$(man_pages),install -m 644 $(m) $(call to,$(call man_folder,$(m))/) &&) :
	install -m 644 scripts/completion/archard.bash $(call to,$(BASHDIR)/archard)
	install -m 644 scripts/completion/archard.zsh $(call to,$(ZSHDIR)/_archard)
	install -m 644 examples/*.lua examples/*.csv examples/*.sdf examples/*.geo examples/*.msh $(call to,$(DATADIR)/archard/examples/)
	install -m 644 examples/c/*.c $(call to,$(DATADIR)/archard/examples/c/)
	install -m 644 examples/paper/*.lua $(call to,$(DATADIR)/archard/examples/paper/)
	install -m 644 $(documents) $(call to,$(DOCDIR)/)
	printf '%s\n' $(call quoted,prefix=$(PREFIX)) $(call quoted,libdir=$(call below,$(LIBDIR))) \
	  $(call quoted,includedir=$(call below,$(INCLUDEDIR))) '' \
	  'Name: archard' 'Description: sliding wear by finite elements' 'Version: $(version)' \
	  'Cflags: -I"$${includedir}"' 'Libs: -L"$${libdir}" -larchard -lm' \
	  'Requires.private: $(requires)' 'Libs.private: $(private_libs)' \
	  > $(call to,$(LIBDIR)/pkgconfig/archard.pc)

uninstall:
	rm -f $(call to,$(BINDIR)/archard) $(call to,$(LUADIR)/archard.so) $(call to,$(BASHDIR)/archard) \
	  $(call to,$(ZSHDIR)/_archard) $(foreach m,$(man_pages),$(call to,$(call man_folder,$(m))/$(notdir $(m)))) \
	  $(foreach f,libarchard.a libarchard.so $(soname) $(notdir $(shared_lib)) pkgconfig/archard.pc,$(call to,$(LIBDIR)/$(f))) \
	  $(foreach f,$(documents),$(call to,$(DOCDIR)/$(notdir $(f))))
	rm -rf $(call to,$(INCLUDEDIR)/archard.h) $(call to,$(INCLUDEDIR)/archard) $(call to,$(DATADIR)/archard)
	@rmdir $(call to,$(DOCDIR)) 2>/dev/null || :

# --- to hand on -------------------------------------------------------------------------------
# A tarball of what git knows, as it stands here: the same files, the same bytes.
tarball = $(BUILD)/archard-$(version).tar.gz
dist:
	@mkdir -p $(BUILD)
	git ls-files -z | tar --create --null --files-from=- --sort=name --owner=0 --group=0 --numeric-owner \
	  --mtime="$$(git log -1 --format=%cI)" --transform='s,^,archard-$(version)/,S' | gzip -9n > $(tarball)

# It builds and runs where there is nothing else.
dist-check: dist
	rm -rf $(BUILD)/dist && mkdir -p $(BUILD)/dist && tar -xzf $(tarball) -C $(BUILD)/dist
	$(MAKE) -C $(BUILD)/dist/archard-$(version) all
	cd $(BUILD)/dist/archard-$(version) && tests/run tests/guard/test_installed

# A Debian package for this machine's release, and a trial of it in a clean root of that release.
deb_file = $(BUILD)/archard_$(version)_$(shell dpkg --print-architecture).deb
deb: all
	@scripts/setup deb
	rm -rf $(BUILD)/deb
	@$(MAKE) --no-print-directory install-files DESTDIR=$(BUILD)/deb/root PREFIX=/usr \
	  LIBDIR=/usr/lib/$$(dpkg-architecture -qDEB_HOST_MULTIARCH) ZSHDIR=/usr/share/zsh/vendor-completions
	MAINTAINER='$(MAINTAINER)' scripts/deb/package $(BUILD)/deb $(version) $(deb_file)
	@echo
	@echo 'Install it by: apt install --no-install-recommends ./$(deb_file)'

deb-check: deb
	@scripts/setup root
	scripts/deb/check $(deb_file) $(BUILD)

# The README's commands, as printed, on a root that has git, make and gcc.
readme-check:
	@mkdir -p $(BUILD)
	scripts/deb/readme $(BUILD)

# A study of CASES cases through a Slurm of one node, begun and ended here, beside a local run.
slurm-check: $(program)
	@scripts/setup slurm
	scripts/slurm/node $(program) scripts/tools/slurm_check.lua $(or $(CASES),10000)

clean:
	rm -rf build build-*
