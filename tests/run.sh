#!/bin/bash
# tests/run.sh [unit] [seeds] [cases] [suites]: run kinds of tests and add them up.
#
# Every test program and script ends in a line "N passed, N failed" or
# "N passed, N failed, N skipped" on standard output and says on standard error
# what failed. One that ends otherwise, or with a status that does not fit its
# line, counts as one failure more.
#
# BUILD names the build folder. The scripts of tests/suites/ find the programs
# on PATH, and the folders in ROOT, BUILD and SAMPLES.
set -u

ROOT=$(cd "$(dirname "$0")/.." && pwd)
BUILD=${BUILD:-$ROOT/build/release}
SAMPLES=$ROOT/samples
PATH=$BUILD/bin:$PATH
export ROOT BUILD SAMPLES PATH LC_ALL=C

all_passed=0
all_failed=0
all_skipped=0
out=$(mktemp) || exit 1
trap 'rm -f "$out"' EXIT

tally='^([0-9]+) passed, ([0-9]+) failed(, ([0-9]+) skipped)?$'

# run_one NAME COMMAND...
run_one() {
	local name=$1 status last passed=0 failed=0 skipped=0 start=$SECONDS
	shift
	"$@" >"$out" </dev/null
	status=$?
	last=$(tail -n 1 "$out")
	if [[ $last =~ $tally ]]; then
		passed=${BASH_REMATCH[1]}
		failed=${BASH_REMATCH[2]}
		skipped=${BASH_REMATCH[4]:-0}
	fi
	if ! [[ $last =~ $tally ]] || ((status != 0 && failed == 0)) ||
		((status == 0 && failed != 0)); then
		echo "$name: ended with status $status and \"$last\"" >&2
		failed=$((failed + 1))
	fi
	if ((failed)); then
		head -n -1 "$out" >&2
	fi
	printf '%-28s %5d passed, %d failed' "$name" "$passed" "$failed"
	((skipped)) && printf ', %d skipped' "$skipped"
	((SECONDS - start > 1)) && printf '  (%d s)' $((SECONDS - start))
	printf '\n'
	all_passed=$((all_passed + passed))
	all_failed=$((all_failed + failed))
	all_skipped=$((all_skipped + skipped))
}

run_unit() {
	local source name
	for source in "$ROOT"/tests/unit/*_test.c; do
		name=$(basename "$source" .c)
		run_one "unit/$name" timeout 600 "$BUILD/tests/unit/$name"
	done
}

# The seeds of every fuzz target, through it once.
run_seeds() {
	local source name
	for source in "$ROOT"/tests/fuzz/*_fuzz.c; do
		[[ -e $source ]] || continue
		name=$(basename "$source" _fuzz.c)
		shopt -s nullglob
		run_one "seeds/$name" timeout 600 \
			"$BUILD/tests/fuzz/${name}_fuzz" \
			"$ROOT/tests/fuzz/corpus/$name"/*
	done
}

run_suites() {
	local script
	for script in "$ROOT"/tests/suites/*.sh; do
		[[ -e $script ]] || continue
		run_one "suites/$(basename "$script" .sh)" \
			timeout 1200 "$script"
	done
}

cd "$ROOT" || exit 1
for kind in "${@:-unit}"; do
	case $kind in
	unit) run_unit ;;
	seeds) run_seeds ;;
	cases) run_one cases tests/run-cases.sh ;;
	suites) run_suites ;;
	*)
		echo "tests/run.sh: no such kind of test: $kind" >&2
		exit 2
		;;
	esac
done

echo
printf '%d passed, %d failed' "$all_passed" "$all_failed"
((all_skipped)) && printf ', %d skipped' "$all_skipped"
printf '\n'
((all_failed == 0))
