#!/bin/bash
# tests/fuzz/run.sh SECONDS [NAME...]: fuzz each target, or those named, for so
# many seconds. Seeds come from tests/fuzz/corpus/NAME; what is found on the
# way stays under BUILD/corpus/NAME, and inputs that break it, under
# BUILD/found/NAME-*. Stops at the first that breaks.
set -eu

cd "$(dirname "$0")/../.."
seconds=$1
shift
if (($# == 0)); then
	for source in tests/fuzz/*_fuzz.c; do
		name=${source##*/}
		set -- "$@" "${name%_fuzz.c}"
	done
fi

mkdir -p "$BUILD/found"
for name; do
	echo "== $name, $seconds s"
	mkdir -p "$BUILD/corpus/$name"
	folders=("$BUILD/corpus/$name")
	[[ -d tests/fuzz/corpus/$name ]] &&
		folders+=("tests/fuzz/corpus/$name")
	dictionary=()
	[[ -e tests/fuzz/$name.dict ]] &&
		dictionary=("-dict=tests/fuzz/$name.dict")
	"$BUILD/fuzz/$name" "-max_total_time=$seconds" -timeout=20 \
		-rss_limit_mb=2048 -print_final_stats=1 "${dictionary[@]}" \
		"-artifact_prefix=$BUILD/found/$name-" "${folders[@]}"
done
