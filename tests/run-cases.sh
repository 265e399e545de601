#!/bin/bash
# tests/run-cases.sh [--accept] [PROGRAM[/NAME]...]: the command-line cases.
#
# A case is a folder tests/cases/PROGRAM/NAME of these files:
#
#   cmd        run by bash in an empty folder, without standard input
#   expect     what it prints on standard output; nothing when absent
#   stderr     what it prints on standard error; nothing when absent
#   exit       its exit status; 0 when absent
#   tolerance  numbers of expect may differ by this much, absolutely or
#              relative to their size; exact when absent
#   needs      programs of ours, one a line, without which it is skipped
#
# In cmd, $SAMPLES is the folder of the samples and $CASE the case's own; in
# what it prints these paths are compared as those words. --accept rewrites
# the expectations of the cases that differ; read the diff.
set -u

ROOT=$(cd "$(dirname "$0")/.." && pwd)
BUILD=${BUILD:-$ROOT/build/release}
SAMPLES=$ROOT/samples
PATH=$BUILD/bin:$PATH
export ROOT BUILD SAMPLES PATH LC_ALL=C

accept=
if [[ ${1-} == --accept ]]; then
	accept=1
	shift
fi

passed=0
failed=0
skipped=0
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

name_paths() {
	sed -i -e "s|$CASE|\$CASE|g" -e "s|$SAMPLES|\$SAMPLES|g" \
		-e "s|$BUILD/bin|\$BIN|g" "$@"
}

# is_as EXPECTED ACTUAL: print how they differ.
is_as() {
	local expected=$1
	[[ -e $expected ]] || expected=/dev/null
	cmp -s "$expected" "$2" && return
	if [[ -e $CASE/tolerance && $(basename "$2") == expect ]]; then
		awk -v tolerance="$(cat "$CASE/tolerance")" \
			-f "$ROOT/tests/near.awk" "$expected" "$2" && return
	fi
	diff -a -u --label expected --label actual "$expected" "$2" | head -n 40
	return 1
}

# take FILE NEUTRAL: make FILE of the case what came out.
take() {
	if [[ $(cat "$scratch/out/$1") == "$2" ]]; then
		rm -f "$CASE/$1"
	else
		cp "$scratch/out/$1" "$CASE/$1"
	fi
}

lacks() {
	local program
	[[ -e $CASE/needs ]] || return 1
	while read -r program; do
		[[ -x $BUILD/bin/$program ]] || return 0
	done <"$CASE/needs"
	return 1
}

run_case() {
	local name=${CASE#"$ROOT"/tests/cases/} differs=0 file
	if ! [[ -x $BUILD/bin/${name%%/*} ]] || lacks; then
		skipped=$((skipped + 1))
		return
	fi
	rm -rf "$scratch/work" "$scratch/out"
	mkdir "$scratch/work" "$scratch/out"
	(cd "$scratch/work" && timeout 120 bash "$CASE/cmd") \
		>"$scratch/out/expect" 2>"$scratch/out/stderr" </dev/null
	echo $? >"$scratch/out/exit"
	name_paths "$scratch/out/expect" "$scratch/out/stderr"
	[[ -e $CASE/exit ]] || echo 0 >"$scratch/zero"
	for file in expect stderr exit; do
		local expected=$CASE/$file
		[[ $file == exit && ! -e $expected ]] && expected=$scratch/zero
		is_as "$expected" "$scratch/out/$file" >"$scratch/diff" &&
			continue
		differs=1
		[[ $accept ]] && continue
		echo "$name: $file is not as expected:" >&2
		cat "$scratch/diff" >&2
	done
	if ((differs)) && [[ $accept ]]; then
		take expect ''
		take stderr ''
		take exit 0
		echo "accepted $name"
	elif ((differs)); then
		failed=$((failed + 1))
		return
	fi
	passed=$((passed + 1))
}

(($#)) || set -- ''
for pattern; do
	found=
	for CASE in "$ROOT"/tests/cases/*/*; do
		name=${CASE#"$ROOT"/tests/cases/}
		[[ -e $CASE/cmd ]] || continue
		[[ ! $pattern || $name == "$pattern" ||
			$name == "$pattern"/* ]] || continue
		found=1
		export CASE
		run_case
	done
	[[ $found || ! $pattern ]] || echo "no such case: $pattern" >&2
done

printf '%d passed, %d failed' $passed $failed
((skipped)) && printf ', %d skipped' $skipped
printf '\n'
((failed == 0))
