#!/bin/bash
# tests/lint.sh [--sources]: what must hold of the tree itself, each rule a
# function named as a sentence. `make lint` runs it; --sources lists the files
# that clang-format is for. QUICK=1: clang reads the sources, in place of the
# builds and of cppcheck.
set -u

cd "$(dirname "$0")/.." || exit 1
# shellcheck source=tests/check.sh
. tests/check.sh
root=$PWD

# ours GLOB...: the files of the project that match, tracked or about to be.
ours() {
	git -C "$root" ls-files -z --cached --others --exclude-standard -- "$@" |
		while IFS= read -r -d '' file; do
			[[ -f $root/$file ]] && printf '%s\n' "$file"
		done
}

if [[ ${1-} == --sources ]]; then
	ours '*.c' '*.h' '*.cpp'
	exit
fi

mapfile -t sources < <(ours '*.c' '*.h' '*.cpp')
mapfile -t scripts < <(ours '*.sh' .ci/run)
mapfile -t pages < <(ours '*.1' '*.5')

formatting_is_clang_formats() {
	cd "$root"
	clang-format --dry-run -Werror "${sources[@]}" 2>&1 | grep error: |
		cut -d: -f1 | sort | uniq -c >"$tests_folder/unformatted" || :
	cat "$tests_folder/unformatted"
	[[ ! -s $tests_folder/unformatted ]]
}

# parsers/, simplify/ and writers/ see themselves and lib/; lib/ itself.
folders_include_only_lib_and_themselves() {
	cd "$root"
	python3 tests/lint_sources.py includes "${sources[@]}"
}

functions_and_files_are_short() {
	cd "$root"
	python3 tests/lint_sources.py sizes "${sources[@]}"
}

file_names_are_unique_and_say_something() {
	local names
	cd "$root"
	names=$(printf '%s\n' "${sources[@]##*/}")
	is "$(sort <<<"$names" | uniq -d)" ''
	silent grep -E '^(utils?|common|helpers?|misc|manager)\.' <<<"$names"
}

man_pages_are_well_formed() {
	cd "$root"
	((${#pages[@]} == 0)) || mandoc -T lint -W warning "${pages[@]}"
}

# The options of --help and of the page; the sections every page has.
man_pages_agree_with_help() {
	local program name page section bad=0
	cd "$root"
	for program in "$BUILD"/bin/*; do
		name=${program##*/}
		page=$(printf '%s\n' "${pages[@]}" | grep "\(^\|/\)$name\.1$") || {
			echo "$name has no man page"
			bad=1
			continue
		}
		diff -u --label "$name --help" --label "$page" \
			<("$program" --help | options_of_help) \
			<(options_of_page "$page") || bad=1
		for section in 'EXIT STATUS' EXAMPLES; do
			grep -q "^\.Sh $section\$" "$page" && continue
			echo "$page lacks $section"
			bad=1
		done
	done
	return "$bad"
}

options_of_help() {
	grep -oE '^  ( *-[A-Za-z],)? *--[a-z0-9-]+' | tr -d ' ' | sort -u
}

# ".It Fl o , Fl -output Ar FILE" is "-o,--output", and ".It Fl -help , Fl
# -version" is two options.
options_of_page() {
	sed -n -E 's/^\.It Fl (.) , Fl -([a-z0-9-]+).*/-\1,--\2/p
		s/^\.It Fl -([a-z0-9-]+) , Fl -([a-z0-9-]+).*/--\1\n--\2/p; t
		s/^\.It Fl -([a-z0-9-]+).*/--\1/p' "$1" | sort -u
}

scripts_pass_shellcheck() {
	cd "$root"
	# SC2317: tests are called by name, which it cannot see.
	shellcheck -x -e SC2317 "${scripts[@]}"
}

nothing_names_a_machine_or_a_registry() {
	local files
	cd "$root"
	mapfile -t files < <(ours '*' ':!tests/lint.sh')
	silent grep -n -I -E '(^|[^A-Za-z0-9._$}-])/(work|home|root|Users)/' \
		"${files[@]}"
	silent grep -n -I -E 'registry\.(npmjs|yarnpkg)|npmjs\.org' "${files[@]}"
	mapfile -t files < <(ours '*package-lock.json' '*.lock')
	((${#files[@]} == 0)) || silent grep -n '"resolved"' "${files[@]}"
}

nothing_is_left_undone() {
	local files
	cd "$root"
	mapfile -t files < <(ours '*' ':!tests/lint.sh')
	silent grep -n -I -w -E 'TODO|FIXME|XXX|HACK' "${files[@]}"
}

# it_builds_without_a_warning CC FOLDER FLAG [TARGET]
it_builds_without_a_warning() {
	cd "$root"
	make -s -j"$(nproc)" WERROR=1 CC="$1" build="$2" CFLAGS="$3" \
		CXXFLAGS="$3" "${4:-lint-build}" \
		>"$tests_folder/build.log" 2>&1 || {
		tail -n 40 "$tests_folder/build.log"
		return 1
	}
}

cppcheck_finds_nothing() {
	local files
	cd "$root"
	mapfile -t files < <(ours '*.c' ':!tests/fuzz' ':!tests/unit')
	cppcheck --quiet --std=c11 --error-exitcode=1 --inline-suppr -j"$(nproc)" \
		--enable=warning,portability --suppress=missingIncludeSystem \
		--suppress=normalCheckLevelMaxBranches \
		--suppress=identicalInnerCondition \
		--suppress=arrayIndexOutOfBoundsCond \
		--template='{file}:{line}: {id}: {message}' -Ilib \
		--library=posix "${files[@]}"
}

export BUILD=${BUILD:-$root/build/release}
run_test formatting_is_clang_formats
run_test folders_include_only_lib_and_themselves
run_test functions_and_files_are_short
run_test file_names_are_unique_and_say_something
run_test man_pages_are_well_formed
run_test man_pages_agree_with_help
run_test scripts_pass_shellcheck
run_test nothing_names_a_machine_or_a_registry
run_test nothing_is_left_undone
if [[ ${QUICK-} ]]; then
	run_test it_builds_without_a_warning clang "$tests_folder/clang" \
		-fsyntax-only lint-syntax
else
	run_test cppcheck_finds_nothing
	# What was built with WERROR=1 need not be built again.
	gcc=$tests_folder/gcc
	[[ ! ${WERROR-} || ${BUILD##*/} != release ]] || gcc=${BUILD#"$root"/}
	run_test it_builds_without_a_warning gcc "$gcc" ''
	rm -rf "$tests_folder/gcc"
	# Its warnings do not depend on what it optimises.
	run_test it_builds_without_a_warning clang "$tests_folder/clang" -O0
fi
finish
