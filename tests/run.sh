#!/bin/bash
# tests/run.sh [suites] [cases] [seeds] [unit]: run kinds of tests and add them
# up, as many at once as there are processors (JOBS=1: one by one).
#
# Every test program and script ends in a line "N passed, N failed" or
# "N passed, N failed, N skipped" on standard output and says on standard error
# what failed. One that ends otherwise, or with a status that does not fit its
# line, counts as one failure more. Where it takes longer, the seconds stand
# behind it, and those of processor time.
#
# BUILD names the build folder. The scripts of tests/suites/ find the programs
# on PATH, and the folders in ROOT, BUILD and SAMPLES.
set -u

ROOT=$(cd "$(dirname "$0")/.." && pwd)
BUILD=${BUILD:-$ROOT/build/release}
SAMPLES=$ROOT/samples
PATH=$BUILD/bin:$PATH
export ROOT BUILD SAMPLES PATH LC_ALL=C

jobs=${JOBS:-$(nproc)}
all_passed=0
all_failed=0
all_skipped=0
names=()
commands=()
scratch=$(mktemp -d) || exit 1
trap 'kill $(jobs -p) 2>/dev/null; wait; rm -rf "$scratch"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

tally='^([0-9]+) passed, ([0-9]+) failed(, ([0-9]+) skipped)?$'

# queue NAME COMMAND...
queue() {
	names+=("$1")
	shift
	commands+=("$(printf '%q ' "$@")")
}

# What has to be run, by kind.

queue_unit() {
	local source name
	for source in "$ROOT"/tests/unit/*_test.c; do
		name=$(basename "$source" .c)
		queue "unit/$name" timeout 600 "$BUILD/tests/unit/$name"
	done
}

# The seeds of every fuzz target, through it once.
queue_seeds() {
	local source name
	shopt -s nullglob
	for source in "$ROOT"/tests/fuzz/*_fuzz.c; do
		name=$(basename "$source" _fuzz.c)
		queue "seeds/$name" timeout 600 \
			"$BUILD/tests/fuzz/${name}_fuzz" \
			"$ROOT/tests/fuzz/corpus/$name"/*
	done
	shopt -u nullglob
}

queue_cases() {
	local folder name
	for folder in "$ROOT"/tests/cases/*/; do
		name=$(basename "$folder")
		queue "cases/$name" timeout 1200 tests/run-cases.sh "$name"
	done
}

queue_suites() {
	local script
	for script in "$ROOT"/tests/suites/*.sh; do
		queue "suites/$(basename "$script" .sh)" timeout 1200 "$script"
	done
}

# run_queued NUMBER: leaves NUMBER.out, .err, .time and, last, .status.
run_queued() {
	local child status out=$scratch/$1
	eval "exec ${commands[$1]}" >"$out.out" 2>"$out.err" </dev/null &
	child=$!
	trap 'kill "$child"; exit 143' INT TERM
	TIMEFORMAT='%0R %0U %0S'
	{ time wait "$child"; } 2>"$out.time"
	status=$?
	echo "$status" >"$out.ended"
	mv "$out.ended" "$out.status"
}

# Nothing runs any more, and still one has not ended: it was killed.
take_lost() {
	[[ -e $scratch/$told.status ]] && return
	echo 137 >"$scratch/$told.status"
	echo 0 0 0 >"$scratch/$told.time"
}

# tell NUMBER: what one that has ended passed and failed.
tell() {
	local status last real user system passed=0 failed=0 skipped=0
	read -r status <"$scratch/$1.status"
	last=$(tail -n 1 "$scratch/$1.out")
	cat "$scratch/$1.err" >&2
	if [[ $last =~ $tally ]]; then
		passed=${BASH_REMATCH[1]}
		failed=${BASH_REMATCH[2]}
		skipped=${BASH_REMATCH[4]:-0}
	fi
	if ! [[ $last =~ $tally ]] || ((status != 0 && failed == 0)) ||
		((status == 0 && failed != 0)); then
		echo "${names[$1]}: ended with status $status and \"$last\"" >&2
		failed=$((failed + 1))
	fi
	if ((failed)); then
		head -n -1 "$scratch/$1.out" >&2
	fi
	printf '%-28s %5d passed, %d failed' "${names[$1]}" "$passed" "$failed"
	((skipped)) && printf ', %d skipped' "$skipped"
	read -r real user system < <(tail -n 1 "$scratch/$1.time")
	((real > 1)) && printf '  (%d s, CPU %d s)' "$real" $((user + system))
	printf '\n'
	all_passed=$((all_passed + passed))
	all_failed=$((all_failed + failed))
	all_skipped=$((all_skipped + skipped))
}

# Those that have ended, up to the first that has not.
tell_ended() {
	while ((told < started)) && [[ -e $scratch/$told.status ]]; do
		tell "$told"
		told=$((told + 1))
	done
}

cd "$ROOT" || exit 1
for kind in "${@:-unit}"; do
	case $kind in
	unit | seeds | cases | suites) "queue_$kind" ;;
	*)
		echo "tests/run.sh: no such kind of test: $kind" >&2
		exit 2
		;;
	esac
done

started=0
told=0
while ((told < ${#names[@]})); do
	while ((started < ${#names[@]})) &&
		(($(jobs -pr | wc -l) < jobs)); do
		run_queued "$started" &
		started=$((started + 1))
	done
	wait -n
	(($? != 127)) || take_lost
	tell_ended
done

echo
printf '%d passed, %d failed' "$all_passed" "$all_failed"
((all_skipped)) && printf ', %d skipped' "$all_skipped"
printf '\n'
((all_failed == 0))
